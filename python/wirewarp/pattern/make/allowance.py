# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the cutting lines of a piece: unites the piece with strips (allowances along stitching lines) and corners.

Outlines run with the piece on their left. Floating-point unions could leave slits, so Clipper unites integers.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pyclipper

from ..geometry import GRID, are_inside, right_normals, signed_area
from .corners import MITRE_LIMIT, CornerType, corner_path


def strip(points: np.ndarray, width: float) -> np.ndarray:
    """Return a counterclockwise polygon (m,2) between the line (k,2) and a parallel line to its right, `width` away.

    A closed line repeats its first point. The polygon may overlap itself, but never winds clockwise.
    """
    normals = right_normals(points)
    if np.array_equal(points[0], points[-1]):  # a closed line also has a join at its end
        points, normals = np.concatenate([points, points[1:2]]), np.concatenate([normals, normals[:1]])
    outside = [points[:1] + width * normals[:1], *_joins(points, normals, width), points[-1:] + width * normals[-1:]]
    return np.concatenate([*outside, points[::-1]])


def _joins(points: np.ndarray, normals: np.ndarray, width: float) -> list[np.ndarray]:
    """Return, for each inner point of the line, the points (j,2) of the parallel line there."""
    before, after, corners = normals[:-1], normals[1:], points[1:-1]
    turn = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]  # sine of the turn; positive to the left
    cosine = (before * after).sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):  # divides by 0 if the line turns back on itself
        tangent = turn / (1 + cosine)  # tangent of half the turn
        mitre = corners + width * (before + after) / (1 + cosine)[:, None]
    # The distance between the mitre's point and the corner is width * sqrt(1 + tangent^2).
    far = np.isnan(tangent) | (1 + tangent**2 > MITRE_LIMIT**2)
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
    """Return (k-2,) bool: whether both steps at each inner point are long enough for a mitre at a right turn."""
    taken = np.concatenate([[0], np.nan_to_num(np.maximum(-tangent, 0) * width, posinf=np.inf), [0]])
    lengths = np.linalg.norm(np.diff(points, axis=0), axis=1)
    is_long = taken[:-1] + taken[1:] < lengths
    return is_long[:-1] & is_long[1:]


def _cut_off(corner: np.ndarray, before: np.ndarray, after: np.ndarray, width: float) -> np.ndarray:
    """Return the ends (2,2) of a mitre that is cut off at the limit, square to the diagonal of the corner."""
    out = before + after
    length = np.linalg.norm(out)
    along = np.array([-before[1], before[0]])  # direction of the line before the turn
    out = out / length if length > 1e-9 else along  # if the line turns back, the corner points straight ahead
    ends = []
    for normal, direction in ((before, along), (after, np.array([after[1], -after[0]]))):
        start = corner + width * normal
        ends.append(start + direction * (MITRE_LIMIT * width - (start - corner) @ out) / (direction @ out))
    return np.array(ends)


Polygon = list[list[int]]  # corners on the grid
SMALLEST = 1e-3  # square millimeters; smaller loops are rounding errors


@dataclass(frozen=True)
class Corner:
    """The rule by which the allowances of two sections meet at the end of the first section."""

    kind: CornerType = "mitre"
    of_next: bool = False  # whether the rule ends the allowance of the second section instead of the first


@dataclass(frozen=True)
class Section:
    """A part of an outline with one width of allowance."""

    points: np.ndarray  # (k,2), with the piece on the left; a closed outline of one section repeats its first point
    width: float
    corner: Corner = Corner()  # the corner at the end of the section


@dataclass(frozen=True)
class CutLines:
    """Closed lines that do not repeat their first point. Outer lines run counterclockwise, holes clockwise."""

    outer: list[np.ndarray]
    holes: list[np.ndarray]
    pockets: list[np.ndarray]  # areas outside the piece that the allowance encloses, and that are not cut out


def cut_lines(loops: Sequence[Sequence[Section]]) -> CutLines:
    """Return the cutting lines of a piece. loops: its outlines, each as sections in order."""
    outlines = [np.concatenate([section.points[:-1] for section in loop]) for loop in loops]
    if all(section.width == 0 for loop in loops for section in loop):
        areas = [signed_area(outline) for outline in outlines]
        inner = [outline for outline, area in zip(outlines, areas, strict=True) if area < 0]
        return CutLines([outline for outline, area in zip(outlines, areas, strict=True) if area >= 0], inner, [])
    origin = outlines[0][0]
    parts = [_on_grid(outline, origin) for outline in outlines]
    for loop in loops:
        parts += _allowance(loop, origin)
    outer: list[np.ndarray] = []
    holes: list[np.ndarray] = []
    pockets: list[np.ndarray] = []
    for united in _unite(parts):
        points = np.array(united) * GRID + origin
        area = signed_area(points)
        if area > SMALLEST:
            outer.append(points)
        elif area < -SMALLEST:
            is_hole = any(signed_area(outline) < 0 and are_inside(points[:1], [outline])[0] for outline in outlines)
            (holes if is_hole else pockets).append(points)
    return CutLines(outer, holes, pockets)


