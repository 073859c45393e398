# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the panel of marks. It is above Flatten, because the verdict below Flatten grows and shrinks."""

import bpy

from ..state.owners import DELETED, is_deleted, model_of
from ..ui.editing import OnMesh
from ..ui.layout import SidebarPanel, draw_sentence
from ..ui.settings import draw_ease

SIDES = (("ALL", "All Sides"), ("NONE", "Clear Ease"), ("ONE", "One Side"), ("OTHER", "Other Side"))
OF_PIECES = (("ONE", "Ease"), ("NONE", "Clear Ease"))  # buttons shown if a side of a flat piece is selected


class VIEW3D_PT_wirewarp_mark(OnMesh, SidebarPanel, bpy.types.Panel):
    bl_label = "Mark"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        if not super().poll(context):
            return False
        model = model_of(context.active_object)  # flat pieces have marks only in Edit Mode
        return model is None or is_deleted(model) or context.mode == "EDIT_MESH"

    def draw(self, context: bpy.types.Context) -> None:
        layout, model = self.layout, model_of(context.active_object)
        if model:
            sentence = (
                f'Select "{model.name}" to mark seams and wires. On these flat pieces you can mark the allowance and '
                "the ease of one side."
            )
            if is_deleted(model):
                draw_sentence(context, layout, f"These are flat pieces. {DELETED.format(model.name)}", "ERROR")
            else:
                draw_sentence(context, layout, sentence, "INFO")
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


class MarkSection(OnMesh, SidebarPanel):
    """Base of sub-panels with marks of selected edges, or of selected sides of flat pieces."""

    bl_parent_id = "VIEW3D_PT_wirewarp_mark"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        if context.mode != "EDIT_MESH" or not super().poll(context):
            return False
        model = model_of(context.active_object)
        return model is None or not is_deleted(model)


class VIEW3D_PT_wirewarp_allowance(MarkSection, bpy.types.Panel):
    bl_label = "Allowance"

    def draw(self, _context: bpy.types.Context) -> None:
        column = self.layout.column(align=True)
        row = column.row(align=True)
        row.operator("mesh.wirewarp_allowance", text="Allowance").kind = "WIDTH"
        row.operator("mesh.wirewarp_allowance", text="Hem").kind = "HEM"
        row = column.row(align=True)
        row.operator("mesh.wirewarp_allowance", text="Fold").kind = "FOLD"
        row.operator("mesh.wirewarp_allowance", text="Default").kind = "DEFAULT"


class VIEW3D_PT_wirewarp_ease(MarkSection, bpy.types.Panel):
    bl_label = "Ease"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context: bpy.types.Context) -> None:
        column = self.layout.column(align=True)
        draw_ease(column, context.scene.wirewarp)
        grid = column.grid_flow(row_major=True, columns=2, even_columns=True, align=True)
        for sides, text in OF_PIECES if model_of(context.active_object) else SIDES:
            grid.operator("mesh.wirewarp_ease", text=text).sides = sides


CLASSES = (VIEW3D_PT_wirewarp_mark, VIEW3D_PT_wirewarp_allowance, VIEW3D_PT_wirewarp_ease)
