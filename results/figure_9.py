# SPDX-License-Identifier: GPL-3.0-or-later
"""Fig. 9: the upper body of a wetsuit."""

from __future__ import annotations

from inputs import Inputs
from maps import MAPS
from measures import summarize
from palette import percent
from sheet import Column, draw_sheet
from text import change, count, millimeters, picture, table

METHODS = ("WireWarping", "WireWarping++")


def section(inputs: Inputs) -> str:
    shape = inputs.shapes["Wetsuit upper body"]
    columns = [Column(name, shape, inputs.by_all_methods(shape.name)[name]) for name in METHODS]
    path = inputs.pictures / "figure_9.png"
    draw_sheet(path, columns, MAPS, view=(-28, 8), cell_width=4.4, aspect=1.5)

    rigid, elastic = (summarize(shape.vertices, column.result) for column in columns)
    parts = [
        [f"piece {k + 1}", part.name, percent(part.variation, 2), percent(part.tolerance, 0).replace("+", "±")]
        for k, piece in enumerate(columns[-1].result.pieces)
        for part in piece.wires
        if part.kind == "elastic"
    ]
    at_limit = sum(abs(h) > 0.05 - 1e-6 for h in elastic.changes)
    pieces = count(len(columns[-1].result.pieces), "piece", "pieces")
    return f"""## Fig. 9: upper body of a wetsuit

{picture("Upper body of a wetsuit: model, pieces, maps", path)}

The suit is cut into {pieces}; bust and waist line are rigid, the other wires may change by ±5 %. The outline and the
rigid wires keep their lengths in both flattenings, and two sides of a seam differ by at most
{millimeters(max(rigid.seam_mismatch, elastic.seam_mismatch))} mm.
With the tolerances *E* {change(rigid.energy, elastic.energy)}, the largest *E_r*
{change(rigid.max_aspect_ratio, elastic.max_aspect_ratio)}; of {len(elastic.changes)} elastic parts of wires
{count(at_limit, "lies", "lie")} at the limit of the tolerance. The paper shows the elastic result alone. Elastic wires
across several pieces have a length of their own in each:

{table(["", "wire", "length variation", "tolerance"], parts)}
"""
