# SPDX-License-Identifier: GPL-3.0-or-later
"""The operator that marks and clears eases, for lines that are sewn to shorter or longer lines."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

import bpy
from bpy.props import EnumProperty

from ..blender.mesh import selected_edges
from ..blender.objects import length_text, meters_per_blender_unit
from ..blender.selection import hold_whole_file
from ..core import LengthText, counted, ease_text
from ..issues import object_error
from ..properties import EaseAmount, take_settings
from ..state.owners import model_of
from ..ui.editing import change_edited, reporting_refusals
from ..ui.settings import draw_ease
from .ease import Amount, Eased, Planned, check_ease_attributes, clear_eases, plan_corners, plan_lines, plan_sides
from .mark import selected_sides

SIDES = [
    (
        "ALL",
        "All Sides",
        "Ease the selected lines, all sides of a seam equally. Lines that are not wires become rigid wires",
    ),
    (
        "ONE",
        "One Side",
        "Ease the selected seams only on the side of the smaller piece, as for sleeve heads. An arrow shows this side",
    ),
    ("OTHER", "Other Side", "Ease the selected seams only on the side of the larger piece, as for gathers"),
    ("NONE", "Clear Ease", "Remove the ease of the selected lines from all sides"),
]
SIDES_APART = "On flat pieces, only the selected side can be eased. Press Ease, or press All Sides on the model."
NO_SIDES = "select edges of a seam or outline that have exactly one face on the side to ease"
NOTHING = {
    "ALL": "select the edges of a line first",
    "ONE": NO_SIDES,
    "OTHER": NO_SIDES,
    "NONE": "none of the selected edges has an ease",
}


class MESH_OT_wirewarp_ease(EaseAmount, bpy.types.Operator):
    """Make the selected lines longer or shorter than on the model"""

    bl_idname = "mesh.wirewarp_ease"
    bl_label = "Mark Ease"
    bl_options = {"REGISTER", "UNDO"}

    sides: EnumProperty(
        name="Sides", description="Eased sides of a seam. An outline has only one side", items=SIDES, default="ALL"
    )

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        return next(description for kind, _, description in SIDES if kind == properties.sides)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return context.mode == "EDIT_MESH"

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        take_settings(self, context.scene.wirewarp, EaseAmount)
        return self.execute(context)

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        amount = self._amount(context.scene)
        found = change_edited(context, lambda target: self._plan(target, amount))
        return self._reported(found, length_text(context.scene))

    def _amount(self, scene: bpy.types.Scene) -> Amount:
        share, length = self.ease_percent / 100, self.ease_length / (1000 * meters_per_blender_unit(scene))
        return (lambda line: length / line) if self.ease_unit == "LENGTH" else lambda _: share

    def _plan(self, target: bpy.types.Object, amount: Amount) -> Planned:
        """Plan the ease. On flat pieces, plan it only for the selected side."""
        found = selected_sides(target) if model_of(target) else None
        model = found.model if found else target
        check_ease_attributes(model.data)
        rows = found.edges if found else selected_edges(model.data)
        planned: Callable[[], Eased]
        if self.sides == "NONE":
            planned = partial(clear_eases, model, rows)
        elif found and self.sides != "ONE":
            raise object_error("sides_apart", SIDES_APART)
        elif found:
            planned = plan_corners(model, found.corners, amount)
        elif self.sides == "ALL":
            planned = plan_lines(model, rows, amount)
        else:
            planned = plan_sides(model, rows, amount, ("ONE", "OTHER").index(self.sides))
        return partial(_write, planned, model.data, found.left_out if found else 0)

    def _reported(self, found: list[Eased], units: LengthText) -> set[str]:
        left_out = sum(each.left_out for each in found)
        changes = [change for each in found for change in each.changes]
        if not changes:
            self.report({"ERROR"}, f"Nothing to {'clear' if self.sides == 'NONE' else 'mark'}: {NOTHING[self.sides]}.")
            return {"CANCELLED"}
        hold_whole_file()
        if self.sides == "NONE":
            self.report({"INFO"}, f"Ease cleared on {counted(len(changes), 'line')}")
            return {"FINISHED"}
        texts = [f"{ease_text(each.ratio)}, {units.difference(each.length)} {units.unit}" for each in changes]
        changed = "; ".join(dict.fromkeys(texts))
        sentence = f"{counted(len(changes), 'line')} eased: {changed}"
        if left_out:
            left = counted(left_out, "selected edge was", "selected edges were")
            self.report({"WARNING"}, f"{sentence}. {left} left out.")
        else:
            self.report({"INFO"}, sentence)
        return {"FINISHED"}

    def draw(self, context: bpy.types.Context) -> None:
        self.layout.use_property_split = True
        if not model_of(context.object):
            self.layout.prop(self, "sides")
        if self.sides != "NONE":
            draw_ease(self.layout, self)


def _write(planned: Planned, mesh: bpy.types.Mesh, left_out: int) -> Eased:
    eased = planned()
    mesh.update()
    return replace(eased, left_out=eased.left_out + left_out)
