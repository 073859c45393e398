# SPDX-License-Identifier: GPL-3.0-or-later
"""For a file without a model: a sample to try, and a guide of six steps."""

from importlib.resources import files
from pathlib import Path

import bpy
from bpy.props import EnumProperty
from mathutils import Vector

from ..blender.units import meters_per_blender_unit
from ..blender.views import show_objects, work_area
from ..state.settings import FlattenSettings

FOLDER = Path(str(files(__package__.rpartition(".")[0]))) / "samples"  # in the add-on's folder
SAMPLES = [  # files of that folder, the plainest first
    ("CUSHION", "Cushion", "Six pieces that any fabric can do"),
    ("FITTED_TOP", "Fitted Top", "Four pieces of jersey, with lines that keep their length"),
    ("JEANS", "Jeans", "Seven pieces of woven cotton"),
    ("CARNIVAL_MASK", "Carnival Mask", "One piece of leather with two holes"),
]
STEPS = (
    "1. Open a sample, or select your model and press Mark This Model.",
    "2. Select the edges where the fabric is cut, and press Mark Seam.",
    "    Alt+click selects a whole line of edges.",
    "3. Select lines that must keep their length, and press Rigid.",
    "4. Choose the fabric, and press Flatten.",
    "5. Read the sentence below Flatten. If it is not green, press a button below it.",
    "6. Press Export Pattern, and print at 100%.",
)
WIDTH = 480  # of the guide, in Blender's own pixels


class OBJECT_OT_wirewarp_open_sample(bpy.types.Operator):
    """Add a sample model with its seams and wires to this file; to an empty one with its settings and units, too"""

    bl_idname = "object.wirewarp_open_sample"
    bl_label = "Open Sample"
    bl_options = {"REGISTER", "UNDO"}

    sample: EnumProperty(name="Sample", description="Which model to add", items=SAMPLES)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return context.mode == "OBJECT" and context.scene.library is None

    def execute(self, context: bpy.types.Context) -> set[str]:
        scene, is_first = context.scene, not any(each.type == "MESH" for each in context.scene.objects)
        path = FOLDER / f"{self.sample.lower()}.blend"
        try:
            with bpy.data.libraries.load(str(path)) as (held, loaded):
                loaded.scenes = held.scenes
        except OSError:
            self.report({"ERROR"}, f'The sample "{path.name}" is not installed. Install the zip of WireWarp again.')
            return {"CANCELLED"}
        (sample_scene,) = loaded.scenes
        (model,) = sample_scene.objects
        if is_first:
            _take_settings(scene, sample_scene)
        else:
            model.scale /= meters_per_blender_unit(scene)  # samples are in meters
            model.location.x = _free_place(scene, model)
        context.collection.objects.link(model)
        bpy.data.scenes.remove(sample_scene)
        for other in context.selected_objects:
            other.select_set(False)
        context.view_layer.objects.active = model
        model.select_set(True)
        area = work_area(context)
        if area:
            context.view_layer.update()
            show_objects(context, area, [model])
        return {"FINISHED"}


def _free_place(scene: bpy.types.Scene, model: bpy.types.Object) -> float:
    """Where on the x axis it lies beside the meshes of the scene, with half its width between."""
    meshes = [each for each in scene.objects if each.type == "MESH"]
    right = max((each.matrix_world @ Vector(corner)).x for each in meshes for corner in each.bound_box)
    edges = [corner[0] * model.scale.x for corner in model.bound_box]
    return right - min(edges) + (max(edges) - min(edges)) / 2


def _take_settings(scene: bpy.types.Scene, sample: bpy.types.Scene) -> None:
    for name in FlattenSettings.__annotations__:
        setattr(scene.wirewarp, name, getattr(sample.wirewarp, name))
    for name in ("system", "scale_length", "length_unit"):
        setattr(scene.unit_settings, name, getattr(sample.unit_settings, name))


class WM_OT_wirewarp_guide(bpy.types.Operator):
    """Show the way from a model to a pattern in six steps"""

    bl_idname = "wm.wirewarp_guide"
    bl_label = "Guide"
    bl_options = {"INTERNAL"}

    def execute(self, _context: bpy.types.Context) -> set[str]:
        return {"FINISHED"}

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        return context.window_manager.invoke_popup(self, width=WIDTH)

    def draw(self, _context: bpy.types.Context) -> None:
        for step in STEPS:
            self.layout.label(text=step)


def draw_first_steps(layout: bpy.types.UILayout) -> None:
    layout.operator_menu_enum("object.wirewarp_open_sample", "sample", icon="FILE_FOLDER")
    layout.operator("wm.wirewarp_guide", icon="HELP")


CLASSES = (OBJECT_OT_wirewarp_open_sample, WM_OT_wirewarp_guide)
