# SPDX-License-Identifier: GPL-3.0-or-later
"""How wide a piece is, seen from its outline."""

import math

import numpy as np

from .flat_pieces import FlatPieces
from .outlines import OutlineEdges

AT_ONCE = 1e-3  # millimeters: nearer than this is the outline that one looks from


class Across:
    def __init__(self, flat: FlatPieces, outline: OutlineEdges) -> None:
        self._flat, self._outline = flat, outline
        self._sides: dict[int, np.ndarray] = {}

    def __call__(self, piece: int, point: np.ndarray, inward: np.ndarray) -> float:
        """From a point (2,) of the outline straight on along the unit vector `inward` to the outline again."""
        if piece not in self._sides:
            self._sides[piece] = self._flat.vertices[self._outline.edges[self._outline.piece == piece]]
        a, b = self._sides[piece].transpose(1, 0, 2)
        along, to = b - a, a - point
        with np.errstate(divide="ignore", invalid="ignore"):  # of edges in this direction, which nothing meets
            slope = _cross(inward, along)
            distance, share = _cross(to, along) / slope, _cross(to, inward) / slope
        met = (share >= 0) & (share <= 1) & (distance > AT_ONCE)
        return float(distance[met].min(initial=math.inf))


def _cross(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    return first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]
