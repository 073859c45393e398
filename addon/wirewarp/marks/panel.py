# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the panel of marks. It is above Flatten, because the verdict below Flatten grows and shrinks."""

from collections.abc import Sequence

import bpy

from ..state.owners import model_of
from ..ui.editing import OnMesh
from ..ui.layout import SidebarPanel
from ..ui.settings import draw_ease

SIDES = (("ALL", "All Sides"), ("NONE", "Clear Ease"), ("ONE", "One Side"), ("OTHER", "Other Side"))


class VIEW3D_PT_wirewarp_mark(OnMesh, SidebarPanel, bpy.types.Panel):
    bl_label = "Mark"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return super().poll(context) and model_of(context.active_object) is None

    def draw(self, context: bpy.types.Context) -> None:
        layout = self.layout
        if context.mode != "EDIT_MESH":
            layout.operator("object.wirewarp_mark_model", icon="EDITMODE_HLT")
            return
        self._draw_buttons(context, layout)

    def _draw_buttons(self, context: bpy.types.Context, layout: bpy.types.UILayout) -> None:
        layout.label(text="Seams cut the pieces")
        row = layout.row(align=True)
        row.operator("mesh.wirewarp_mark_seam", text="Mark Seam").clear = False
        row.operator("mesh.wirewarp_mark_seam", text="Clear Seam").clear = True
        layout.operator("mesh.wirewarp_seams_from_uv_islands", text="From UV Islands")
        layout.operator("mesh.wirewarp_smooth_seam")

        layout.label(text="Wires control lengths")
        column = layout.column(align=True)
        column.operator("mesh.wirewarp_mark", text="Rigid").kind = "RIGID"
        row = column.row(align=True)
        row.operator("mesh.wirewarp_mark", text="Elastic").kind = "ELASTIC"
        row.prop(context.scene.wirewarp, "tolerance_percent", text="±")
        column.operator("mesh.wirewarp_mark", text="Free").kind = "SUPER_ELASTIC"
        column.operator("mesh.wirewarp_clear", text="Clear Wire")


class MarkSection(OnMesh, SidebarPanel):
    """Base of sub-panels with marks of selected edges."""

    modes = frozenset({"EDIT_MESH"})
    bl_parent_id = "VIEW3D_PT_wirewarp_mark"


class VIEW3D_PT_wirewarp_allowance(MarkSection, bpy.types.Panel):
    bl_label = "Allowance"

    def draw(self, _context: bpy.types.Context) -> None:
        draw_allowances(self.layout)


class VIEW3D_PT_wirewarp_ease(MarkSection, bpy.types.Panel):
    bl_label = "Ease"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context: bpy.types.Context) -> None:
        draw_eases(self.layout, context, SIDES)


def draw_allowances(layout: bpy.types.UILayout) -> None:
    column = layout.column(align=True)
    row = column.row(align=True)
    row.operator("mesh.wirewarp_allowance", text="Allowance").kind = "WIDTH"
    row.operator("mesh.wirewarp_allowance", text="Hem").kind = "HEM"
    row = column.row(align=True)
    row.operator("mesh.wirewarp_allowance", text="Fold").kind = "FOLD"
    row.operator("mesh.wirewarp_allowance", text="Default").kind = "DEFAULT"


def draw_eases(layout: bpy.types.UILayout, context: bpy.types.Context, buttons: Sequence[tuple[str, str]]) -> None:
    """Draw the ease. buttons: the side and the text of each button, two in a row."""
    column = layout.column(align=True)
    draw_ease(column, context.scene.wirewarp)
    grid = column.grid_flow(row_major=True, columns=2, even_columns=True, align=True)
    for sides, text in buttons:
        grid.operator("mesh.wirewarp_ease", text=text).sides = sides


CLASSES = (VIEW3D_PT_wirewarp_mark, VIEW3D_PT_wirewarp_allowance, VIEW3D_PT_wirewarp_ease)
