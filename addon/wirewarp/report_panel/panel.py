# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the report of the active object: failures, and tables of lengths, the worst first."""

from collections.abc import Mapping, Sequence

import bpy

from ..blender.objects import length_text, meters_per_blender_unit
from ..core import (
    BEYOND_FABRIC,
    CLOSED_CODE,
    COARSE,
    COARSE_ADVICE,
    STRAINED,
    TORN,
    TORN_ADVICE,
    WIRE_AT_LIMIT,
    Issue,
    LengthText,
    ReportRow,
    Side,
    counted,
    hint_text,
    issue_text,
    largest_difference,
    merged,
    note_text,
    pattern,
    tolerance_text,
)
from ..solve.report import ObjectReport
from ..state.reports import pieces_report, seems_changed
from ..ui.layout import SidebarPanel, broken, draw_cells, draw_sentence, is_wide, mark_of
from ..ui.settings import shown_report, shown_source
from .next_step import has_shown_place

SHOWN_ROWS = 8  # entries shown of a longer list, so that the next panel is in view
MOST_ROWS = 100  # maximum number of rows, because more rows slow down drawing


def draw_table(
    context: bpy.types.Context,
    layout: bpy.types.UILayout,
    rows: list[ReportRow],
    names: Mapping[int, bpy.types.PropertyGroup],
) -> None:
    """Draw the table of these rows. names: for the id of each seam, the item that contains its name, which the
    user can edit."""
    units, meters = length_text(context.scene), meters_per_blender_unit(context.scene)
    column = layout.column(align=True)
    wide = is_wide(context)
    if wide:
        draw_cells(column, "", [f"Model {units.unit}", f"Flat {units.unit}", "Diff.", "%"], 0.2)
    for row in rows[: MOST_ROWS if context.scene.wirewarp.show_all else SHOWN_ROWS]:
        if row.seam_id in names:
            line = column.row(align=True)
            line.prop(names[row.seam_id], "name", text="", **mark_of(row.ok))
            draw_select(line, row.what, row.index)
        else:
            draw_heading(context, column, row.name, mark_of(row.ok), row.what, row.index)
        if row.note:
            draw_sentence(context, column, row.note, "INFO" if row.at_limit else "BLANK1")
        for longer in longer_sides(row.sides, units, meters):
            draw_sentence(context, column, longer, "INFO")
        (_draw_wide if wide else _draw_narrow)(column, row, units)
        column.separator(factor=0.7)
    if len(rows) > SHOWN_ROWS:
        text = f"Show all {len(rows)}" if len(rows) <= MOST_ROWS else f"Show {MOST_ROWS} of {len(rows)}"
        layout.prop(context.scene.wirewarp, "show_all", text=text)


def draw_heading(
    context: bpy.types.Context, layout: bpy.types.UILayout, name: str, mark: dict, what: str | None, index: int
) -> None:
    """Draw the name of a row with its mark (see mark_of), and the button that selects the seam, wire or outline. what:
    kind of the row, such as "SEAM"; None: no button."""
    row = layout.row(align=True)
    text = row.column(align=True)
    lines = broken(context, name, reserved=22 if what else 0)
    text.scale_y = 1 if len(lines) == 1 else 0.8
    for number, line in enumerate(lines):
        text.label(text=line, **({"icon": "BLANK1"} if number else mark))
    if what:
        draw_select(row, what, index)


def draw_select(row: bpy.types.UILayout, what: str, index: int) -> None:
    button = row.operator("mesh.wirewarp_select_result", text="", icon="RESTRICT_SELECT_OFF", emboss=False)
    button.what, button.index = what, index


def _draw_wide(column: bpy.types.UILayout, row: ReportRow, text: LengthText) -> None:
    for label, numbers in _flat_lines(row, text):
        draw_cells(column, label, [text.number(row.sides[0].length_3d), *numbers], 0.2)


def _draw_narrow(column: bpy.types.UILayout, row: ReportRow, text: LengthText) -> None:
    draw_cells(column, "Model", [text(row.sides[0].length_3d)], 0.4)
    for label, (flat, difference, percent) in _flat_lines(row, text):
        draw_cells(column, label, [f"{flat} {text.unit}" if percent else flat], 0.4)
        if percent:
            draw_cells(column, " diff.", [f"{difference} {text.unit}  {percent}%"], 0.25)


def _flat_lines(row: ReportRow, text: LengthText) -> list[tuple[str, tuple[str, ...]]]:
    return merged(row.sides, [_flat_numbers(side, text) for side in row.sides])


def _flat_numbers(side: Side, text: LengthText) -> tuple[str, str, str]:
    """Return the texts of flat length, difference and percent. If the side has no flat shape, the last two are ""."""
    if side.length_2d is None:
        return "not laid flat", "", ""
    percent = f"{abs(side.percent):.3f}" if abs(side.percent) < 5e-4 else f"{side.percent:+.3f}"
    return text.number(side.length_2d), text.difference(side.difference), percent


def longer_sides(sides: Sequence[Side], units: LengthText, meters: float) -> list[str]:
    """Return the texts that the pattern has on an eased seam, such as "Sleeve 12 mm longer, ease between notches".

    meters: meters in a Blender unit.
    """
    asked = {side.label: side.length_asked for side in sides if side.length_2d is not None and side.length_asked}
    millimeters = 1000 * meters
    texts = {
        label: pattern.longer_text(
            length * millimeters, min(asked.values()) * millimeters, lambda more: units.rough(more / millimeters)
        )
        for label, length in asked.items()
    }
    return [f"{label} {text}" for label, text in texts.items() if text]


