# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes fans of even triangles around a pole. Row k of a sector has k edges."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .shape import ShapeBuilder


def add_sector(
    builder: ShapeBuilder,
    surface: Callable[[int, np.ndarray], np.ndarray],
    begin: float,
    end: float,
    rows: int,
    flip: bool = False,
) -> list[np.ndarray]:
    """Fill the sector of longitudes begin to end around a pole. Return the vertices of each row, pole first.

    surface(row, longitudes) returns the points (c, 3) of a row. Row 0 is the pole. If longitudes increase, faces point
    in the direction of the pole, or in the opposite direction if flip is true.
    """
    fan = []
    for row in range(rows + 1):
        longitudes = np.linspace(begin, end, row + 1) if row else np.array([begin])
        fan.append(builder.add_points(surface(row, longitudes)))
    for inner, outer in zip(fan[:-1], fan[1:], strict=True):
        for i in range(len(inner)):
            builder.add_face((inner[i], outer[i], outer[i + 1]), flip)
            if i + 1 < len(inner):
                builder.add_face((inner[i], outer[i + 1], inner[i + 1]), flip)
    return fan
