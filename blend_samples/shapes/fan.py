# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangle fans with even triangles from the pole outward: row k of a sector has k edges."""

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
    """Fill the sector of longitudes begin..end around a pole. Return the vertices of each row, pole first.

    surface(row, longitudes) returns the points (c, 3) of a row; row 0 is the pole. Faces point in the direction of the
    pole if longitudes increase, or in the opposite one if flipped.
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
