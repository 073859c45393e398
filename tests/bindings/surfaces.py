# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes small surfaces as grids of triangles."""

import math
from collections.abc import Callable

import numpy as np

Mesh = tuple[np.ndarray, np.ndarray]


def grid(columns: int, rows: int, point: Callable[[float, float], tuple[float, float, float]]) -> Mesh:
    """Return a grid of triangles. Its vertex j * (columns + 1) + i is at point(i / columns, j / rows).

    The faces point along the cross product of the derivatives of `point` by its two arguments.
    """
    vertices = [point(i / columns, j / rows) for j in range(rows + 1) for i in range(columns + 1)]
    faces = []
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            b = a + columns + 1
            faces += [(a, a + 1, b + 1), (a, b + 1, b)]
    return np.array(vertices), np.array(faces)


def half_cylinder(columns: int = 8, rows: int = 4) -> Mesh:
    """Return an open half cylinder of radius 1 and height 2."""
    return grid(columns, rows, lambda u, v: (-math.cos(math.pi * u), -math.sin(math.pi * u), 2 * v))


def spherical_patch(columns: int = 8, rows: int = 8) -> Mesh:
    """Return a quarter turn, in longitude and latitude, of the unit sphere. Its faces point outward."""

    def point(u: float, v: float) -> tuple[float, float, float]:
        longitude, latitude = math.pi / 2 * (u - 0.5), math.pi / 2 * (v - 0.5)
        return (math.cos(latitude) * math.cos(longitude), math.cos(latitude) * math.sin(longitude), math.sin(latitude))

    return grid(columns, rows, point)


def tetrahedron() -> Mesh:
    return np.eye(4, 3, -1), np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])


def column_chain(columns: int, rows: int, i: int) -> list[int]:
    """Return the vertices of column i of a grid, row by row."""
    return [j * (columns + 1) + i for j in range(rows + 1)]


def chain_edges(chain: list[int]) -> list[tuple[int, int]]:
    return list(zip(chain, chain[1:], strict=False))
