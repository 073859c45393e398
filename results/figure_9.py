# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the section on Fig. 9: the upper body of a wetsuit."""

from __future__ import annotations

from inputs import Inputs
from maps import MAPS
from measures import summarize
from methods import KEEPING_LENGTHS
from palette import percent
from sheet import Column, draw_sheet
from text import change, count, differ, picture, table


def section(inputs: Inputs) -> str:
    shape = inputs.shapes["Wetsuit upper body"]
    columns = [Column(name, shape, inputs.by_all_methods(shape.name)[name]) for name in KEEPING_LENGTHS]
    path = inputs.pictures / "figure_9.png"
    draw_sheet(path, columns, MAPS, view=(-28, 8), aspect=1.5)

    found = [summarize(shape.vertices, column.result) for column in columns]
    rigid, elastic, refined = found
    both = [column.result.pieces for column in columns[1:]]
    parts = [
        [f"piece {k + 1}", first.name, *(percent(part.variation, 2) for part in (first, second))]
        for k, pieces in enumerate(zip(*both, strict=True))
        for first, second in zip(*(piece.wires for piece in pieces), strict=True)
        if first.kind == "elastic"
    ]
    at_limit = sum(abs(h) > 0.05 - 1e-6 for h in elastic.changes)
    pieces = count(len(columns[-1].result.pieces), "piece", "pieces")
    return f"""## Fig. 9: upper body of a wetsuit

{picture("Upper body of a wetsuit: model, pieces, maps", path)}

The suit is cut into {pieces}. The bust and waist lines are rigid, and the other wires may change by ±5%. The outline
and the rigid wires keep their lengths in all three flattenings, and two sides of a seam
{differ(max(s.seam_mismatch for s in found))}. From WireWarping to WireWarping++, *E*
{change(rigid.energy, elastic.energy)} and the largest *E_r* {change(rigid.max_aspect_ratio, elastic.max_aspect_ratio)}.
Of {len(elastic.changes)} elastic parts of wires, {at_limit} {"is" if at_limit == 1 else "are"} at the limit of the
tolerance. The paper only shows the elastic result. From WireWarping++ to Refined, with the same tolerances, *E*
{change(elastic.energy, refined.energy)} and the largest *E_r*
{change(elastic.max_aspect_ratio, refined.max_aspect_ratio)}. An elastic wire across several pieces has its own change
of length in each piece:

{table(["", "wire", "WireWarping++", "Refined"], parts)}
"""
