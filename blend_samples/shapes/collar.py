# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the collar of a wetsuit: a piece close to the skin from the shoulders up the neck, open behind (Fig. 8)."""

from __future__ import annotations

import numpy as np

from .curves import chord_lengths, cubic_spline, hermite_curves
from .shape import Shape, ShapeBuilder

# HEM is the neckline on chest and shoulders, and TOP is the upper edge on the neck. Both have the wearer's left half,
# from the middle of the front over the shoulder to the middle of the back: x left, y back, z up, in meters.
HEM = np.array([
    [0.000, -0.095, -0.078], [0.044, -0.081, -0.062], [0.077, -0.037, -0.030], [0.090, 0.009, -0.010],
    [0.073, 0.048, -0.004], [0.040, 0.068, -0.006], [0.000, 0.073, -0.008],
])  # fmt: skip
TOP = np.array([
    [0.000, -0.074, 0.074], [0.034, -0.062, 0.078], [0.054, -0.026, 0.086], [0.058, 0.008, 0.093],
    [0.048, 0.034, 0.097], [0.026, 0.048, 0.099], [0.000, 0.052, 0.100],
])  # fmt: skip
OPENING = 0.012  # meters: half the width of the gap at the back, at hem and top
SPREAD = 0.055  # meters: distance inward from the hem over which the skin turns up the neck
SLOPES = (1.3, 2.4)  # slopes of the skin at the hem (rise over distance inward) on the shoulder and on the chest
RISE = 0.105  # meters: velocity of the curves at the top; larger values make the neck straighter
TOLERANCE = 0.05


def wetsuit_collar(half_columns: int = 34, rows: int = 24) -> Shape:
    """Return the collar with two elastic wires: around the base of the neck, and down the middle of the front."""
    builder = ShapeBuilder()
    left = _half(half_columns, rows)
    grid = builder.add_grid(np.concatenate([left[:, :0:-1] * [-1, 1, 1], left], axis=1))
    builder.add_wire(grid[rows // 2], "Base of the neck", TOLERANCE)
    builder.add_wire(grid[:, half_columns], "Center front", TOLERANCE)
    return builder.build("Wetsuit collar", cloth="neoprene")


def _half(columns: int, rows: int) -> np.ndarray:
    """Return points (rows + 1, columns + 1, 3) from the hem up, from the middle of the front to the gap at the back."""
    hem, top = _round(HEM, columns), _round(TOP, columns)
    inward = (top - hem) * [1, 1, 0]
    inward = inward / np.linalg.norm(inward, axis=1, keepdims=True)
    chest = (HEM[:, 2].max() - hem[:, 2:]) / np.ptp(HEM[:, 2])  # 1 on the chest, 0 on the shoulder
    slope = SLOPES[0] + (SLOPES[1] - SLOPES[0]) * chest
    leave = SPREAD * (inward + slope * [0, 0, 1])
    arrive = RISE * np.array([0, -0.25, 1.0])  # -0.25, because the neck leans forward
    return hermite_curves(hem, leave, top, arrive, rows)


def _round(points: np.ndarray, columns: int) -> np.ndarray:
    """Return evenly spaced points (columns + 1, 3) of a smooth curve through `points`, up to the gap at the back.

    The curve crosses the middle of the front at a right angle.
    """
    mirrored = np.concatenate([points[2:0:-1] * [-1, 1, 1], points, points[-2:-4:-1] * [-1, 1, 1]])
    knots = chord_lengths(mirrored)
    fine = cubic_spline(knots, mirrored)(np.linspace(knots[2], knots[-3], 2001))
    fine = fine[: np.searchsorted(-fine[1000:, 0], -OPENING) + 1000]
    at, even = chord_lengths(fine), np.linspace(0, 1, columns + 1)
    curve = np.stack([np.interp(even, at, fine[:, k]) for k in range(3)], axis=-1)
    curve[0, 0] = 0.0
    return curve
