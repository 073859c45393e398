# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that mark and clear seams, wires and allowances of selected edges, and that set the scene's unit."""

import math
from collections.abc import Callable

import bmesh
import bpy
from bpy.props import BoolProperty, EnumProperty

from ..blender.attributes import check_attribute
from ..blender.mesh import selected_edges
from ..blender.objects import height_of, meters_per_blender_unit
from ..blender.selection import hold_whole_file, in_object_mode
from ..core import counted, quoted
from ..issues import object_error
from ..names import ALLOWANCE
from ..state.allowances import NONE, SIDE_ALLOWANCES, mark_edges, mark_sides, scale_lengths
from ..state.owners import check_not_edited, model_of, model_or_self
from ..state.settings import in_percent, number
from ..ui.editing import OnMesh, OnModel, change_edited, reporting_refusals
from .mark import plan_clear, plan_wires, seams_from_uv, selected_sides

KINDS = [
    ("RIGID", "Rigid", "A rigid wire is exactly as long as on the model"),
    ("ELASTIC", "Elastic", "An elastic wire may become longer or shorter, up to the tolerance"),
    ("SUPER_ELASTIC", "Free", "A free wire gets the length that distorts the pieces least"),
]
ALLOWANCES = [
    ("WIDTH", "Allowance", "Set another seam allowance for the selected edges, on all sides"),
    ("HEM", "Hem", "Set a hem, an allowance that is turned up, for the selected edges of the outline"),
    ("FOLD", "Fold", "Set no allowance for the selected edges, because they are cut on the fold or stay raw"),
    ("DEFAULT", "Default", "Use the default allowance for the selected edges again"),
]
DESCRIPTIONS = {identifier: description for identifier, _, description in KINDS}


class WireKind:
    kind: EnumProperty(name="Kind", description="How strictly the wire keeps its length", items=KINDS, default="RIGID")
    tolerance: number(
        "Tolerance",
        "Elastic wires: how much the total length may change, as a fraction (0.03 is 3%)",
        (0.0, 0.03, 0.2, 0.99),
        precision=4,
        step=1,
    )
    tolerance_percent: number(
        "Tolerance ±",
        "Elastic wires: how much longer or shorter the whole wire may become, in percent",
        (0.0, 0.0, 20.0, 99.0),
        **in_percent("tolerance"),
    )

    def chosen_tolerance(self) -> float:
        """Return the tolerance to store on the edges. Raises ObjectError if an elastic wire has no tolerance."""
        if self.kind == "ELASTIC" and not self.tolerance > 0:  # also refuses NaN, which a script may pass
            sentence = "An elastic wire needs a tolerance above 0. Set a tolerance, or make the wire rigid."
            raise object_error("no_tolerance", sentence)
        return {"RIGID": 0.0, "ELASTIC": self.tolerance, "SUPER_ELASTIC": math.inf}[self.kind]

    def draw_kind(self, layout: bpy.types.UILayout) -> None:
        layout.prop(self, "kind")
        if self.kind == "ELASTIC":
            layout.prop(self, "tolerance_percent")


class MESH_OT_wirewarp_mark(OnModel, WireKind, bpy.types.Operator):
    """Turn the selected edges into wires, one for each line"""

    bl_idname = "mesh.wirewarp_mark"
    bl_label = "Mark Wire"
    bl_options = {"REGISTER", "UNDO"}
    on_model = "mark the wire"

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        return f"Turn the selected edges into wires, one for each line. {DESCRIPTIONS[properties.kind]}"

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        if not self.properties.is_property_set("tolerance"):
            self.tolerance = context.scene.wirewarp.tolerance_percent / 100
        return self.execute(context)

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        tolerance = self.chosen_tolerance()
        marked = change_edited(context, lambda target: plan_wires(target, tolerance))
        wires, lost_eases = sum(each.wires for each in marked), sum(each.lost_eases for each in marked)
        if wires == 0:
            raise object_error("nothing", "Nothing to mark: select the edges of the wire first.")
        hold_whole_file()
        sentence = f"{counted(wires, 'wire')} marked"
        if lost_eases:
            lost = counted(lost_eases, "wire")
            self.report({"WARNING"}, f"{sentence}. {lost} had several eases, which were removed. Mark the ease again.")
        else:
            self.report({"INFO"}, sentence)
        return {"FINISHED"}

    def draw(self, _context: bpy.types.Context) -> None:
        self.layout.use_property_split = True
        self.draw_kind(self.layout)


class MESH_OT_wirewarp_clear(OnModel, bpy.types.Operator):
    """Remove wires from the selected edges"""

    bl_idname = "mesh.wirewarp_clear"
    bl_label = "Clear Wire"
    bl_options = {"REGISTER", "UNDO"}
    on_model = "clear the wire"

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        if not sum(change_edited(context, plan_clear)):
            self.report({"WARNING"}, "No selected edge is a wire")
            return {"CANCELLED"}
        hold_whole_file()
        return {"FINISHED"}


