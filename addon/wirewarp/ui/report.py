# SPDX-License-Identifier: GPL-3.0-or-later
"""The length report of the active object, worst first."""

import bpy

from ..model_state import has_changed
from ..report_store import last_report
from .panel import SidebarPanel
from .report_issues import draw_issues
from .report_rows import helper_rows, outline_rows, piece_rows, seam_rows, wire_rows
from .report_table import draw_heading, draw_select, draw_table
from .text import draw_sentence
from .verdict import verdict


def shown_report(context: bpy.types.Context) -> dict | None:
    """The report of the active object, or of the source of active flat pieces."""
    source = shown_source(context)
    return last_report(source) if source else None


def shown_source(context: bpy.types.Context) -> bpy.types.Object | None:
    active = context.active_object
    if active is None or active.type != "MESH":
        return None
    return active.wirewarp_source or active


class VIEW3D_PT_wirewarp_report(SidebarPanel, bpy.types.Panel):
    bl_label = "Report"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return shown_report(context) is not None

    def draw(self, context: bpy.types.Context) -> None:
        layout = self.layout
        report = shown_report(context)
        if has_changed(shown_source(context), report):
            warning = layout.column()
            warning.alert = True
            draw_sentence(context, warning, "The model has changed since: flatten again.", "ERROR")
        else:
            self._draw_verdict(context, report)
        if "method_name" in report:
            draw_sentence(context, layout, f"Method: {report['method_name']}")
        if report["issues"]:
            draw_issues(context, layout.box(), report)
        for note in report["notes"]:
            draw_sentence(context, layout, note, "INFO")

    def _draw_verdict(self, context: bpy.types.Context, report: dict) -> None:
        for line in verdict(report):
            selectable = line.piece is not None and "flat_object" in report
            row = self.layout.row(align=True)
            draw_sentence(context, row, line.text, line.icon, spare=22 if selectable else 0)
            if selectable:
                draw_select(row, "PIECE", line.piece)


class ReportTable(SidebarPanel):
    """A sub-panel with one table. Subclasses say which rows."""

    bl_parent_id = "VIEW3D_PT_wirewarp_report"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return bool(cls.rows(shown_report(context)))

    def draw(self, context: bpy.types.Context) -> None:
        draw_table(context, self.layout, self.rows(shown_report(context)))


class VIEW3D_PT_wirewarp_report_seams(ReportTable, bpy.types.Panel):
    bl_label = "Seams"
    rows = staticmethod(seam_rows)


class VIEW3D_PT_wirewarp_report_wires(ReportTable, bpy.types.Panel):
    bl_label = "Wires"
    rows = staticmethod(wire_rows)


class VIEW3D_PT_wirewarp_report_outlines(ReportTable, bpy.types.Panel):
    bl_label = "Outlines"
    bl_options = {"DEFAULT_CLOSED"}
    rows = staticmethod(outline_rows)


class VIEW3D_PT_wirewarp_report_helpers(ReportTable, bpy.types.Panel):
    bl_label = "Helper Wires"
    bl_options = {"DEFAULT_CLOSED"}
    rows = staticmethod(helper_rows)


class VIEW3D_PT_wirewarp_report_pieces(SidebarPanel, bpy.types.Panel):
    bl_label = "Pieces"
    bl_parent_id = "VIEW3D_PT_wirewarp_report"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return bool(shown_report(context)["pieces"])

    def draw(self, context: bpy.types.Context) -> None:
        draw_sentence(context, self.layout, "Without any distortion: distortion 0, aspect ratio 1, angles 0°", "INFO")
        column = self.layout.column(align=True)
        report = shown_report(context)
        flat = "flat_object" in report
        for index, ok, lines in piece_rows(report):
            draw_heading(context, column, lines[0], ok, "PIECE", index if flat else None)
            for line in lines[1:]:
                column.label(text=line, icon="BLANK1")
