# SPDX-License-Identifier: GPL-3.0-or-later
"""What a Blender unit means."""

import bpy
from bpy.props import FloatProperty

from ..blender.modes import hold_whole_file, in_object_mode
from ..blender.units import meters_per_blender_unit
from ..state.allowances import scale_lengths
from ..state.owners import check_not_edited
from ..ui.editing import reporting_refusals


class SCENE_OT_wirewarp_set_unit(bpy.types.Operator):
    """Use this unit for all lengths of this scene. Nothing moves in the view"""

    bl_idname = "scene.wirewarp_set_unit"
    bl_label = "Set Unit"
    bl_options = {"REGISTER", "UNDO"}

    meters: FloatProperty(name="Unit", description="Meters in one Blender unit", min=1e-6, max=1e6, default=0.01)

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        scene, settings = context.scene, context.scene.unit_settings
        before = meters_per_blender_unit(scene)
        with in_object_mode(context):
            _keep_lengths(scene, before / self.meters)
        if settings.system == "NONE":
            settings.system = "METRIC"
        settings.scale_length = self.meters
        hold_whole_file()
        return {"FINISHED"}


def _keep_lengths(scene: bpy.types.Scene, factor: float) -> None:
    """What is marked on the models stays as wide, in Blender units so many times. Raises ObjectError before any is."""
    models = [each for each in scene.objects if each.type == "MESH" and each.data.library is None]
    for model in models:
        check_not_edited(model)
    for mesh in {model.data for model in models}:
        scale_lengths(mesh, factor)


CLASSES = (SCENE_OT_wirewarp_set_unit,)