def _allowance(loop: Sequence[Section], origin: np.ndarray) -> list[Polygon]:
    strips = [[_on_grid(strip(part.points, part.width), origin)] if part.width > 0 else [] for part in loop]
    corners = []
    for number, first in enumerate(loop if len(loop) > 1 else []):
        following = (number + 1) % len(loop)
        place = _Place(first, loop[following])
        path = place.path()
        if path is not None:
            filling = place.filling(path)
            corners.append(_on_grid(filling, origin))
            strips[number] = _without(strips[number], place.trimmed_of_first(path, filling), origin)
            strips[following] = _without(strips[following], place.trimmed_of_second(path, filling), origin)
    return [polygon for polygons in strips for polygon in polygons] + corners


class _Place:
    """The corner between the end of one section and the start of the following section."""

    def __init__(self, first: Section, second: Section) -> None:
        self._a, self._b, self._corner = first.width, second.width, first.corner
        self._point = first.points[-1]
        (self._normal_a,), (self._normal_b,) = right_normals(first.points[-2:]), right_normals(second.points[:2])
        self._end_a = self._point + self._a * self._normal_a
        self._end_b = self._point + self._b * self._normal_b
        self._along_a, self._along_b = (_turned_left(n) for n in (self._normal_a, self._normal_b))
        cross = self._normal_a[0] * self._normal_b[1] - self._normal_a[1] * self._normal_b[0]
        self._turn = math.atan2(cross, self._normal_a @ self._normal_b)

    def path(self) -> np.ndarray | None:
        """Return the path (k,2) from the first cutting line to the second; None if the strips need no corner."""
        if not self._corner.of_next:
            path = corner_path(self._corner.kind, self._turn, self._a, self._b)
            return None if path is None else self._point + path @ np.array([self._along_a, -self._normal_a])
        path = corner_path(self._corner.kind, self._turn, self._b, self._a)
        return None if path is None else (self._point + path @ np.array([-self._along_b, -self._normal_b]))[::-1]

    def filling(self, path: np.ndarray) -> np.ndarray:
        """Return the counterclockwise polygon between the corner's point, the ends of the strips and the path."""
        ends = [self._point[None]]
        if (path[0] - self._point) @ self._along_a > 0:
            ends.append(self._end_a[None])
        ends.append(path)
        if (path[-1] - self._point) @ self._along_b < 0:
            ends.append(self._end_b[None])
        return np.concatenate(ends)

    def trimmed_of_first(self, path: np.ndarray, filling: np.ndarray) -> np.ndarray | None:
        """Return a polygon that contains the part of the first strip beyond the path; None if nothing is removed."""
        back = (path[0] - self._point) @ self._along_a
        inner = path[1] if len(path) > 1 else self._end_b
        if back > -GRID or self._only_trims(second=True) or are_inside(self._end_a[None], [filling])[0]:
            return None
        return _beyond(path[0], inner, -back * self._along_a)

    def trimmed_of_second(self, path: np.ndarray, filling: np.ndarray) -> np.ndarray | None:
        """Return a polygon that contains the part of the second strip beyond the path; None if nothing is removed."""
        ahead = (path[-1] - self._point) @ self._along_b
        inner = path[-2] if len(path) > 1 else self._end_a
        if ahead < GRID or self._only_trims(second=False) or are_inside(self._end_b[None], [filling])[0]:
            return None
        return _beyond(path[-1], inner, -ahead * self._along_b)

    def _only_trims(self, second: bool) -> bool:
        """Return whether the rule trims only one strip: the second strip if `second` is true, otherwise the first. Such
        a rule folds the strip back, which does not change the other strip."""
        return self._corner.kind == "fold-back" and self._corner.of_next == second


def _beyond(end: np.ndarray, inner: np.ndarray, shift: np.ndarray) -> np.ndarray:
    """Return a parallelogram between the line through `end` and `inner` and this line shifted by `shift`. It extends
    beyond `end`, because strips of curves bulge."""
    outside = end + (end - inner) / 2
    return np.array([outside, inner, inner + shift, outside + shift])


def _turned_left(vector: np.ndarray) -> np.ndarray:
    return np.array([-vector[1], vector[0]])


def _on_grid(points: np.ndarray, origin: np.ndarray) -> Polygon:
    """Return the points (k,2) on the grid. All polygons have the same origin, so that equal points stay equal and no
    slit opens between strips."""
    rounded: Polygon = np.rint((points - origin) / GRID).astype(np.int64).tolist()
    return rounded


def _without(polygons: list[Polygon], trimmed: np.ndarray | None, origin: np.ndarray) -> list[Polygon]:
    if trimmed is None or not polygons:
        return polygons
    clipper = pyclipper.Pyclipper()
    clipper.AddPaths(polygons, pyclipper.PT_SUBJECT, True)
    clipper.AddPath(_on_grid(trimmed, origin), pyclipper.PT_CLIP, True)
    left: list[Polygon] = clipper.Execute(pyclipper.CT_DIFFERENCE, pyclipper.PFT_NONZERO, pyclipper.PFT_NONZERO)
    return left


def _unite(polygons: list[Polygon]) -> list[Polygon]:
    """Return the outlines of the union: outer outlines counterclockwise, the outlines of holes clockwise."""
    clipper = pyclipper.Pyclipper()
    clipper.AddPaths(polygons, pyclipper.PT_SUBJECT, True)
    united = clipper.Execute(pyclipper.CT_UNION, pyclipper.PFT_NONZERO, pyclipper.PFT_NONZERO)
    return [loop for loop in pyclipper.CleanPolygons(united) if len(loop) >= 3]
