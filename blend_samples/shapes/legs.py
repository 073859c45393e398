# SPDX-License-Identifier: GPL-3.0-or-later
"""Describes hips and legs as a smooth surface: left front and left back, each from the inner leg to the side.

A point has a height z and an angle: 0 at the inner leg, pi/2 in the middle of the thigh, pi at the side. Above the
crotch, the smallest angle is that of the middle of the body. The front faces -y, and the wearer's left is +x. Lengths
are in meters.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .curves import cubic_spline

#                   z     side   inner  front  back   middle y
PROFILE = np.array([
    [0.060, 0.152, 0.052, 0.055, 0.062, 0.020],
    [0.300, 0.157, 0.056, 0.058, 0.068, 0.012],
    [0.480, 0.160, 0.060, 0.068, 0.066, 0.002],
    [0.650, 0.169, 0.069, 0.086, 0.084, 0.002],
    [0.800, 0.181, 0.078, 0.100, 0.106, 0.004],
    [0.880, 0.186, 0.080, 0.104, 0.112, 0.002],
    [0.950, 0.182, 0.080, 0.105, 0.110, 0.000],
    [1.020, 0.161, 0.080, 0.098, 0.099, 0.000],
    [1.080, 0.141, 0.080, 0.092, 0.094, 0.000],
])  # fmt: skip
HEM, KNEE, CROTCH, WAIST = 0.060, 0.480, 0.835, 1.080  # heights
# Height above the crotch over which two legs become one body, and the exponent of the transition.
MERGE, POWER = 0.18, 4
GAP, SPREAD = 0.020, 0.026  # half of the gap between the thighs, and the additional half gap at the hem
SEAT_POINT = np.array([0.082, 0.915])  # x and z of the middle of the seat
SEAT_RISE, SEAT_SIZE = 0.034, 0.070  # height and radius of the seat

_profile = cubic_spline(PROFILE[:, 0], PROFILE[:, 1:])


def middle_angle(z: np.ndarray) -> np.ndarray:
    """Return the angle at which the section at height z meets the middle of the body. Up to the crotch, it is 0."""
    return np.arccos(np.clip(1 - (z - CROTCH) / MERGE, 0, 1) ** POWER)


def angle_at(x: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Return the angle of the points of the left half at x and z. It is the same on front and back."""
    outer, inner = np.moveaxis(_profile(z), -1, 0)[:2]
    center = _center(z, inner)
    return np.arccos(np.clip((center - x) / np.where(x < center, inner, outer - center), -1, 1))


def center(z: np.ndarray) -> np.ndarray:
    """Return x of the middle of the thigh at height z. It is smooth at the crotch."""
    return _center(z, _profile(z)[..., 1])


def _center(z: np.ndarray, inner: np.ndarray) -> np.ndarray:
    merged = inner * np.clip(1 - np.maximum(z - CROTCH, 0) / MERGE, 0, 1) ** POWER
    below = np.maximum(CROTCH - z, 0)
    steepness = POWER * inner / MERGE / GAP
    return merged + GAP * (1 - np.exp(-below * steepness)) + SPREAD * (below / (CROTCH - HEM)) ** 2


@dataclass(frozen=True)
class Half:
    """The front (side +1) or the back (side -1) of hips and legs."""

    side: int

    def points(self, angle: np.ndarray, z: np.ndarray) -> np.ndarray:
        """Return points (..., 3) of the left half. angle, z: arrays of one shape (...)."""
        outer, inner, front, back, y = np.moveaxis(_profile(z), -1, 0)
        center = _center(z, inner)
        cosine = np.cos(angle)
        x = center - np.where(cosine > 0, inner, outer - center) * cosine
        x = np.where((z >= CROTCH) & (angle <= middle_angle(z)), 0.0, x)
        depth = front if self.side > 0 else back
        if self.side < 0:
            distance = (x - SEAT_POINT[0]) ** 2 + (z - SEAT_POINT[1]) ** 2
            depth = depth + SEAT_RISE * np.exp(-distance / SEAT_SIZE**2)
        depth = np.where(angle < np.pi, depth * np.sin(angle), 0.0)
        return np.stack([x, y - self.side * depth, z], axis=-1)
