# SPDX-License-Identifier: GPL-3.0-or-later
"""Straight ways from points to the cut lines of a piece."""

import math
from collections.abc import Sequence

import numpy as np

ON_LINE = 1e-3  # millimeters: what lies nearer is on the line; the grid of cut lines is 10 times finer


class Rays:
    def __init__(self, outlines: Sequence[np.ndarray]) -> None:
        """outlines (k,2): closed, without repeating the first point."""
        self._a = np.concatenate([np.empty((0, 2)), *outlines])
        self._b = np.concatenate([np.empty((0, 2)), *(np.roll(outline, -1, axis=0) for outline in outlines)])

    def to_cut(self, point: np.ndarray, direction: np.ndarray) -> float:
        """Length from the point along the unit vector to the nearest cut line; 0 where the point lies on one.

        Infinite where there is none.
        """
        distances = self.all_to_cut(point, direction)
        return float(distances[0]) if len(distances) else math.inf

    def all_to_cut(self, point: np.ndarray, direction: np.ndarray) -> np.ndarray:
        """(n,) ascending lengths to all cut lines on the way."""
        along, to = self._b - self._a, self._a - point
        with np.errstate(divide="ignore", invalid="ignore"):  # of lines in this direction
            slope = _cross(direction, along)
            distance, share = _cross(to, along) / slope, _cross(to, direction) / slope
        met = (share >= -1e-9) & (share <= 1 + 1e-9) & (distance > -ON_LINE)
        found = np.sort(np.maximum(distance[met], 0.0))
        found[found < ON_LINE] = 0.0
        return found

    def distance(self, points: np.ndarray) -> np.ndarray:
        """(p,) of points (p,2) from the nearest cut line."""
        along = self._b - self._a
        length = np.maximum((along * along).sum(axis=1), np.finfo(float).tiny)
        nearest = np.empty(len(points))
        for row, point in enumerate(points):
            share = np.clip(((point - self._a) * along).sum(axis=1) / length, 0, 1)
            gap = self._a + share[:, None] * along - point
            nearest[row] = math.sqrt(float((gap * gap).sum(axis=1).min()))
        return nearest


def _cross(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    return first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]
