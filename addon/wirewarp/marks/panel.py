# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the panel Mark, which has the same height in all modes and on flat pieces.

Otherwise, a button below the panel would move when it enters Edit Mode. Mark is above Flatten, because the verdict in
Flatten may grow.
"""

from collections.abc import Sequence

import bpy

from ..state.owners import model_of
from ..ui.editing import OnMesh
from ..ui.layout import SidebarPanel
from ..ui.settings import draw_ease

SIDES = (("ALL", "All Sides"), ("NONE", "Clear Ease"), ("ONE", "One Side"), ("OTHER", "Other Side"))


def _can_mark(context: bpy.types.Context) -> bool:
    return context.mode == "EDIT_MESH" and model_of(context.active_object) is None


class VIEW3D_PT_wirewarp_mark(OnMesh, SidebarPanel, bpy.types.Panel):
    bl_label = "Mark"

    def draw(self, context: bpy.types.Context) -> None:
        column = self.layout.column(align=True)
        if context.mode == "EDIT_MESH":
            column.operator("object.editmode_toggle", text="Leave Edit Mode", icon="OBJECT_DATAMODE")
        else:
            row = column.row()
            row.enabled = model_of(context.active_object) is None
            row.operator("object.wirewarp_mark_model", icon="EDITMODE_HLT")
        column.separator()
        marks = column.column(align=True)
        marks.enabled = _can_mark(context)
        row = marks.row(align=True)
        row.operator("mesh.wirewarp_mark_seam", text="Mark Seam").clear = False
        row.operator("mesh.wirewarp_mark_seam", text="Clear Seam").clear = True
        row = marks.row(align=True)
        row.operator("mesh.wirewarp_seams_from_uv_islands", text="From UV Map")
        row.operator("mesh.wirewarp_smooth_seam")
        marks.separator()
        row = marks.row(align=True)
        row.operator("mesh.wirewarp_mark", text="Rigid").kind = "RIGID"
        row.operator("mesh.wirewarp_mark", text="Elastic").kind = "ELASTIC"
        row.operator("mesh.wirewarp_mark", text="Free").kind = "SUPER_ELASTIC"
        row = marks.row(align=True)
        row.prop(context.scene.wirewarp, "tolerance_percent", text="±")
        row.operator("mesh.wirewarp_clear", text="Clear Wire")


class VIEW3D_PT_wirewarp_allowance(OnMesh, SidebarPanel, bpy.types.Panel):
    bl_label = "Allowance and Ease"
    bl_parent_id = "VIEW3D_PT_wirewarp_mark"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context: bpy.types.Context) -> None:
        layout = self.layout
        layout.enabled = _can_mark(context)
        draw_allowances(layout)
        draw_eases(layout, context, SIDES)


def draw_allowances(layout: bpy.types.UILayout) -> None:
    column = layout.column(align=True)
    row = column.row(align=True)
    row.operator("mesh.wirewarp_allowance", text="Allowance").kind = "WIDTH"
    row.operator("mesh.wirewarp_allowance", text="Hem").kind = "HEM"
    row = column.row(align=True)
    row.operator("mesh.wirewarp_allowance", text="Fold").kind = "FOLD"
    row.operator("mesh.wirewarp_allowance", text="Default").kind = "DEFAULT"


def draw_eases(layout: bpy.types.UILayout, context: bpy.types.Context, buttons: Sequence[tuple[str, str]]) -> None:
    """Draw the amount of the ease, and its buttons. buttons: the side and the text of each button, two in a row."""
    column = layout.column(align=True)
    draw_ease(column, context.scene.wirewarp)
    grid = column.grid_flow(row_major=True, columns=2, even_columns=True, align=True)
    for sides, text in buttons:
        grid.operator("mesh.wirewarp_ease", text=text).sides = sides
