# SPDX-License-Identifier: GPL-3.0-or-later
"""What failed, a sentence each, with the buttons that mend it."""

import bpy

from ..tolerance_text import tolerance_text
from .report_table import SHOWN_ROWS
from .text import draw_sentence


def draw_issues(context: bpy.types.Context, layout: bpy.types.UILayout, report: dict) -> None:
    issues = report["issues"]
    for index, issue in enumerate(issues[:SHOWN_ROWS]):
        where = "" if issue["piece"] is None else f"{report['pieces'][issue['piece']]['name']}: "
        draw_sentence(context, layout, where + issue["sentence"], "ERROR", spare=16)
        _draw_proposals(context, layout, index, issue)
    if len(issues) > SHOWN_ROWS:
        layout.label(text=f"and {len(issues) - SHOWN_ROWS} more")
    if any(issue["vertices"] or issue["edges"] or issue["faces"] for issue in issues):
        layout.operator("mesh.wirewarp_select_issues", icon="RESTRICT_SELECT_OFF")
    if any(issue["code"] == "multi_user_scale" for issue in issues):
        button = layout.operator("object.make_single_user", text="Make Single User")
        button.object = button.obdata = True


def _draw_proposals(context: bpy.types.Context, layout: bpy.types.UILayout, index: int, issue: dict) -> None:
    """A stored report of an earlier version has none."""
    seams, wires = issue.get("proposed_seams"), issue.get("proposed_tolerances")
    if seams:
        count = "1 Edge" if len(seams) == 1 else f"{len(seams)} Edges"
        _draw_button(layout, "SEAMS", index, f"Mark {count} as Seam", "EDGESEL")
    if wires:
        named = ", ".join(f"{wire['name']} {tolerance_text(wire['tolerance'])}" for wire in wires[:SHOWN_ROWS])
        named += f" and {len(wires) - SHOWN_ROWS} more" if len(wires) > SHOWN_ROWS else ""
        draw_sentence(context, layout, named, "BLANK1", spare=16)
        _draw_button(layout, "TOLERANCES", index, "Loosen Wires", "FIXED_SIZE")


def _draw_button(layout: bpy.types.UILayout, what: str, index: int, text: str, icon: str) -> None:
    button = layout.operator("mesh.wirewarp_take_proposal", text=text, icon=icon)
    button.what, button.issue = what, index
