# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the paper's quarter sphere with two wires (Fig. 1), and a ball of six gores."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .fan import add_sector
from .shape import Shape, ShapeBuilder

QUARTER_SPHERE_RADIUS = 0.10
BALL_RADIUS = 0.11  # meters: a football


def quarter_sphere(segments: int = 28, cap: float = np.radians(20)) -> Shape:
    """Return a quarter sphere without its tips, with two wires: the middle meridian and the arc across it.

    cap: polar angle of the tips that are left out, in radians.
    """
    builder = ShapeBuilder()
    polar = np.linspace(np.pi - cap, cap, 2 * segments + 1)[:, None]
    longitude = np.linspace(-np.pi / 4, np.pi / 4, segments + 1)[None, :]
    grid = builder.add_points(QUARTER_SPHERE_RADIUS * _direction(polar, longitude))
    for row, (lower, upper) in enumerate(zip(grid[:-1], grid[1:], strict=True)):
        for column, (a, b, c, d) in enumerate(zip(lower[:-1], lower[1:], upper[1:], upper[:-1], strict=True)):
            for face in ((a, b, d), (b, c, d)) if (row + column) % 2 else ((a, b, c), (a, c, d)):
                builder.add_face(face)
    builder.add_wire(grid[:, segments // 2], "Meridian")
    builder.add_wire(grid[segments], "Cross arc")
    return builder.build("Quarter sphere", cloth="swim")


def ball(rows: int = 17, gores: int = 6) -> Shape:
    """Return a ball of gores. Its equator is a closed wire through all gores."""
    builder = ShapeBuilder()
    equator = []
    for gore in range(gores):
        begin, end = 2 * np.pi * gore / gores, 2 * np.pi * (gore + 1) / gores
        for pole in (1, -1):
            fan = add_sector(builder, _hemisphere(BALL_RADIUS, rows, pole), begin, end, rows, flip=pole < 0)
            builder.add_seam(np.array([row[0] for row in fan]))
        equator += list(fan[-1][:-1])
    builder.add_wire(np.array([*equator, equator[0]]), "Equator")
    return builder.build("Ball of six gores", cloth="jersey")


def _hemisphere(radius: float, rows: int, pole: int) -> Callable[[int, np.ndarray], np.ndarray]:
    return lambda row, longitudes: radius * _direction(np.pi / 2 * row / rows, longitudes) * [1, 1, pole]


def _direction(polar: np.ndarray | float, longitude: np.ndarray) -> np.ndarray:
    """Return unit vectors (..., 3) at polar angles from +z and longitudes."""
    x, y = np.sin(polar) * np.cos(longitude), np.sin(polar) * np.sin(longitude)
    return np.stack(np.broadcast_arrays(x, y, np.cos(polar)), axis=-1)
