# SPDX-License-Identifier: GPL-3.0-or-later
"""Marking and clearing seams and wires on the selected edges."""

import math
from collections.abc import Callable

import bpy
import numpy as np
from bpy.props import EnumProperty, FloatProperty

from ..blender.mesh import read_hidden_edges, read_selected_edges
from ..blender.modes import hold_whole_file, in_object_mode
from ..blender.objects import check_local
from ..blender.units import meters_per_blender_unit
from ..flat.sides import selected_sides
from ..issues import ObjectError
from ..model.allowances import NONE, check_allowances, mark_edges, mark_sides
from ..model.mark import clear_selected, mark_selected
from ..model.owners import model_of
from ..model.seams import seams_from_uv
from ..words import counted, quoted
from .on_model import OnModel

KINDS = [
    ("RIGID", "Rigid", "A rigid wire keeps exactly its length on the model"),
    ("ELASTIC", "Elastic", "An elastic wire may become longer or shorter, up to the tolerance"),
    ("SUPER_ELASTIC", "Free", "A free wire gets whatever length distorts the pieces least"),
]
ALLOWANCES = [
    ("WIDTH", "Allowance", "Give the selected edges a seam allowance of their own, on all sides"),
    ("HEM", "Hem", "Give the selected edges of the outline a hem: allowance that is turned up"),
    ("FOLD", "Fold", "No allowance at the selected edges: they are cut on the fold, or stay raw"),
    ("DEFAULT", "Default", "Give the selected edges the default allowance again"),
]
DESCRIPTIONS = {identifier: description for identifier, _, description in KINDS}
NEEDS_TOLERANCE = "An elastic wire needs a tolerance above 0: set one, or make the wire rigid."


class WireKind:
    """Mixed into operators."""

    kind: EnumProperty(name="Kind", description="How strictly the wire keeps its length", items=KINDS, default="RIGID")
    tolerance: FloatProperty(
        name="Tolerance",
        description="Elastic wires: how much the total length may change, as a fraction (0.03 is 3%)",
        min=0.0,
        soft_max=0.2,
        max=0.99,
        default=0.03,
        precision=4,
        step=1,
    )
    tolerance_percent: FloatProperty(
        name="Tolerance ±",
        description="Elastic wires: how much the total length may become longer or shorter, in percent",
        subtype="PERCENTAGE",
        min=0.0,
        soft_max=20.0,
        max=99.0,
        precision=2,
        get=lambda operator: 100 * operator.tolerance,
        set=lambda operator, percent: setattr(operator, "tolerance", percent / 100),
        options={"SKIP_SAVE"},
    )

    def is_tolerance_missing(self) -> bool:
        return self.kind == "ELASTIC" and not self.tolerance > 0  # nor is it a number in every script

    def chosen_tolerance(self) -> float:
        """As the edges carry it."""
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

    def execute(self, context: bpy.types.Context) -> set[str]:
        if self.is_tolerance_missing():
            self.report({"ERROR"}, NEEDS_TOLERANCE)
            return {"CANCELLED"}
        try:
            marked = mark_selected(context.objects_in_mode_unique_data, self.chosen_tolerance())
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if marked.wires == 0:
            self.report({"ERROR"}, "Nothing to mark: select the edges of the wire first.")
            return {"CANCELLED"}
        sentence = f"{counted(marked.wires, 'wire')} marked"
        if marked.lost_eases:
            lost = counted(marked.lost_eases, "wire")
            self.report({"WARNING"}, f"{sentence}. {lost} had several eases: mark the ease again.")
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

    def execute(self, context: bpy.types.Context) -> set[str]:
        try:
            count = clear_selected(context.objects_in_mode_unique_data)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if count == 0:
            self.report({"WARNING"}, "No selected edge is a wire")
            return {"CANCELLED"}
        return {"FINISHED"}


