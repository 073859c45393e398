# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed outlines in the plane, given as segments from a (s,2) to b (s,2) in any order."""

from typing import NamedTuple

import numpy as np

AT_ONCE = 1_000_000  # pairs that are compared at a time, for memory's sake
DEPTH = 1e-4  # of the diagonal of the smaller outline's box: what overlaps less touches, but for rounding


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
    (low, high), depth = _common(first, second), DEPTH * min(_diagonal(first), _diagonal(second))
    if np.any(high - low <= depth):
        return False
    near = _near(first, low, high), _near(second, low, high)
    if _cross(*near, depth):
        return True
    return _runs_inside(near[0], first, second, depth) or _runs_inside(near[1], second, first, depth)


def _common(first: Segments, second: Segments) -> tuple[np.ndarray, np.ndarray]:
    """The box that is in the boxes of both."""
    return np.maximum(first.box[0], second.box[0]), np.minimum(first.box[1], second.box[1])


def _diagonal(outline: Segments) -> float:
    low, high = outline.box
    return float(np.linalg.norm(high - low))


def _near(segments: Segments, low: np.ndarray, high: np.ndarray) -> Segments:
    """Those whose box meets this one."""
    near = np.all((np.minimum(*segments) <= high) & (np.maximum(*segments) >= low), axis=1)
    return Segments(segments.a[near], segments.b[near])


def _cross(first: Segments, second: Segments, depth: float) -> bool:
    """Whether any two cross so that all ends lie farther than the depth from the line of the other."""
    step = max(1, AT_ONCE // max(len(second.a), 1))
    for start in range(0, len(first.a), step):
        part = Segments(*(ends[start : start + step, None] for ends in first))
        if np.any(_ends_apart(part, second, depth) & _ends_apart(second, part, depth)):
            return True
    return False


def _ends_apart(line: Segments, ends: Segments, depth: float) -> np.ndarray:
    """Whether both ends lie farther than the depth from the line, on two sides of it."""
    along = line.b - line.a
    sides = [along[..., 0] * to[..., 1] - along[..., 1] * to[..., 0] for to in (ends.a - line.a, ends.b - line.a)]
    least = depth * np.linalg.norm(along, axis=-1)
    return (np.minimum(*sides) < -least) & (np.maximum(*sides) > least)


def _runs_inside(part: Segments, own: Segments, other: Segments, depth: float) -> bool:
    """Whether the inside of own along a part of its segments, by the depth beside their middles, is inside other.

    This finds what does not cross, as sides in line with one another and outlines of one shape.
    """
    middles, along = (part.a + part.b) / 2, part.b - part.a
    length = np.linalg.norm(along, axis=1, keepdims=True)
    aside = depth * np.column_stack([-along[:, 1], along[:, 0]]) / np.where(length > 0, length, 1)
    points = np.concatenate([middles + aside, middles - aside])
    points = points[are_inside(points, other)]
    return bool(are_inside(points, own).any())
