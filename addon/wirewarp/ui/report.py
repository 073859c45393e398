# SPDX-License-Identifier: GPL-3.0-or-later
"""The length report of the active object, worst first."""

import bpy

from ..report_store import last_report
from ..unit_text import LengthText, length_text
from .panel import SidebarPanel
from .report_rows import ReportRow, outline_rows, piece_rows, seam_rows, wire_rows
from .text import draw_sentence

SHOWN_ROWS = 8


def shown_report(context: bpy.types.Context) -> dict | None:
    """The report of the active object, or of the source of active flat pieces."""
    active = context.active_object
    if active is None or active.type != "MESH":
        return None
    return last_report(active.wirewarp_source or active)


class VIEW3D_PT_wirewarp_report(SidebarPanel, bpy.types.Panel):
    bl_label = "Report"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return shown_report(context) is not None

    def draw(self, context: bpy.types.Context) -> None:
        layout = self.layout
        report = shown_report(context)
        if report["ok"]:
            layout.label(text=f"{_count(report['pieces'], 'piece')}: every length kept", icon="CHECKMARK")
        else:
            failed = sum(not piece["ok"] for piece in report["pieces"]) or 1
            layout.label(text=f"{failed} of {len(report['pieces']) or 1} failed", icon="CANCEL")
        if "method_name" in report:
            draw_sentence(context, layout, f"Method: {report['method_name']}")
        if report["issues"]:
            self._draw_issues(context, report)
        for note in report["notes"]:
            draw_sentence(context, layout, note, "INFO")

    def _draw_issues(self, context: bpy.types.Context, report: dict) -> None:
        box = self.layout.box()
        for issue in report["issues"][:SHOWN_ROWS]:
            where = "" if issue["piece"] is None else f"Piece {issue['piece'] + 1}: "
            draw_sentence(context, box, where + issue["sentence"], "ERROR")
        if len(report["issues"]) > SHOWN_ROWS:
            box.label(text=f"and {len(report['issues']) - SHOWN_ROWS} more")
        if any(issue["vertices"] or issue["edges"] or issue["faces"] for issue in report["issues"]):
            box.operator("mesh.wirewarp_select_issues", icon="RESTRICT_SELECT_OFF")
        if any(issue["code"] == "multi_user_scale" for issue in report["issues"]):
            button = box.operator("object.make_single_user", text="Make Single User")
            button.object = button.obdata = True


class ReportTable(SidebarPanel):
    """A sub-panel with one table. Subclasses say which rows."""

    bl_parent_id = "VIEW3D_PT_wirewarp_report"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return bool(cls.rows(shown_report(context)))

    @staticmethod
    def rows(report: dict) -> list[ReportRow]:
        raise NotImplementedError

    def draw(self, context: bpy.types.Context) -> None:
        text = length_text(context.scene)
        rows = self.rows(shown_report(context))
        shown = rows if context.scene.wirewarp.show_all else rows[:SHOWN_ROWS]
        column = self.layout.column(align=True)
        _draw_line(column, "", [f"3D {text.unit}", f"Flat {text.unit}", "Diff.", "%"])
        for row in shown:
            column.separator(factor=0.5)
            column.label(text=row.name, icon="CHECKMARK" if row.ok else "CANCEL")
            for side in row.sides:
                _draw_line(column, side.label, _numbers(side, text))
        if len(rows) > SHOWN_ROWS:
            self.layout.prop(context.scene.wirewarp, "show_all", text=f"Show All {len(rows)}")


class VIEW3D_PT_wirewarp_report_seams(ReportTable, bpy.types.Panel):
    bl_label = "Seams"
    bl_options = set()
    rows = staticmethod(seam_rows)


class VIEW3D_PT_wirewarp_report_wires(ReportTable, bpy.types.Panel):
    bl_label = "Wires"
    bl_options = set()
    rows = staticmethod(wire_rows)


class VIEW3D_PT_wirewarp_report_outlines(ReportTable, bpy.types.Panel):
    bl_label = "Outlines"
    rows = staticmethod(outline_rows)


class VIEW3D_PT_wirewarp_report_pieces(SidebarPanel, bpy.types.Panel):
    bl_label = "Pieces"
    bl_parent_id = "VIEW3D_PT_wirewarp_report"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return bool(shown_report(context)["pieces"])

    def draw(self, context: bpy.types.Context) -> None:
        column = self.layout.column(align=True)
        for ok, lines in piece_rows(shown_report(context)):
            column.label(text=lines[0], icon="CHECKMARK" if ok else "CANCEL")
            for line in lines[1:]:
                column.label(text=line, icon="BLANK1")


def _numbers(side: object, text: LengthText) -> list[str]:
    if side.length_2d is None:
        return [text.number(side.length_3d), "none", "", ""]
    return [
        text.number(side.length_3d),
        text.number(side.length_2d),
        text.difference(side.difference),
        f"{abs(side.percent):.3f}" if abs(side.percent) < 5e-4 else f"{side.percent:+.3f}",
    ]


def _draw_line(layout: bpy.types.UILayout, label: str, cells: list[str]) -> None:
    row = layout.row()
    row.scale_y = 0.8
    split = row.split(factor=0.1)
    split.label(text=label)
    columns = split.row()
    for cell in cells:
        part = columns.row()
        part.alignment = "RIGHT"
        part.label(text=cell)


def _count(items: list, name: str) -> str:
    return f"{len(items)} {name}{'s' if len(items) != 1 else ''}"