class MESH_OT_wirewarp_allowance(bpy.types.Operator):
    """Set the seam allowance of the selected edges on seams and outlines. On flat pieces, set it for one side only"""

    bl_idname = "mesh.wirewarp_allowance"
    bl_label = "Mark Allowance"
    bl_options = {"REGISTER", "UNDO"}

    kind: EnumProperty(name="Kind", description="Allowance to set", items=ALLOWANCES, default="WIDTH")
    width: number("Width (mm)", "Width of the seam allowance", (0.1, 10.0, 50.0, 1000.0), step=100, precision=2)
    hem: number("Hem (mm)", "Width of the hem, which is turned up", (0.1, 30.0, 100.0, 1000.0), step=100, precision=2)

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        return next(description for kind, _, description in ALLOWANCES if kind == properties.kind)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return context.mode == "EDIT_MESH"

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        millimeters = 1000 * meters_per_blender_unit(context.scene)
        widths = {"WIDTH": self.width / millimeters, "HEM": self.hem / millimeters, "FOLD": NONE, "DEFAULT": 0.0}
        counts = change_edited(context, lambda target: _plan_allowance(target, widths[self.kind]))
        count, left_out = sum(marked for marked, _ in counts), sum(ignored for _, ignored in counts)
        if count == 0:
            raise object_error("nothing", "Nothing to mark: select edges on a seam or outline first.")
        hold_whole_file()
        done = f"{counted(count, 'edge')} marked: {self._allowance()}"
        if left_out:
            are = counted(left_out, "selected edge is", "selected edges are")
            self.report({"WARNING"}, f"{done}. {are} inside a piece, so no allowance was marked there.")
        else:
            self.report({"INFO"}, done)
        return {"FINISHED"}

    def _allowance(self) -> str:
        return {
            "WIDTH": f"allowance of {self.width:g} mm",
            "HEM": f"hem of {self.hem:g} mm",
            "FOLD": "fold, without allowance",
            "DEFAULT": "default allowance",
        }[self.kind]

    def draw(self, _context: bpy.types.Context) -> None:
        self.layout.use_property_split = True
        self.layout.prop(self, "kind")
        if self.kind in {"WIDTH", "HEM"}:
            self.layout.prop(self, self.kind.lower())


def _plan_allowance(target: bpy.types.Object, width: float) -> Callable[[], tuple[int, int]]:
    """Plan allowances, on all sides for a model, and on one side for flat pieces. The plan returns the numbers of
    marked and ignored edges."""
    sides = selected_sides(target) if model_of(target) else None
    mesh = sides.model.data if sides else target.data
    check_attribute(mesh, ALLOWANCE)
    SIDE_ALLOWANCES.check_attributes(mesh)

    def write() -> tuple[int, int]:
        if sides:
            count, marked = len(sides.edges) + sides.left_out, mark_sides(mesh, sides.corners, width)
        else:
            rows = selected_edges(mesh)
            count, marked = len(rows), mark_edges(mesh, rows, width)
        mesh.update()
        return marked, count - marked

    return write


class MESH_OT_wirewarp_seams_from_uv_islands(OnModel, bpy.types.Operator):
    """Mark seams along the island borders of the active UV map, or of your own map if WireWarp's map is active"""

    bl_idname = "mesh.wirewarp_seams_from_uv_islands"
    bl_label = "Seams from UV Islands"
    bl_options = {"REGISTER", "UNDO"}
    on_model = "mark seams"

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        targets = list(context.objects_in_mode_unique_data)
        with in_object_mode(context):
            count, maps = seams_from_uv(targets)
        named = f"{'UV map' if len(maps) == 1 else 'UV maps'} {quoted(maps)}"
        if count == 0:
            self.report({"INFO"}, f"No new seams: every island border of the {named} is a seam already")
            return {"CANCELLED"}
        self.report({"INFO"}, f"{counted(count, 'edge')} marked as seam, from the {named}")
        return {"FINISHED"}


WIDTH = 360  # width of the dialog, in pixels at interface scale 1; its question is about 275 wide, beside an icon


def has_every_edge(mesh: bpy.types.Mesh) -> bool:
    """Return whether all edges of a mesh in Edit Mode are selected, as in a newly imported model."""
    edges = bmesh.from_edit_mesh(mesh).edges
    return len(edges) > 0 and all(edge.select for edge in edges)


def _deselect(mesh: bpy.types.Mesh) -> None:
    edit = bmesh.from_edit_mesh(mesh)
    for elements in (edit.faces, edit.edges, edit.verts):
        for element in elements:
            element.select = False
    edit.select_flush(False)
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


