# SPDX-License-Identifier: GPL-3.0-or-later
"""Describes the upper body of a dress form as a smooth surface: front and back, which meet at sides and shoulders.

A point has a longitude phi (0 in the middle, +-pi/2 at the sides) and v (0 at the hip, 1 at the shoulder line, CROTCH_V
at the crotch). The front faces -y, the wearer's left is +x, and z is up. Lengths are in meters.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .curves import chord_lengths, cubic_spline, hermite

#                   z     front  back   half width   from the hip to the shoulder line
PROFILE = np.array([
    [0.000, 0.108, 0.118, 0.182],
    [0.100, 0.099, 0.106, 0.166],
    [0.200, 0.087, 0.080, 0.134],
    [0.300, 0.098, 0.090, 0.148],
    [0.370, 0.106, 0.100, 0.161],
    [0.420, 0.106, 0.105, 0.170],
    [0.480, 0.098, 0.103, 0.183],
    [0.538, 0.081, 0.089, 0.194],
    [0.585, 0.048, 0.054, 0.199],
    [0.600, 0.000, 0.000, 0.200],
    [0.585, -.048, -.054, 0.199],  # a row beyond the shoulder line, so that the shoulder is round
])  # fmt: skip
WAIST, BUST, UNDERARM = 0.20, 0.37, 0.42  # heights in meters
SHOULDER_DROP = 0.060  # drop of the shoulder line from the middle to the half width
BUST_POINT = np.array([0.078, 0.37])  # |x| and z
BUST_RISE, BUST_SIZE = 0.032, 0.058  # height and radius of the bust
CROTCH = np.array([-0.075, 0.0, 0.0, 0.165])  # the crotch, with the columns of PROFILE
# derivative of the profile at CROTCH, at which front and back meet level
CROTCH_ARRIVAL = np.array([0.0, -0.20, -0.22, 0.0])
CROTCH_V = -0.22  # v of the crotch

_lengths = chord_lengths(PROFILE[:, :2])
_above_hip = cubic_spline(_lengths / _lengths[-2], PROFILE)
_HIP_SLOPE = (_above_hip(1e-6) - _above_hip(0.0)) / 1e-6
_FINE = np.linspace(0, 1, 4001)


def _profile(v: np.ndarray) -> np.ndarray:
    """Return values (..., 4) in the form of the columns of PROFILE. Below the hip, a cubic continues it smoothly."""
    v = np.asarray(v, dtype=float)
    t = np.clip(v / CROTCH_V, 0, 1)[..., None]  # 0 at the hip, 1 at the crotch
    below = hermite(t, PROFILE[0], CROTCH_V * _HIP_SLOPE, CROTCH, CROTCH_ARRIVAL)
    return np.where((v < 0)[..., None], below, _above_hip(v))


def v_at_height(z: float) -> float:
    """Return the v at which the profile has the height z."""
    return float(np.interp(z, _profile(_FINE)[:, 0], _FINE))


UNDERARM_V = v_at_height(UNDERARM)


def longitude_at(x: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Return phi of the points at x and v. It is pi/2 if the body is not wider than x."""
    return np.arcsin(np.clip(x / _profile(v)[..., 3], -1, 1))


@dataclass(frozen=True)
class Half:
    """The front (side +1) or the back (side -1) of the body."""

    side: int

    def points(self, phi: np.ndarray, v: np.ndarray) -> np.ndarray:
        """Return points (..., 3). phi, v: arrays of one shape (...). phi > 0 is the wearer's left."""
        z, front, back, width = np.moveaxis(_profile(v), -1, 0)
        drop = SHOULDER_DROP * np.clip((v - UNDERARM_V) / (1 - UNDERARM_V), 0, 1) ** 2
        x = width * np.sin(phi)
        z = z - drop * np.sin(phi) ** 2
        depth = front if self.side > 0 else back
        if self.side > 0:
            distance = (np.abs(x) - BUST_POINT[0]) ** 2 + (z - BUST_POINT[1]) ** 2
            depth = depth + BUST_RISE * np.exp(-distance / BUST_SIZE**2)
        depth = np.where((v < 1) & (np.abs(phi) < np.pi / 2), depth * np.cos(phi), 0.0)
        return np.stack([x, -self.side * depth, z], axis=-1)
