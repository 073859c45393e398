# SPDX-License-Identifier: GPL-3.0-or-later
import bpy

from ..model_state import has_changed
from ..report_csv import report_csv
from ..report_store import last_report, pieces_report
from ..unit_text import length_text
from .report_operator import ReportOperator


class OBJECT_OT_wirewarp_copy_report(ReportOperator, bpy.types.Operator):
    """Copy all lengths and areas of the report to the clipboard, as a table in the scene's units for spreadsheets"""

    bl_idname = "object.wirewarp_copy_report"
    bl_label = "Copy as CSV"
    bl_options = {"REGISTER"}

    def report_of(self, source: bpy.types.Object) -> dict | None:
        """Of the flat pieces, if there are any."""
        return pieces_report(source) or last_report(source)

    def act(self, context: bpy.types.Context, source: bpy.types.Object, report: dict) -> set[str]:
        table = report_csv(report, length_text(context.scene))
        context.window_manager.clipboard = table
        lines = table.count("\n") - 1
        if has_changed(source, report):
            self.report({"WARNING"}, f'{lines} lines copied, of "{source.name}" as it was: it has changed since')
        else:
            self.report({"INFO"}, f"{lines} lines copied")
        return {"FINISHED"}
