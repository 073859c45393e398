# SPDX-License-Identifier: GPL-3.0-or-later
"""Moving a piece in the plane without changing its shape. No Blender in here."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Motion:
    """A turn about the origin and then a shift; points of the plane as complex numbers."""

    turn: complex = 1.0  # of length 1
    shift: complex = 0.0

    def __call__(self, points: np.ndarray) -> np.ndarray:
        """(n,2) to (n,2)"""
        moved = (points[:, 0] + 1j * points[:, 1]) * self.turn + self.shift
        return np.column_stack([moved.real, moved.imag])

    def shifted(self, by: np.ndarray) -> "Motion":
        """This motion and then a shift (2,)."""
        return Motion(self.turn, self.shift + complex(*by))


STAY = Motion()


def fit_motion(points: np.ndarray, places: np.ndarray) -> Motion:
    """The motion that brings points (k,2) nearest to their places (k,2) in the sum of squares."""
    start, goal = (each[:, 0] + 1j * each[:, 1] for each in (points, places))
    spin = np.vdot(start - start.mean(), goal - goal.mean())  # the sum of conj(start) goal
    turn = complex(spin / abs(spin)) if abs(spin) > 0 else 1.0
    return Motion(turn, complex(goal.mean() - turn * start.mean()))