class OBJECT_OT_wirewarp_mark_model(bpy.types.Operator):
    """Enter Edit Mode to select edges and mark them as seams and wires. If all edges are selected, deselect them"""

    bl_idname = "object.wirewarp_mark_model"
    bl_label = "Mark This Model"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        if active is None or active.type != "MESH" or context.mode != "OBJECT":
            return False
        if active.library or active.data.library or active.override_library:
            cls.poll_message_set("Linked data cannot be edited. Use Object > Relations > Make Local first")
            return False
        return active.visible_get()

    def execute(self, context: bpy.types.Context) -> set[str]:
        bpy.ops.object.mode_set(mode="EDIT")
        context.tool_settings.mesh_select_mode = (False, True, False)
        for mesh in (each.data for each in context.objects_in_mode_unique_data):
            if has_every_edge(mesh):
                _deselect(mesh)
        return {"FINISHED"}


class MESH_OT_wirewarp_mark_seam(OnModel, bpy.types.Operator):
    """Mark the selected edges as seams, or clear their seams. Ask first if every edge is selected"""

    bl_idname = "mesh.wirewarp_mark_seam"
    bl_label = "Mark Seam"
    bl_options = {"INTERNAL", "REGISTER", "UNDO"}
    on_model = "mark seams"
    _asks = False

    clear: BoolProperty(name="Clear", description="Clear seams", default=False, options={"HIDDEN"})

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        if properties.clear:
            return "Clear the seams of the selected edges"
        return "Mark the selected edges as seams, along which the fabric is cut"

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        if not self.clear and any(has_every_edge(each.data) for each in context.objects_in_mode_unique_data):
            self._asks = True
            return context.window_manager.invoke_props_dialog(self, width=WIDTH)
        return self.execute(context)

    def draw(self, _context: bpy.types.Context) -> None:
        """Draw the question in the dialog, and nothing in the redo panel."""
        if self._asks:
            self.layout.label(text="Every edge is selected. Cut the fabric along all of them?", icon="QUESTION")

    def execute(self, _context: bpy.types.Context) -> set[str]:
        self._asks = False
        return bpy.ops.mesh.mark_seam(clear=self.clear)


class SCENE_OT_wirewarp_set_unit(bpy.types.Operator):
    """Use this unit for all lengths of this scene. Nothing moves in the view"""

    bl_idname = "scene.wirewarp_set_unit"
    bl_label = "Set Unit"
    bl_options = {"REGISTER", "UNDO"}

    meters: number("Unit", "Meters in one Blender unit", (1e-6, 0.01, 1e6, 1e6), precision=2)

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        _set_unit(context, self.meters)
        return {"FINISHED"}


class SCENE_OT_wirewarp_set_height(OnMesh, bpy.types.Operator):
    """Enter the real height of the model. The unit of this scene follows from it, and nothing moves in the view"""

    bl_idname = "scene.wirewarp_set_height"
    bl_label = "Set Model Height"
    bl_options = {"REGISTER", "UNDO"}

    height: number(
        "Model Height (cm)",
        "Real height of the model, from its lowest to its highest point",
        (1e-4, 100.0, 300.0, 1e6),
        step=100,
    )

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        own = height_of(model_or_self(context.active_object))
        if own > 0:
            self.height = 100 * meters_per_blender_unit(context.scene) * own
        return context.window_manager.invoke_props_dialog(self)

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        source = model_or_self(context.active_object)
        own = height_of(source)
        if own == 0:
            raise object_error("flat", f'"{source.name}" is flat and has no height. Set the unit instead.')
        _set_unit(context, self.height / 100 / own)
        return {"FINISHED"}


def _set_unit(context: bpy.types.Context, meters: float) -> None:
    """Set the length of a Blender unit in meters. Marked lengths and Max Length stay the same in millimeters. Raises
    ObjectError like _keep_lengths."""
    scene, settings = context.scene, context.scene.unit_settings
    before = meters_per_blender_unit(scene)
    with in_object_mode(context):
        _keep_lengths(scene, before / meters)
    scene.wirewarp.aim_length *= before / meters
    if settings.system == "NONE":
        settings.system = "METRIC"
    settings.scale_length = meters
    hold_whole_file()


def _keep_lengths(scene: bpy.types.Scene, factor: float) -> None:
    """Multiply the marked lengths, which are in Blender units, by this factor. Raises ObjectError, before any change,
    if a mesh is in Edit Mode in another scene or view layer."""
    models = [each for each in scene.objects if each.type == "MESH" and each.data.library is None]
    for model in models:
        check_not_edited(model)
    for mesh in {model.data for model in models}:
        scale_lengths(mesh, factor)
