# SPDX-License-Identifier: GPL-3.0-or-later
"""What failed and what could be better: a sentence each, with the buttons that show the place and that fix it."""

import bpy

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
    hint_text,
    issue_text,
)
from ..solve.report import ObjectReport
from ..ui.layout import draw_sentence
from ..words import counted, tolerance_text
from .next_step import is_shown
from .table import SHOWN_ROWS, draw_select

SHOWN_HINTS = 5
ADVICE = {
    COARSE: f"{COARSE_ADVICE}:",
    TORN: f"{TORN_ADVICE}:",
    WIRE_AT_LIMIT: "A wider tolerance on these wires would lower the distortion:",
    BEYOND_FABRIC: "Your fabric does not stretch far enough at these places. Add a dart or seam:",
    STRAINED: "The fabric must stretch or be compressed at these places. If yours does not, add a dart or seam:",
}


def draw_issues(context: bpy.types.Context, layout: bpy.types.UILayout, report: ObjectReport) -> None:
    issues = report.issues
    for index, issue in enumerate(issues[:SHOWN_ROWS]):
        _draw_entry(context, layout, issue_text(report, issue), "ISSUE", index, is_shown(report, issue))
        if not report.with_modifiers and (len(issues) > 1 or issue.code == CLOSED_CODE):  # else the panel has it
            _draw_proposals(context, layout, index, issue)
    if len(issues) > SHOWN_ROWS:
        layout.label(text=f"and {len(issues) - SHOWN_ROWS} more")
    if sum(issue.has_place for issue in issues) > 1 and not report.with_modifiers:
        layout.operator("mesh.wirewarp_select_issues", text="Select All Problems", icon="RESTRICT_SELECT_OFF")
    if any(issue.code == "multi_user_scale" for issue in issues):
        button = layout.operator("object.make_single_user", text="Make Single User")
        button.object = button.obdata = True


def draw_hints(context: bpy.types.Context, layout: bpy.types.UILayout, report: ObjectReport) -> None:
    """Under the advice, the places where it would help."""
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
    """The text, and if it has a place the button that selects what it is about."""
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
