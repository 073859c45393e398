# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the export button with its settings and the page preview."""

import bpy

from ..overlay.shown import shown_copies, shown_pages
from ..state.owners import find_flat_object
from ..ui.layout import SidebarPanel, draw_progress, draw_sentence
from ..ui.settings import shown_source
from ..ui.window_run import EXPORT
from .piece_list import report_of_pieces


class VIEW3D_PT_wirewarp_export(SidebarPanel, bpy.types.Panel):
    bl_label = "Export"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        report = report_of_pieces(context)
        return report is not None and report.flat_object is not None

    def draw(self, context: bpy.types.Context) -> None:
        settings, layout = context.scene.wirewarp, self.layout
        layout.prop(settings, "allowance", text="Allowance (mm)")
        row = layout.row(align=True)
        row.prop(settings, "pairs", toggle=True)
        row.prop(settings, "on_fold", toggle=True)
        row = layout.row(align=True)
        if not draw_progress(row, EXPORT, "object.wirewarp_export"):
            row.operator("object.wirewarp_export", icon="EXPORT")
            row.prop(settings, "show_pages", text="", icon="DOCUMENTS")
        # The sentences are drawn below the button, so that they do not move it.
        flat = find_flat_object(shown_source(context))
        if (settings.pairs or settings.on_fold) and flat is not None and not flat.data.is_editmode:
            for sentence in shown_copies(context, shown_source(context), flat):
                draw_sentence(context, layout, sentence)
        if settings.show_pages:
            draw_pages(context, layout, shown_source(context))


def draw_pages(context: bpy.types.Context, layout: bpy.types.UILayout, source: bpy.types.Object) -> None:
    settings, column = context.scene.wirewarp, layout.column(align=True)
    column.prop(settings, "arrangement", text="")
    if settings.arrangement == "MARKER":
        column.prop(settings, "cloth_width", text="Fabric Width (mm)")
    else:
        column.prop(settings, "paper", text="")
        if settings.paper == "ROLL":
            column.prop(settings, "roll_width", text="Roll Width (mm)")
    flat = find_flat_object(source)
    if flat is not None and not flat.data.is_editmode:
        preview = shown_pages(context, source, flat)
        draw_sentence(context, layout, preview.sentence, "NONE" if preview.is_good else "ERROR")
