# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a hat: a crown in two halves, each with a dart, and a brim."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .curves import chord_lengths, cubic_spline, even_parameters
from .fan import add_sector
from .shape import Shape, ShapeBuilder

# Radius and height of the crown's profile from its top to the hem, in meters, for a head of 58 cm.
CROWN_PROFILE = np.array([[0.0, 0.118], [0.045, 0.112], [0.075, 0.093], [0.088, 0.060], [0.092, 0.028], [0.093, 0.0]])
BRIM_PROFILE = np.array([[0.093, 0.0], [0.112, -0.018], [0.135, -0.032]])
LENGTH, WIDTH = 1.08, 0.92  # half the length (y) and half the width (x), as multiples of the profile's radius


def hat(fan_rows: int = 12, side_rows: int = 7, brim_rows: int = 6, sectors: int = 8) -> Shape:
    """Return a round hat. The head line runs around the crown, across the middle seam and both darts."""
    builder = ShapeBuilder()
    profile = _profile(np.concatenate([CROWN_PROFILE[:0:-1] * [-1, 1], CROWN_PROFILE]))
    share = fan_rows / (fan_rows + side_rows * 0.62)  # share of the profile's length that the fan covers
    top = even_parameters(profile, 0.5, 0.5 + 0.5 * share, fan_rows)
    side = even_parameters(profile, 0.5 + 0.5 * share, 1.0, side_rows)
    fans = []
    for sector in range(sectors):
        begin, end = 2 * np.pi * sector / sectors, 2 * np.pi * (sector + 1) / sectors
        fans.append(add_sector(builder, lambda row, at: _round(profile(top[row]), at), begin, end, fan_rows))
    around = np.linspace(0, 2 * np.pi, sectors * fan_rows + 1)
    crown = builder.add_grid(np.stack([_round(profile(t), around) for t in side]), flip=True)
    brim = builder.add_grid(np.stack([_round(p, around) for p in _brim(brim_rows)]), flip=True)

    quarter = sectors // 4
    for k in (1, 3):  # at front and back: the middle seam over the top
        builder.add_seam(_meridian(fans[k * quarter], crown[:, k * quarter * fan_rows], 0))
    for k in (0, 2):  # at left and right: the darts, from the hem up
        builder.add_seam(_meridian(fans[k * quarter], crown[:, k * quarter * fan_rows], fan_rows // 2))
    builder.add_seam(crown[-1])
    builder.add_seam(brim[:, quarter * fan_rows])
    builder.add_wire(crown[side_rows // 2], "Head line")
    return builder.build("Hat", cloth="fleece")


def _meridian(fan: list[np.ndarray], side: np.ndarray, first_row: int) -> np.ndarray:
    return np.array([*(row[0] for row in fan[first_row:]), *side[1:]])


def _profile(points: np.ndarray) -> Callable[[np.ndarray], np.ndarray]:
    return cubic_spline(chord_lengths(points), points)


def _brim(rows: int) -> np.ndarray:
    profile = _profile(BRIM_PROFILE)
    return profile(even_parameters(profile, 0.0, 1.0, rows))


def _round(profile_point: np.ndarray, longitudes: np.ndarray) -> np.ndarray:
    radius, height = profile_point
    return np.stack(
        [radius * WIDTH * np.cos(longitudes), radius * LENGTH * np.sin(longitudes), np.full_like(longitudes, height)],
        axis=-1,
    )
