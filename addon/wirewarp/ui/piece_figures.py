# SPDX-License-Identifier: GPL-3.0-or-later
"""Of one piece: its area, and what its cloth must do."""

import bpy

from ..cloth import percent_text
from ..unit_text import length_text
from .report_rows import PieceRow
from .report_table import draw_select
from .text import draw_cells, draw_sentence

NO_STRAIN = 5e-4  # what is shown as 0.0 %


def draw_figures(context: bpy.types.Context, layout: bpy.types.UILayout, row: PieceRow) -> None:
    text, column = length_text(context.scene), layout.column(align=True)
    draw_cells(column, "Area, model", [text.area(row.area_3d)], 0.45)
    if not row.has_layout:
        draw_cells(column, "Area, flat", ["not laid flat"], 0.45)
        return
    draw_cells(column, "Area, flat", [text.area(row.area_2d)], 0.45)
    change = row.area_2d / row.area_3d - 1
    draw_cells(column, " diff.", [f"{100 * change:+.2f}%" if abs(change) >= 5e-5 else "0.00%"], 0.45)
    if row.strain < NO_STRAIN:
        draw_sentence(context, column, "Lies flat without any stretch")
    if row.stretch >= NO_STRAIN:
        _draw_place(column, "Stretch up to", row.stretch, "STRETCH", row.index)
    if row.ease >= NO_STRAIN:
        _draw_place(column, "Ease up to", row.ease, "EASE", row.index)


def _draw_place(column: bpy.types.UILayout, label: str, share: float, what: str, index: int) -> None:
    row = column.row(align=True)
    draw_cells(row, label, [percent_text(share)], 0.5)
    draw_select(row, what, index)
