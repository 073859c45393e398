# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes surfaces whose meshes unroll without distortion."""

from __future__ import annotations

import numpy as np

from .shape import Shape, ShapeBuilder


def half_cylinder(segments: int = 40, radius: float = 0.10, height: float = 0.22) -> Shape:
    """Return half a tube with three wires: a ruling, a half ring, and a helix, which unrolls to a straight line."""
    builder = ShapeBuilder()
    angles = np.linspace(-np.pi / 2, np.pi / 2, segments + 1)
    heights = np.linspace(0, height, segments + 1)
    around = np.stack([radius * np.cos(angles), radius * np.sin(angles), np.zeros_like(angles)], axis=-1)
    grid = builder.add_points(around[None, :, :] + heights[:, None, None] * np.array([0.0, 0.0, 1.0]))
    for lower, upper in zip(grid[:-1], grid[1:], strict=True):
        for a, b, c, d in zip(lower[:-1], lower[1:], upper[1:], upper[:-1], strict=True):
            builder.add_face((a, b, c))
            builder.add_face((a, c, d))
    middle = segments // 2
    builder.add_wire(grid[:, middle], "Ruling")
    builder.add_wire(grid[middle], "Half ring")
    builder.add_wire(np.diagonal(grid), "Helix")
    return builder.build("Half cylinder")


def lampshade(
    segments: int = 72, rows: int = 18, top_radius: float = 0.06, radius: float = 0.14, height: float = 0.16
) -> Shape:
    """Return a cone without its tip, with a seam along a ruling, planar quads and a closed wire around its middle."""
    builder = ShapeBuilder()
    angles = np.linspace(0, 2 * np.pi, segments + 1)
    up = np.linspace(0, 1, rows + 1)
    radii = radius + (top_radius - radius) * up
    points = np.stack(
        [radii[:, None] * np.cos(angles), radii[:, None] * np.sin(angles), np.outer(height * up, np.ones_like(angles))],
        axis=-1,
    )
    grid = builder.add_grid(points)
    builder.add_seam(grid[:, 0])
    builder.add_wire(grid[rows // 2], "Middle ring")
    return builder.build("Lampshade")
