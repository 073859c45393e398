# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes limbs for rectangular holes of a grid: loops around a hole, tubes and caps."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .curves import hermite_curves
from .shape import ShapeBuilder


@dataclass(frozen=True)
class Hole:
    """A hole in a grid of quads. The seam along its middle column ends at its border."""

    row: int  # lowest row of vertices of the hole
    column: int  # column of vertices of the seam
    rows: int  # height in quads
    half_width: int  # width in quads to each side of the seam

    def cut(self, holes: np.ndarray) -> None:
        """Set `holes` (r - 1, c - 1) to true for the quads of the hole."""
        columns = slice(self.column - self.half_width, self.column + self.half_width)
        holes[self.row : self.row + self.rows, columns] = True

    def loop(self, grid: np.ndarray) -> np.ndarray:
        """Return the closed border, counter-clockwise as seen from outside, starting at the seam below the hole."""
        left, right = self.column - self.half_width, self.column + self.half_width
        top = self.row + self.rows
        return np.concatenate([
            grid[self.row, self.column : right], grid[self.row : top, right], grid[top, right:left:-1],
            grid[top : self.row : -1, left], grid[self.row, left : self.column + 1],
        ])  # fmt: skip


def tube(
    loop: np.ndarray, center: np.ndarray, axis: np.ndarray, radius: float, fullness: float, rows: int
) -> np.ndarray:
    """Return points (rows + 1, n + 1, 3) of a tube from a closed loop (n + 1, 3) to a circle.

    center, axis, radius: of the circle; fullness: distance over which the tube is straight before it bends.
    """
    axis, leave = axis / np.linalg.norm(axis), loop_normal(loop)
    up = np.array([0.0, 0.0, 1.0]) - axis[2] * axis
    up /= np.linalg.norm(up)
    angle = np.linspace(0, 2 * np.pi, len(loop))[:, None]
    ring = center + radius * (np.sin(angle) * np.cross(up, axis) - np.cos(angle) * up)
    points = hermite_curves(loop, fullness * leave, ring, fullness * axis, rows)
    points[:, -1] = points[:, 0]
    return points


def loop_normal(loop: np.ndarray) -> np.ndarray:
    """Return the unit normal of a closed loop (n + 1, 3), toward the side from which it is counter-clockwise."""
    normal = np.cross(loop[:-1] - loop.mean(axis=0), loop[1:] - loop.mean(axis=0)).sum(axis=0)
    return normal / np.linalg.norm(normal)


def add_cap(builder: ShapeBuilder, ring: np.ndarray, height: float, flip: bool) -> np.ndarray:
    """Close a tube's round end of 16 edges (17, 3) with a dome. Return the vertices of the dome."""
    center = ring[:-1].mean(axis=0)
    normal = loop_normal(ring) * (-1 if flip else 1)
    halfway = center + 0.55 * (ring[::2] - center) + (1 - 0.55**2) * height * normal
    outer, inner = builder.add_points(ring), builder.add_points(halfway)
    middle = builder.add_points(center + height * normal)
    for k in range(8):
        a, b = inner[k], inner[k + 1]
        builder.add_face((outer[2 * k], outer[2 * k + 1], a), flip)
        builder.add_face((outer[2 * k + 1], b, a), flip)
        builder.add_face((outer[2 * k + 1], outer[2 * k + 2], b), flip)
        builder.add_face((a, b, middle), flip)
    return np.array([*outer, *inner, middle])
