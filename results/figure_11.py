# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the section on Fig. 11: a toy and a piece of furniture."""

from __future__ import annotations

from inputs import Inputs
from maps import ASPECT_RATIO, LENGTHS
from measures import summarize
from methods import KEEPING_LENGTHS
from palette import plain_percent
from sheet import Column, draw_sheet
from text import change, differ, millimeters, picture, table

VIEWS = {"Toy": (-24, 10), "Armchair cover": (-34, 26)}
HEADER = ["", "pieces", "*E*", "max *E_r*", "worst outline", "most changed elastic wire", "seam sides differ, mm"]


def section(inputs: Inputs) -> str:
    pictures, rows, sentences = [], [], []
    mismatch = 0.0
    for name, view in VIEWS.items():
        shape = inputs.shapes[name]
        columns = [Column(method, shape, inputs.by_all_methods(name)[method]) for method in KEEPING_LENGTHS]
        path = inputs.pictures / f"figure_11_{name.lower().replace(' ', '_')}.png"
        draw_sheet(path, columns, [LENGTHS, ASPECT_RATIO], view, aspect=1.5)
        pictures.append(picture(f"{name}: model, pieces, lengths and aspect ratio", path))
        found = [summarize(shape.vertices, column.result) for column in columns]
        for column, s in zip(columns, found, strict=True):
            rows.append([
                f"{name}, {column.title}",
                str(len(column.result.pieces)),
                f"{s.energy:.5f}",
                f"{s.max_aspect_ratio:.2f}",
                plain_percent(max((line.change for line in s.outline), key=abs), 2),
                plain_percent(max(s.changes, key=abs), 2),
                millimeters(s.seam_mismatch),
            ])  # fmt: skip
        rigid, elastic, refined = found
        mismatch = max(mismatch, *(s.seam_mismatch for s in found))
        limit = sum(abs(h) > 0.05 - 1e-6 for h in elastic.changes)
        sentences.append(
            f"{name}: with the tolerances, *E* {change(rigid.energy, elastic.energy)} and the largest *E_r* "
            f"{change(rigid.max_aspect_ratio, elastic.max_aspect_ratio)}, and {limit} of {len(elastic.changes)} "
            "elastic "
            "parts are at the limit of ±5%. From WireWarping++ to Refined, *E* "
            f"{change(elastic.energy, refined.energy)}."
        )
    return f"""## Fig. 11: toy and furniture

{chr(10).join(pictures)}

{table(HEADER, rows)}

{" ".join(sentences)} Outlines and seams stay rigid. If the outline of a piece causes most of its distortion,
a tolerance of its wires gains little. Two sides of a seam {differ(mismatch)}.
The paper shows pieces for a toy and for furniture, without numbers. Our bear and armchair are different models.
"""
