# SPDX-License-Identifier: GPL-3.0-or-later
"""Fig. 1: the quarter sphere with both wires rigid, one of them elastic, both elastic."""

from __future__ import annotations

from inputs import Inputs, with_tolerances
from maps import MAPS
from measures import summarize
from methods import flatten, paper_warping
from palette import percent
from sheet import Column, draw_sheet
from text import change, picture

TOLERANCE = 0.10
CASES = {
    "Both wires rigid": [0.0, 0.0],
    f"Meridian elastic, ±{100 * TOLERANCE:.0f} %": [TOLERANCE, 0.0],
    f"Both elastic, ±{100 * TOLERANCE:.0f} %": [TOLERANCE, TOLERANCE],
}


def section(inputs: Inputs) -> str:
    columns = []
    for title, tolerances in CASES.items():
        shape = with_tolerances(inputs.shapes["Quarter sphere"], tolerances)
        columns.append(Column(title, shape, flatten(shape)))
    path = inputs.pictures / "figure_1.png"
    draw_sheet(path, columns, MAPS, view=(-62, 10), cell_width=2.5, label_wires=True)

    rigid, one, both = (summarize(column.shape.vertices, column.result) for column in columns)
    first = summarize(columns[0].shape.vertices, paper_warping(columns[0].shape))
    meridian, across = (percent(line.change) for line in both.wires)
    return f"""## Fig. 1: quarter sphere

{picture("Quarter sphere: three flattenings, lengths, aspect ratio and ARAP energy", path)}

*Shorter is −, longer is +; the outline keeps its length in all three.* With both wires rigid they have no choice but to
swing out to the sides, and beside them *E_r* reaches {rigid.max_aspect_ratio:.2f}. With an elastic
meridian, which changes by {percent(one.wires[0].change)}, *E* {change(rigid.energy, one.energy)}; with both
elastic, at {meridian} and {across}, it {change(rigid.energy, both.energy)} from the rigid case, and the largest *E_r*
is {both.max_aspect_ratio:.2f}. This is the paper's figure in kind. Ours is a quarter sphere without its tips. With the
first angles that close all loops, as in the paper, and equal weights (`inner="least-norm"`, `node_weight="uniform"`)
*E* of the rigid case is {first.energy:.4f} in place of {rigid.energy:.4f}.
"""
