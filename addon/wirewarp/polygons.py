# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed outlines in the plane, given as segments from a (s,2) to b (s,2) in any order. No Blender in here."""

from typing import NamedTuple

import numpy as np

AT_ONCE = 1_000_000  # pairs that are compared at a time, for memory's sake


class Segments(NamedTuple):
    a: np.ndarray
    b: np.ndarray

    @property
    def box(self) -> tuple[np.ndarray, np.ndarray]:
        return np.minimum(self.a, self.b).min(axis=0), np.maximum(self.a, self.b).max(axis=0)


def are_inside(points: np.ndarray, outline: Segments) -> np.ndarray:
    """(p,) bool: whether a ray from each point (p,2) to the right crosses the outline an odd number of times."""
    inside = np.zeros(len(points), dtype=bool)
    step = max(1, AT_ONCE // max(len(points), 1))
    x, y = points[:, :1], points[:, 1:]
    for start in range(0, len(outline.a), step):
        a, b = outline.a[start : start + step], outline.b[start : start + step]
        crosses = (a[:, 1] > y) != (b[:, 1] > y)
        with np.errstate(divide="ignore", invalid="ignore"):  # of level segments, which no ray crosses
            at = a[:, 0] + (y - a[:, 1]) * ((b - a)[:, 0] / (b - a)[:, 1])
        inside ^= (crosses & (x < at)).sum(axis=1) % 2 == 1
    return inside


def overlap(first: Segments, second: Segments) -> bool:
    """Whether two outlines cross, or one lies inside the other. Touching is no overlap."""
    low, high = np.maximum(first.box[0], second.box[0]), np.minimum(first.box[1], second.box[1])
    if np.any(low >= high):
        return False
    if _cross(_near(first, low, high), _near(second, low, high)):
        return True
    return bool(are_inside(first.a[:1], second)[0] or are_inside(second.a[:1], first)[0])


def _near(segments: Segments, low: np.ndarray, high: np.ndarray) -> Segments:
    """Those whose box meets this one."""
    near = np.all((np.minimum(*segments) <= high) & (np.maximum(*segments) >= low), axis=1)
    return Segments(segments.a[near], segments.b[near])


def _cross(first: Segments, second: Segments) -> bool:
    step = max(1, AT_ONCE // max(len(second.a), 1))
    for start in range(0, len(first.a), step):
        a, b = (ends[start : start + step, None] for ends in first)
        ends_apart = _side(a, b, second.a) * _side(a, b, second.b) < 0
        if np.any(ends_apart & (_side(second.a, second.b, a) * _side(second.a, second.b, b) < 0)):
            return True
    return False


def _side(a: np.ndarray, b: np.ndarray, point: np.ndarray) -> np.ndarray:
    """Positive left of the line from a to b."""
    along, to = b - a, point - a
    return along[..., 0] * to[..., 1] - along[..., 1] * to[..., 0]
