# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of wires: name, kind, length. A click selects, or changes one."""

import bpy
import numpy as np

from ..blender.cache import stamp
from ..blender.units import length_text
from ..issues import ObjectError
from ..model.owners import model_of
from ..model.wires import WireSummary, editable_name, listed_wires
from ..overlay.cache import kept_drawing
from ..words import counted, tolerance_text
from .layout import SidebarPanel, draw_sentence, is_wide

SHOWN_WIRES = 40  # more make Blender slow to draw


def shown_wires(target: bpy.types.Object) -> list[tuple[str, WireSummary]]:
    """As listed_wires; of a large mesh that is being edited not anew at every redraw, for that would be felt."""
    names = [(entry.wire_id, entry.name) for entry in target.data.wirewarp_names]
    made_of = stamp(target.data), target.data.is_editmode, names
    return kept_drawing(target, "wires", made_of, lambda: listed_wires(target))


class VIEW3D_PT_wirewarp_wires(SidebarPanel, bpy.types.Panel):
    bl_label = "Wires"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        return active is not None and active.type == "MESH" and not model_of(active)  # the report has theirs

    def draw(self, context: bpy.types.Context) -> None:
        target = context.active_object
        try:
            wires = shown_wires(target)
        except ObjectError as error:
            draw_sentence(context, self.layout, str(error), "ERROR")
            return
        if not wires:
            self.layout.label(text="No wires yet")
            return
        linear = np.array(target.matrix_world, dtype=np.float64)[:3, :3]
        text = length_text(context.scene)
        column = self.layout.column(align=True)
        for name, wire in wires[:SHOWN_WIRES]:
            first, figures = self._lines(context, column)
            self._draw_name(first, target.data, name, wire)
            self._change_button(figures, tolerance_text(wire.tolerance), wire)
            last = figures.row()
            last.alignment = "RIGHT"
            last.label(text=text.number(wire.length(linear)))
        if len(wires) > SHOWN_WIRES:
            self.layout.label(text=f"and {len(wires) - SHOWN_WIRES} more")
        total = sum(wire.length(linear) for _, wire in wires)
        self.layout.label(text=f"{counted(len(wires), 'wire')}, {text(total)} in all")

    def _lines(
        self, context: bpy.types.Context, column: bpy.types.UILayout
    ) -> tuple[bpy.types.UILayout, bpy.types.UILayout]:
        """Places for the name and for the figures: side by side, in a narrow sidebar one below the other."""
        if is_wide(context):
            columns = column.split(factor=0.5, align=True)
            return columns.row(align=True), columns.split(factor=0.4)
        lines = column.column(align=True)
        column.separator(factor=0.6)
        return lines.row(align=True), lines.split(factor=0.5, align=True)

    def _draw_name(self, row: bpy.types.UILayout, mesh: bpy.types.Mesh, name: str, wire: WireSummary) -> None:
        row.operator("mesh.wirewarp_select_wire", text="", icon="RESTRICT_SELECT_OFF").edge = wire.edges[0]
        entry = editable_name(mesh, wire)
        if entry:
            row.prop(entry, "name", text="")
        else:
            self._change_button(row, name, wire)
        is_grain = mesh.wirewarp_grain == wire.wire_id and not wire.shares_id
        row.operator(
            "mesh.wirewarp_grain_wire", text="", icon="EMPTY_SINGLE_ARROW", depress=is_grain
        ).edge = wire.edges[0]

    def _change_button(self, layout: bpy.types.UILayout, text: str, wire: WireSummary) -> None:
        layout.operator("mesh.wirewarp_change_wire", text=text).edge = wire.edges[0]
