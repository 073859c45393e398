# SPDX-License-Identifier: GPL-3.0-or-later
"""A table of lengths: four columns where the sidebar is wide, one number a line where it is narrow."""

import bpy

from ..unit_text import LengthText, length_text
from .report_rows import ReportRow, Side
from .text import broken, draw_cells, is_wide

SHOWN_ROWS = 8


def draw_table(context: bpy.types.Context, layout: bpy.types.UILayout, rows: list[ReportRow]) -> None:
    text = length_text(context.scene)
    column = layout.column(align=True)
    wide = is_wide(context)
    if wide:
        draw_cells(column, "", [f"3D {text.unit}", f"Flat {text.unit}", "Diff.", "%"], 0.2)
    for row in rows if context.scene.wirewarp.show_all else rows[:SHOWN_ROWS]:
        draw_heading(context, column, row.name, row.ok, "SEAM", row.seam)
        if row.tolerance:
            column.label(text=row.tolerance, icon="INFO" if row.at_limit else "BLANK1")
        (_draw_wide if wide else _draw_narrow)(column, row, text)
        column.separator(factor=0.7)
    if len(rows) > SHOWN_ROWS:
        layout.prop(context.scene.wirewarp, "show_all", text=f"Show All {len(rows)}")


def draw_heading(
    context: bpy.types.Context, layout: bpy.types.UILayout, name: str, ok: bool, what: str, index: int | None
) -> None:
    """A name with its tick or cross and, where there is an index, the button that selects it."""
    row = layout.row(align=True)
    text = row.column(align=True)
    for number, line in enumerate(broken(context, name, spare=0 if index is None else 22)):
        text.label(text=line, icon="BLANK1" if number else "CHECKMARK" if ok else "CANCEL")
    if index is not None:
        draw_select(row, what, index)


def draw_select(row: bpy.types.UILayout, what: str, index: int) -> None:
    button = row.operator("mesh.wirewarp_select_result", text="", icon="RESTRICT_SELECT_OFF", emboss=False)
    button.what, button.index = what, index


def _draw_wide(column: bpy.types.UILayout, row: ReportRow, text: LengthText) -> None:
    for side in row.sides:
        flat, difference, percent = _flat_numbers(side, text)
        draw_cells(column, side.label, [text.number(side.length_3d), flat, difference, percent], 0.2)


def _draw_narrow(column: bpy.types.UILayout, row: ReportRow, text: LengthText) -> None:
    draw_cells(column, "3D", [text(row.sides[0].length_3d)], 0.4)
    for side in row.sides:
        flat, difference, percent = _flat_numbers(side, text)
        draw_cells(column, side.label or "Flat", [f"{flat} {text.unit}" if percent else flat], 0.4)
        if percent:
            draw_cells(column, "   diff.", [f"{difference}  {percent}%"], 0.25)


def _flat_numbers(side: Side, text: LengthText) -> tuple[str, str, str]:
    """Flat length, difference and percent; no percent without a layout."""
    if side.length_2d is None:
        return "no layout", "", ""
    percent = f"{abs(side.percent):.3f}" if abs(side.percent) < 5e-4 else f"{side.percent:+.3f}"
    return text.number(side.length_2d), text.difference(side.difference), percent