class MESH_OT_wirewarp_allowance(bpy.types.Operator):
    """Set the seam allowance of the selected edges on seams and outlines; on flat pieces that of their side alone"""

    bl_idname = "mesh.wirewarp_allowance"
    bl_label = "Mark Allowance"
    bl_options = {"REGISTER", "UNDO"}

    kind: EnumProperty(name="Kind", description="What is added outside the edges", items=ALLOWANCES, default="WIDTH")
    width: FloatProperty(
        name="Width (mm)",
        description="Width of the seam allowance",
        min=0.1,
        soft_max=50.0,
        max=1000.0,
        default=10.0,
        step=100,
    )
    hem: FloatProperty(
        name="Hem (mm)",
        description="Width of the hem, which is turned up",
        min=0.1,
        soft_max=100.0,
        max=1000.0,
        default=30.0,
        step=100,
    )

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        return next(description for kind, _, description in ALLOWANCES if kind == properties.kind)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return context.mode == "EDIT_MESH"

    def execute(self, context: bpy.types.Context) -> set[str]:
        millimeters = 1000 * meters_per_blender_unit(context.scene)
        widths = {"WIDTH": self.width / millimeters, "HEM": self.hem / millimeters, "FOLD": NONE, "DEFAULT": 0.0}
        try:
            count, left_out = _mark_allowance(context, widths[self.kind])
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if count == 0:
            self.report({"ERROR"}, "Nothing to mark: select edges on a seam or outline first.")
            return {"CANCELLED"}
        if left_out:
            lie = counted(left_out, "selected edge lies", "selected edges lie")
            self.report(
                {"WARNING"}, f"{counted(count, 'edge')} marked; {lie} inside of a piece, where nothing is added."
            )
        else:
            self.report({"INFO"}, f"{counted(count, 'edge')} marked")
        return {"FINISHED"}

    def draw(self, _context: bpy.types.Context) -> None:
        self.layout.use_property_split = True
        self.layout.prop(self, "kind")
        if self.kind in {"WIDTH", "HEM"}:
            self.layout.prop(self, self.kind.lower())


def _mark_allowance(context: bpy.types.Context, width: float) -> tuple[int, int]:
    """On models all sides, on flat pieces theirs; returns the numbers of edges marked and left out."""
    targets = list(context.objects_in_mode_unique_data)
    for target in targets:
        check_local(target, target.data)
    with in_object_mode(context):
        planned = [_plan_allowance(target, width) for target in targets]  # any of them may be refused
        counts = [write() for write in planned]
        hold_whole_file()
    return sum(marked for marked, _ in counts), sum(left_out for _, left_out in counts)


def _plan_allowance(target: bpy.types.Object, width: float) -> Callable[[], tuple[int, int]]:
    sides = selected_sides(target) if model_of(target) else None
    mesh = sides.model.data if sides else target.data
    check_allowances(mesh)

    def write() -> tuple[int, int]:
        if sides:
            count, marked = len(sides.edges) + sides.left_out, mark_sides(mesh, sides.corners, width)
        else:
            rows = np.flatnonzero(read_selected_edges(mesh) & ~read_hidden_edges(mesh))
            count, marked = len(rows), mark_edges(mesh, rows, width)
        mesh.update()
        return marked, count - marked

    return write


class MESH_OT_wirewarp_seams_from_uv_islands(OnModel, bpy.types.Operator):
    """Mark seams along the island borders of the active UV map, or of your own map while WireWarp's is active"""

    bl_idname = "mesh.wirewarp_seams_from_uv_islands"
    bl_label = "Seams from UV Islands"
    bl_options = {"REGISTER", "UNDO"}
    on_model = "mark seams"

    def execute(self, context: bpy.types.Context) -> set[str]:
        targets = list(context.objects_in_mode_unique_data)
        try:
            with in_object_mode(context):
                count, maps = seams_from_uv(targets)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        named = f"{'UV map' if len(maps) == 1 else 'UV maps'} {quoted(maps)}"
        if count == 0:
            self.report({"INFO"}, f"No new seams: every island border of the {named} is one already")
            return {"CANCELLED"}
        self.report({"INFO"}, f"{counted(count, 'edge')} marked as seam, from the {named}")
        return {"FINISHED"}


CLASSES = (
    MESH_OT_wirewarp_mark,
    MESH_OT_wirewarp_clear,
    MESH_OT_wirewarp_allowance,
    MESH_OT_wirewarp_seams_from_uv_islands,
)