SHOWN_HINTS = 5  # places shown below each advice, so that the next advice is in view
ADVICE = {
    COARSE: f"{COARSE_ADVICE}:",
    TORN: f"{TORN_ADVICE}:",
    WIRE_AT_LIMIT: "A wider tolerance on these wires would lower the distortion:",
    BEYOND_FABRIC: "Your fabric does not stretch far enough at these places. Add a dart or seam:",
    STRAINED: "The fabric must stretch or be compressed at these places. If your fabric cannot, add a dart or seam:",
}


def draw_issues(context: bpy.types.Context, layout: bpy.types.UILayout, report: ObjectReport) -> None:
    issues = report.issues
    for index, issue in enumerate(issues[:SHOWN_ROWS]):
        _draw_entry(context, layout, issue_text(report, issue), "ISSUE", index, has_shown_place(report, issue))
        # The buttons that apply suggestions are drawn here only if the panel Flatten does not have them.
        if not report.with_modifiers and (len(issues) > 1 or issue.code == CLOSED_CODE):
            _draw_proposals(context, layout, index, issue)
    if len(issues) > SHOWN_ROWS:
        layout.label(text=f"and {len(issues) - SHOWN_ROWS} more")
    if sum(issue.has_place for issue in issues) > 1 and not report.with_modifiers:
        layout.operator("mesh.wirewarp_select_issues", text="Select All Problems", icon="RESTRICT_SELECT_OFF")
    if any(issue.code == "multi_user_scale" for issue in issues):
        button = layout.operator("object.make_single_user", text="Make Single User")
        button.object = button.obdata = True


def draw_hints(context: bpy.types.Context, layout: bpy.types.UILayout, report: ObjectReport) -> None:
    """Draw each sentence of advice, and below it the places to which it applies."""
    is_there = not report.with_modifiers or report.flat_object is not None
    for code, advice in ADVICE.items():
        hints = [(index, hint) for index, hint in enumerate(report.hints) if hint.code == code]
        if not hints:
            continue
        column = layout.column(align=True)
        draw_sentence(context, column, advice, "INFO")
        for index, hint in hints[:SHOWN_HINTS]:
            placed = is_there and hint.has_place
            _draw_entry(context, column, hint_text(report, hint), "HINT", index, placed)
        if code == COARSE:
            button = column.operator("object.wirewarp_mend", text="Subdivide and Flatten", icon="MOD_SUBSURF")
            button.what = "SUBDIVIDE"
        if len(hints) > SHOWN_HINTS:
            column.label(text=f"and {len(hints) - SHOWN_HINTS} more", icon="BLANK1")


def _draw_entry(
    context: bpy.types.Context, layout: bpy.types.UILayout, text: str, what: str, index: int, placed: bool
) -> None:
    """Draw the text and, if `placed`, a button that selects the place. what: ISSUE or HINT; index: index of the entry
    in the report."""
    row = layout.row(align=True)
    reserved = (6 if what == "ISSUE" else 0) + (22 if placed else 0)
    draw_sentence(context, row, text, "ERROR" if what == "ISSUE" else "DOT", reserved)
    if placed:
        draw_select(row, what, index)


def _draw_proposals(context: bpy.types.Context, layout: bpy.types.UILayout, index: int, issue: Issue) -> None:
    seams, wires = issue.proposed_seams, issue.proposed_tolerances
    both = " on Both Sides" if issue.both_sides else ""
    if seams:
        _draw_button(layout, "SEAMS", index, f"Mark {counted(len(seams), 'Edge')} as Seam{both}", "EDGESEL")
    if wires:
        named = ", ".join(f"{wire.name} {tolerance_text(wire.tolerance)}" for wire in wires[:SHOWN_ROWS])
        named += f" and {len(wires) - SHOWN_ROWS} more" if len(wires) > SHOWN_ROWS else ""
        draw_sentence(context, layout, named, "BLANK1", reserved=16)
        _draw_button(layout, "TOLERANCES", index, f"Loosen Wires{both}", "FIXED_SIZE")


def _draw_button(layout: bpy.types.UILayout, what: str, index: int, text: str, icon: str) -> None:
    button = layout.operator("mesh.wirewarp_take_proposal", text=text, icon=icon)
    button.what, button.issue = what, index


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
            # The text is gray after a change of the model. The buttons still work, so that several suggestions can be
            # marked before the next run.
            box.active = not seems_changed(source, report)
            draw_issues(context, box, report)
        if report.hints:
            draw_hints(context, layout, report)
        if (pieces_report(source) or report).pieces:
            layout.operator("object.wirewarp_copy_report", icon="COPYDOWN")


class ReportSection(SidebarPanel):
    """Mixin of sub-panels with one table of the report. The header of each shows its largest difference."""

    bl_parent_id = "VIEW3D_PT_wirewarp_report"
    bl_options = {"DEFAULT_CLOSED"}
    table = ""  # name of a table of ReportTables

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
        """Return the text for the header: the largest difference, and the number of rows if the sidebar is wide."""
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
