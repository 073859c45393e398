# SPDX-License-Identifier: GPL-3.0-or-later
"""The strip of seam allowance along one stretch of an outline.

Outlines run with the piece on their left, so the allowance lies on the right.
"""

import numpy as np

from .geometry import right_normals

MITRE_LIMIT = 2.5  # times the width: how far a corner may point outwards before it is cut off square


def strip(points: np.ndarray, width: float) -> np.ndarray:
    """A polygon (m,2), counterclockwise: the line (k,2) and, at the width to its right, the parallel line.

    It ends square at both ends. A closed line repeats its first point. The polygon may cover a place twice, but never
    winds clockwise round one: it is a chain of rectangles, of the wedges between them where the line turns left, and of
    rectangles cut where two of them meet.
    """
    normals = right_normals(points)
    if np.array_equal(points[0], points[-1]):  # the join of the closed line is made at its end
        points, normals = np.concatenate([points, points[1:2]]), np.concatenate([normals, normals[:1]])
    outside = [points[:1] + width * normals[:1], *_joins(points, normals, width), points[-1:] + width * normals[-1:]]
    return np.concatenate([*outside, points[::-1]])


def _joins(points: np.ndarray, normals: np.ndarray, width: float) -> list[np.ndarray]:
    """At each inner point of the line the points (j,2) of the parallel line."""
    before, after, corners = normals[:-1], normals[1:], points[1:-1]
    turn = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]  # sine; above 0 to the left
    cosine = (before * after).sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):  # where the line turns back on itself
        tangent = turn / (1 + cosine)  # of half the angle
        mitre = corners + width * (before + after) / (1 + cosine)[:, None]
    far = np.isnan(tangent) | (1 + tangent**2 > MITRE_LIMIT**2)  # the mitre is width * sqrt(1 + tangent^2) away
    is_left = (turn > 0) | ((turn == 0) & (cosine < 0))
    is_mitre = ~far & (is_left | _fits(points, tangent, width))
    joins: list[np.ndarray] = list(mitre[:, None])
    for i in np.flatnonzero(~is_mitre):
        if is_left[i]:
            joins[i] = _cut_off(corners[i], before[i], after[i], width)
        else:
            joins[i] = np.array([corners[i] + width * before[i], corners[i], corners[i] + width * after[i]])
    return joins


def _fits(points: np.ndarray, tangent: np.ndarray, width: float) -> np.ndarray:
    """(k-2,) bool: whether both steps at an inner point are longer than what the mitres of right turns take of them."""
    taken = np.concatenate([[0], np.nan_to_num(np.maximum(-tangent, 0) * width, posinf=np.inf), [0]])
    lengths = np.linalg.norm(np.diff(points, axis=0), axis=1)
    is_long = taken[:-1] + taken[1:] < lengths
    return is_long[:-1] & is_long[1:]


def _cut_off(corner: np.ndarray, before: np.ndarray, after: np.ndarray, width: float) -> np.ndarray:
    """(2,2) where the line square to the diagonal of the corner, at the limit, cuts the two parallel lines."""
    out = before + after
    length = np.linalg.norm(out)
    along = np.array([-before[1], before[0]])  # where the line comes from, it runs on
    out = out / length if length > 1e-9 else along  # it turns back: the corner points straight on
    ends = []
    for normal, direction in ((before, along), (after, np.array([after[1], -after[0]]))):
        start = corner + width * normal
        ends.append(start + direction * (MITRE_LIMIT * width - (start - corner) @ out) / (direction @ out))
    return np.array(ends)
