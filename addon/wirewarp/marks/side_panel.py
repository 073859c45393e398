# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the buttons that mark one side of edges, on flat pieces.

The panel is below the panels Pieces and Report, because it grows in Edit Mode. Above them, it would move their buttons
that enter Edit Mode.
"""

import bpy

from ..state.owners import DELETED, is_deleted, model_of
from ..ui.editing import OnMesh
from ..ui.layout import SidebarPanel, draw_sentence
from .panel import draw_allowances, draw_eases

SIDES = (("ONE", "Ease"), ("NONE", "Clear Ease"))


class VIEW3D_PT_wirewarp_mark_sides(OnMesh, SidebarPanel, bpy.types.Panel):
    bl_label = "Mark Sides"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return super().poll(context) and model_of(context.active_object) is not None

    def draw(self, context: bpy.types.Context) -> None:
        layout, model = self.layout, model_of(context.active_object)
        if is_deleted(model):
            draw_sentence(context, layout, f"These are flat pieces. {DELETED.format(model.name)}", "ERROR")
            return
        sentence = (
            f'Select "{model.name}" to mark seams and wires. In Edit Mode of these flat pieces, you can mark the '
            "allowance and the ease of one side."
        )
        draw_sentence(context, layout, sentence, "INFO")
        if context.mode == "EDIT_MESH":
            layout.label(text="Allowance of selected sides")
            draw_allowances(layout)
            layout.label(text="Ease of selected sides")
            draw_eases(layout, context, SIDES)
