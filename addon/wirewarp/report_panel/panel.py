# SPDX-License-Identifier: GPL-3.0-or-later
"""The length report of the active object, worst first."""

import bpy

from ..blender.units import length_text
from ..core import largest_difference, note_text
from ..state.reports import pieces_report
from ..ui.layout import SidebarPanel, draw_sentence, is_wide, mark_of
from ..ui.shown import has_changed_since, shown_report, shown_source
from .sentences import draw_hints, draw_issues
from .table import draw_table


class VIEW3D_PT_wirewarp_report(SidebarPanel, bpy.types.Panel):
    bl_label = "Report"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return shown_report(context) is not None

    def draw(self, context: bpy.types.Context) -> None:
        layout = self.layout
        source, report = shown_source(context), shown_report(context)
        for note in report.notes:
            draw_sentence(context, layout, note_text(report, note), "ERROR" if note.is_warning else "INFO")
        if report.method_name:
            draw_sentence(context, layout, f"Method: {report.method_name}")
        if report.issues:
            box = layout.box()
            # Gray, but the next proposal can be taken without a run between.
            box.active = not has_changed_since(source, report)
            draw_issues(context, box, report)
        if report.hints:
            draw_hints(context, layout, report)
        if (pieces_report(source) or report).pieces:
            layout.operator("object.wirewarp_copy_report", icon="COPYDOWN")


class ReportSection(SidebarPanel):
    """A sub-panel with one table, of which the header says the worst. Subclasses say which rows."""

    bl_parent_id = "VIEW3D_PT_wirewarp_report"
    bl_options = {"DEFAULT_CLOSED"}
    table = ""  # of ReportTables

    @classmethod
    def rows(cls, context: bpy.types.Context) -> list:
        report = shown_report(context)
        return getattr(report.tables, cls.table) if report else []

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return bool(cls.rows(context))

    def draw_header_preset(self, context: bpy.types.Context) -> None:
        rows = self.rows(context)
        row = self.layout.row(align=True)
        row.label(text=self.summary(context, rows))
        row.label(text="", **self.mark(rows))

    def mark(self, rows: list) -> dict:
        return mark_of(all(each.ok for each in rows))

    def summary(self, context: bpy.types.Context, rows: list) -> str:
        """The largest difference; the number of rows where there is room."""
        largest = largest_difference(rows)
        text = "" if largest is None else length_text(context.scene)(largest)
        return f"{len(rows)}, largest difference {text}" if text and is_wide(context) else f"±{text}" if text else ""

    def draw(self, context: bpy.types.Context) -> None:
        names = {entry.seam_id: entry for entry in shown_source(context).wirewarp_seams}
        draw_table(context, self.layout, self.rows(context), names)


class VIEW3D_PT_wirewarp_report_seams(ReportSection, bpy.types.Panel):
    bl_label = "Seams"
    table = "seams"


class VIEW3D_PT_wirewarp_report_wires(ReportSection, bpy.types.Panel):
    bl_label = "Wires"
    table = "wires"


class VIEW3D_PT_wirewarp_report_outlines(ReportSection, bpy.types.Panel):
    bl_label = "Outlines"
    table = "outlines"


CLASSES = (
    VIEW3D_PT_wirewarp_report,
    VIEW3D_PT_wirewarp_report_seams,
    VIEW3D_PT_wirewarp_report_wires,
    VIEW3D_PT_wirewarp_report_outlines,
)
