# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the section on Fig. 1: the quarter sphere with both wires rigid, one elastic, and both elastic."""

from __future__ import annotations

from inputs import Inputs, with_tolerances
from maps import MAPS
from measures import Summary, summarize
from methods import flatten, paper_warping
from palette import percent
from sheet import Column, draw_sheet
from text import change, degrees, picture, table

TOLERANCE = 0.10
RIGID, ONE, BOTH = [0.0, 0.0], [TOLERANCE, 0.0], [TOLERANCE, TOLERANCE]
CASES = {  # by title: method, and tolerances of both wires
    "WireWarping:\nboth wires rigid": ("wirewarping", RIGID),
    "Refined:\nboth wires rigid": ("refined", RIGID),
    f"WireWarping++:\nmeridian elastic, ±{100 * TOLERANCE:.0f}%": ("wirewarp++", ONE),
    f"WireWarping++:\nboth elastic, ±{100 * TOLERANCE:.0f}%": ("wirewarp++", BOTH),
    f"Refined:\nmeridian elastic, ±{100 * TOLERANCE:.0f}%": ("refined", ONE),
    f"Refined:\nboth elastic, ±{100 * TOLERANCE:.0f}%": ("refined", BOTH),
}
DRAWN = 4  # number of drawn cases, from the first
HEADER = ["", "*E*", "max *E_r*", "Meridian", "Cross arc", "angles: rms", "largest", "flipped"]


def row(title: str, found: Summary) -> list[str]:
    return [
        title,
        f"{found.energy:.4f}",
        f"{found.max_aspect_ratio:.2f}",
        *(percent(wire.change) for wire in found.wires),
        degrees(found.angle_rms),
        degrees(found.angle_max),
        str(found.flipped),
    ]


def section(inputs: Inputs) -> str:
    columns = []
    for title, (method, tolerances) in CASES.items():
        shape = with_tolerances(inputs.shapes["Quarter sphere"], tolerances)
        columns.append(Column(title, shape, flatten(shape, method=method)))
    path = inputs.pictures / "figure_1.png"
    draw_sheet(path, columns[:DRAWN], MAPS, view=(-62, 10), label_wires=True)

    found = [summarize(column.shape.vertices, column.result) for column in columns]
    rigid, refined, one, both, _, refined_both = found
    first = summarize(columns[0].shape.vertices, paper_warping(columns[0].shape))
    meridian, across = (percent(line.change) for line in both.wires)
    rows = [row(column.title.replace("\n", " "), s) for column, s in zip(columns, found, strict=True)]
    return f"""## Fig. 1: quarter sphere

{picture("Quarter sphere: four flattenings, lengths, aspect ratio and ARAP energy", path)}

{table(HEADER, rows)}

In the columns of the wires, − is shorter and + is longer. The outline keeps its length in all cases. If both wires are
rigid, they must bend to the sides, and *E_r* reaches {rigid.max_aspect_ratio:.2f} beside them. With an elastic
meridian, which changes by {percent(one.wires[0].change)}, *E* {change(rigid.energy, one.energy)}. If both wires are
elastic, they change by {meridian} and {across}, *E* {change(rigid.energy, both.energy)} from the rigid case, and the
largest *E_r* is {both.max_aspect_ratio:.2f}. This reproduces the paper's figure qualitatively. Our surface is a quarter
sphere without its tips. The paper uses the first angles that close all loops, and equal weights. With these options
(`inner="least-norm"`, `node_weight="uniform"`), *E* of the rigid case is {first.energy:.4f} instead of
{rigid.energy:.4f}. The refined method, second in the picture, keeps the lengths of outline and rigid
wires, too. Compared with the paper's methods, *E* of the rigid case {change(rigid.energy, refined.energy)}, and *E*
with both wires elastic {change(both.energy, refined_both.energy)}.
"""
