# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of wires: name, kind, length; a click selects."""

import bpy
import numpy as np

from ..issues import ObjectError
from ..tolerance_text import tolerance_text
from ..unit_text import length_text
from ..wire_names import find_name, list_position
from ..wire_summary import WireSummary, wires_of
from .panel import SidebarPanel
from .text import draw_sentence, is_wide

SHOWN_WIRES = 40  # more make Blender slow to draw


class VIEW3D_PT_wirewarp_wires(SidebarPanel, bpy.types.Panel):
    bl_label = "Wires"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        return active is not None and active.type == "MESH"

    def draw(self, context: bpy.types.Context) -> None:
        target = context.active_object
        try:
            wires = sorted(wires_of(target), key=lambda wire: list_position(target.data, wire.wire_id))
        except ObjectError as error:
            draw_sentence(context, self.layout, str(error), "ERROR")
            return
        if not wires:
            self.layout.label(text="No wires yet")
            return
        linear = np.array(target.matrix_world, dtype=np.float64)[:3, :3]
        text = length_text(context.scene)
        column = self.layout.column(align=True)
        for number, wire in enumerate(wires[:SHOWN_WIRES], start=1):
            name, figures = self._lines(context, column)
            self._draw_name(name, target.data, wire, number)
            figures.label(text=tolerance_text(wire.tolerance))
            last = figures.row()
            last.alignment = "RIGHT"
            last.label(text=text.number(wire.length(linear)))
        if len(wires) > SHOWN_WIRES:
            self.layout.label(text=f"and {len(wires) - SHOWN_WIRES} more")
        total = sum(wire.length(linear) for wire in wires)
        self.layout.label(text=f"{len(wires)} wire{'s' if len(wires) != 1 else ''}, {text(total)} in all")

    def _lines(
        self, context: bpy.types.Context, column: bpy.types.UILayout
    ) -> tuple[bpy.types.UILayout, bpy.types.UILayout]:
        """Places for the name and for the figures: side by side, in a narrow sidebar one below the other."""
        if is_wide(context):
            columns = column.split(factor=0.5, align=True)
            return columns.row(align=True), columns.split(factor=0.4)
        name = column.row(align=True)
        figures = column.row()
        figures.scale_y = 0.8
        return name, figures.split(factor=0.5)

    def _draw_name(self, row: bpy.types.UILayout, mesh: bpy.types.Mesh, wire: WireSummary, number: int) -> None:
        button = row.operator("mesh.wirewarp_select_wire", text="", icon="RESTRICT_SELECT_OFF")
        button.wire_id = wire.wire_id
        button.tolerance = min(wire.tolerance, float(np.finfo(np.float32).max))
        named = find_name(mesh, wire.wire_id)
        if named:
            row.prop(named, "name", text="")
        else:
            row.label(text=f"Wire {number}")
