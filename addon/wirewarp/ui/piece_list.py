# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of flat pieces: a double click renames, the arrow selects."""

import bpy

from .panel import SidebarPanel
from .report import shown_report, shown_source
from .report_table import draw_select


class WIREWARP_UL_pieces(bpy.types.UIList):
    def draw_item(
        self,
        context: bpy.types.Context,
        layout: bpy.types.UILayout,
        _source: bpy.types.Object,
        entry: bpy.types.PropertyGroup,
        _icon: int,
        _active_source: bpy.types.Object,
        _active_name: str,
        index: int,
    ) -> None:
        row = layout.row(align=True)
        pieces = shown_report(context)["pieces"]
        ok = index < len(pieces) and pieces[index]["ok"]
        row.prop(entry, "name", text="", emboss=False, icon="CHECKMARK" if ok else "CANCEL")
        draw_select(row, "PIECE", index)


class VIEW3D_PT_wirewarp_pieces(SidebarPanel, bpy.types.Panel):
    bl_label = "Pieces"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        report = shown_report(context)
        return report is not None and "flat_object" in report and len(shown_source(context).wirewarp_pieces) > 0

    def draw(self, context: bpy.types.Context) -> None:
        source = shown_source(context)
        rows = min(len(source.wirewarp_pieces), 8)
        self.layout.template_list(
            "WIREWARP_UL_pieces", "", source, "wirewarp_pieces", source, "wirewarp_active_piece", rows=rows
        )
        self.layout.operator("object.wirewarp_export_svg", icon="EXPORT")
