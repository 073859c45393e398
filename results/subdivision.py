# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the subsection on subdivision: how E of the quarter sphere with rigid wires changes on finer meshes."""

from __future__ import annotations

from measures import summarize
from methods import flatten
from shapes import quarter_sphere
from text import table

SEGMENTS = (16, 32, 64, 128)


def subsection() -> str:
    rows, found = [], []
    for segments in SEGMENTS:
        shape = quarter_sphere(segments)
        angles, refined = (
            summarize(shape.vertices, flatten(shape, method=method)) for method in ("wirewarping", "refined")
        )
        found.append((angles.energy, refined.energy))
        rows.append([
            f"{len(shape.triangles())}",
            f"{angles.energy:.5f}",
            f"{refined.energy:.5f}",
            str(refined.factorizations),
        ])  # fmt: skip
    by_angles, by_shape = (abs(b / a - 1) for a, b in zip(*found[-2:], strict=True))
    return f"""### Subdivision

{table(["triangles", "*E*: WireWarping", "Refined", "factorizations"], rows)}

Both wires of the quarter sphere are rigid, and every row has a finer mesh. In the last row, *E* of WireWarping differs
by {100 * by_angles:.1f}% from the row above, and *E* of Refined by {100 * by_shape:.1f}%.
"""
