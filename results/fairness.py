# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the subsection on the fairness of the refined method: its effect on shape, energy and angles."""

from __future__ import annotations

from inputs import Inputs, with_tolerances
from maps import ARAP_ENERGY
from measures import summarize
from methods import flatten
from sheet import Column, draw_sheet
from text import degrees, picture, table

VALUES = (0.05, 0.1, 0.2, 0.4)
DRAWN = {"Quarter sphere": (-62, 10), "Wetsuit collar": (-24, 18)}  # rotation and tilt of the model in degrees
HEADER = ["", "*E*", "max *E_r*", "angles: rms", "largest", "factorizations"]


def subsection(inputs: Inputs) -> str:
    pictures, rows = [], []
    for name, view in DRAWN.items():
        sample = inputs.shapes[name]
        shape = with_tolerances(sample, [0.0] * len(sample.wires))
        columns = [Column(f"fairness {value:g}", shape, flatten(shape, fairness=value)) for value in VALUES]
        path = inputs.pictures / f"fairness_{name.lower().replace(' ', '_')}.png"
        draw_sheet(path, columns, [ARAP_ENERGY], view)
        pictures.append(picture(f"{name} by the refined method with four values of fairness", path))
        for column in columns:
            found = summarize(shape.vertices, column.result)
            rows.append([
                f"{name}, {column.title}",
                f"{found.energy:.4f}",
                f"{found.max_aspect_ratio:.2f}",
                degrees(found.angle_rms),
                degrees(found.angle_max),
                str(found.factorizations),
            ])  # fmt: skip
    return f"""### Fairness

{chr(10).join(pictures)}

{table(HEADER, rows)}

All wires are rigid. Fairness is the shortest wavelength that is not smoothed in outlines and wires, divided by the
square root of the piece's area. Lengths are exact for every value. With larger values, lines are smoother and the
fabric between them is more distorted. Without fairness, rigid outlines would buckle into zigzags. The default is 0.05.
"""
