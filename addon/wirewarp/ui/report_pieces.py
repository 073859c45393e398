# SPDX-License-Identifier: GPL-3.0-or-later
"""The pieces of a report: area, and what their cloth must do."""

import bpy

from ..cloth import percent_text
from ..length_units import LengthText
from ..unit_text import length_text
from .report_rows import PieceRow
from .report_table import draw_heading, draw_more, draw_select, shown_rows
from .text import draw_cells, draw_sentence

NO_STRAIN = 5e-4  # what is shown as 0.0 %


def draw_pieces(context: bpy.types.Context, layout: bpy.types.UILayout, rows: list[PieceRow]) -> None:
    text = length_text(context.scene)
    column = layout.column(align=True)
    for row in rows[: shown_rows(context)]:
        draw_heading(context, column, row.name, row.ok, "PIECE" if row.has_layout else None, row.index)
        _draw_piece(context, column, row, text)
        column.separator(factor=0.7)
    draw_more(context, layout, len(rows))


def _draw_piece(context: bpy.types.Context, column: bpy.types.UILayout, row: PieceRow, text: LengthText) -> None:
    draw_cells(column, "Model", [text.area(row.area_3d)], 0.3)
    if not row.has_layout:
        draw_cells(column, "Flat", ["not laid flat"], 0.3)
        return
    draw_cells(column, "Flat", [text.area(row.area_2d)], 0.3)
    change = row.area_2d / row.area_3d - 1
    draw_cells(column, " diff.", [f"{100 * change:+.2f}%" if abs(change) >= 5e-5 else "0.00%"], 0.3)
    if max(row.stretch, row.ease) < NO_STRAIN:
        draw_sentence(context, column, "Lies flat without any stretch")
    if row.stretch >= NO_STRAIN:
        _draw_place(column, "Stretch up to", row.stretch, "STRETCH", row.index)
    if row.ease >= NO_STRAIN:
        _draw_place(column, "Ease up to", row.ease, "EASE", row.index)


def _draw_place(column: bpy.types.UILayout, label: str, share: float, what: str, index: int) -> None:
    row = column.row(align=True)
    draw_cells(row, label, [percent_text(share)], 0.5)
    draw_select(row, what, index)
