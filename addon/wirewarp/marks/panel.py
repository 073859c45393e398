# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the panel of marks, with the switches of the overlay."""

from collections.abc import Sequence

import bpy

from ..state.owners import DELETED, is_deleted, model_of
from ..ui.editing import OnMesh
from ..ui.layout import SidebarPanel, draw_sentence
from ..ui.settings import draw_ease

SIDES = (("ALL", "All Sides"), ("NONE", "Clear Ease"), ("ONE", "One Side"), ("OTHER", "Other Side"))
OF_PIECES = (("ONE", "Ease"), ("NONE", "Clear Ease"))  # buttons shown if a side of a flat piece is selected


class VIEW3D_PT_wirewarp_mark(OnMesh, SidebarPanel, bpy.types.Panel):
    bl_label = "Mark"

    def draw(self, context: bpy.types.Context) -> None:
        layout, model = self.layout, model_of(context.active_object)
        if model:
            sentence = (
                f'Select "{model.name}" to mark seams and wires. In Edit Mode of these flat pieces you can mark the '
                "ease and the allowance of one side."
            )
            if is_deleted(model):
                draw_sentence(context, layout, f"These are flat pieces. {DELETED.format(model.name)}", "ERROR")
            else:
                draw_sentence(context, layout, sentence, "INFO")
                if context.mode == "EDIT_MESH":
                    _draw_ease(layout, context, "Ease of selected sides", OF_PIECES)
                    _draw_allowances(layout, "Allowance of selected sides")
            return
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

        _draw_ease(layout, context, "Ease of selected lines", SIDES)
        _draw_allowances(layout, "Allowance of selected edges")


def _draw_ease(
    layout: bpy.types.UILayout, context: bpy.types.Context, title: str, buttons: Sequence[tuple[str, str]]
) -> None:
    """Draw the ease. buttons: the side and the text of each button, two in a row."""
    layout.label(text=title)
    column = layout.column(align=True)
    draw_ease(column, context.scene.wirewarp)
    grid = column.grid_flow(row_major=True, columns=2, even_columns=True, align=True)
    for sides, text in buttons:
        grid.operator("mesh.wirewarp_ease", text=text).sides = sides


def _draw_allowances(layout: bpy.types.UILayout, title: str) -> None:
    layout.label(text=title)
    column = layout.column(align=True)
    row = column.row(align=True)
    row.operator("mesh.wirewarp_allowance", text="Allowance").kind = "WIDTH"
    row.operator("mesh.wirewarp_allowance", text="Hem").kind = "HEM"
    row = column.row(align=True)
    row.operator("mesh.wirewarp_allowance", text="Fold").kind = "FOLD"
    row.operator("mesh.wirewarp_allowance", text="Default").kind = "DEFAULT"


CLASSES = (VIEW3D_PT_wirewarp_mark,)
