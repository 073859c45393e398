# SPDX-License-Identifier: GPL-3.0-or-later
"""Calculates with lines and outlines in the plane. An outline is closed and does not repeat its first point."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pyclipper

# This step of Clipper's grid, in millimeters, is finer than any cutter. 100 m still fit in Clipper's fast integers of
# 30 bits.
GRID = 1e-4
ON_LINE = 1e-3  # millimeters; a point closer to a line counts as on the line; 10 times GRID
DEPTH = 1e-4  # share of the diagonal of the smaller shape's box; shapes that overlap less deeply only touch
STEPS, ROUNDS = 8, 3  # numbers for the search for an innermost point; the last steps are 2% of the shape's size
SAMPLES = 100  # number of points on the outline from which distances are measured, enough for placing text
PAIRS = 1_000_000  # number of pairs of points and sides compared at a time; an array of pairs has 16 MB
# Clipper is exact and fast if the box around all outlines is at most this many grid steps long and wide.
RESOLUTION = 2.0**30


def lengths_along(points: np.ndarray) -> np.ndarray:
    """Return the length (k,) of a line (k,2) from its start to each point."""
    return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])


def sampled(line: np.ndarray, spacing: float) -> np.ndarray:
    """Return points (m,2) on the line (k,2) at equal distances of at most `spacing`, including its ends."""
    along = lengths_along(line)
    at = np.linspace(0, along[-1], math.ceil(along[-1] / spacing) + 1)
    return np.column_stack([np.interp(at, along, column) for column in line.T])


def right_normals(points: np.ndarray) -> np.ndarray:
    """Return unit vectors (k-1,2) to the right of each step of a line (k,2) without repeated points."""
    along = np.diff(points, axis=0)
    return np.column_stack([along[:, 1], -along[:, 0]]) / np.linalg.norm(along, axis=1)[:, None]


def signed_area(outline: np.ndarray) -> float:
    """Return the area of an outline (k,2), positive if it runs counterclockwise."""
    x, y = (outline - outline[0]).T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def are_inside(points: np.ndarray, outlines: Sequence[np.ndarray]) -> np.ndarray:
    """Return (p,) bool: whether each point (p,2) is inside the outlines.

    A ray from a point inside crosses an odd number of sides.
    """
    a, b = _sides(outlines)
    x, y = points[:, :1], points[:, 1:]
    crosses = (a[:, 1] > y) != (b[:, 1] > y)
    with np.errstate(divide="ignore", invalid="ignore"):  # divides by 0 for horizontal sides, which no ray crosses
        at = a[:, 0] + (y - a[:, 1]) * ((b - a)[:, 0] / (b - a)[:, 1])
    inside: np.ndarray = (crosses & (x < at)).sum(axis=1) % 2 == 1
    return inside


def distances_to(points: np.ndarray, outlines: Sequence[np.ndarray]) -> np.ndarray:
    """Return the distance (p,) of each point (p,2) from the nearest of the outlines."""
    a, b = _sides(outlines)
    along = b - a
    squares = np.maximum((along * along).sum(axis=1), np.finfo(float).tiny)  # never 0, even for repeated points
    nearest = [np.empty(0)]
    at_once = max(1, PAIRS // max(len(a), 1))
    for begin in range(0, len(points), at_once):
        to = points[begin : begin + at_once, None] - a
        share = np.clip((to * along).sum(axis=2) / squares, 0, 1)
        gap = share[:, :, None] * along - to
        nearest.append(np.sqrt((gap * gap).sum(axis=2).min(axis=1)))
    return np.concatenate(nearest)


def innermost_point(outlines: Sequence[np.ndarray], lines_inside: Sequence[np.ndarray]) -> tuple[np.ndarray, float]:
    """Return the point (2,) inside closed outlines (k,2) that is approximately the farthest from all lines, and its
    distance from the nearest line."""
    closed = [np.concatenate([outline, outline[:1]]) for outline in outlines]
    spacing = sum(float(lengths_along(outline)[-1]) for outline in closed) / SAMPLES
    around = [sampled(outline, spacing) for outline in closed]
    obstacles = np.concatenate([*around, *(sampled(line, spacing) for line in lines_inside)])
    low, high = np.concatenate(around).min(axis=0), np.concatenate(around).max(axis=0)
    center, reach = (low + high) / 2, (high - low) / 2
    best = -math.inf
    for _ in range(ROUNDS):
        offsets = np.linspace(-1, 1, STEPS + 1)
        x, y = np.meshgrid(center[0] + reach[0] * offsets, center[1] + reach[1] * offsets)
        points = np.column_stack([x.ravel(), y.ravel()])
        points = points[are_inside(points, around)]
        if len(points):
            depths = _distances(points, obstacles)
            if depths.max() > best:
                best, center = float(depths.max()), points[np.argmax(depths)]
        reach = reach * 3 / STEPS
    return center, math.sqrt(max(best**2 - (spacing / 2) ** 2, 0.0))  # a line may be nearer between two of its samples


def _distances(points: np.ndarray, obstacles: np.ndarray) -> np.ndarray:
    x, y = (points[:, axis, None] - obstacles[:, axis] for axis in (0, 1))
    return np.sqrt((x * x + y * y).min(axis=1))


def crossings(point: np.ndarray, direction: np.ndarray, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return the signed lengths (n,) along a line from a point (2,) to the segments that the line crosses.

    - direction (2,): unit vector of the line
    - a, b (s,2): ends of all segments
    """
    along, to = b - a, a - point
    with np.errstate(divide="ignore", invalid="ignore"):  # divides by 0 for a segment parallel to the line
        slope = _cross(direction, along)
        distance, share = _cross(to, along) / slope, _cross(to, direction) / slope
    found: np.ndarray = distance[(share >= -1e-9) & (share <= 1 + 1e-9)]
    return found


class Rays:
    """Rays from points to closed outlines (k,2) and open lines (k,2)."""

    def __init__(self, outlines: Sequence[np.ndarray], lines: Sequence[np.ndarray] = ()) -> None:
        a, b = _sides(outlines)
        self._a = np.concatenate([a, *(line[:-1] for line in lines)])
        self._b = np.concatenate([b, *(line[1:] for line in lines)])

    def length(self, point: np.ndarray, direction: np.ndarray) -> float:
        """Return the length from the point to the nearest line in a direction, or infinity without a line there.

        direction (2,): unit vector.
        """
        distances = crossings(point, direction, self._a, self._b)
        nearest = float(distances[distances > -ON_LINE].min(initial=math.inf))
        return nearest if nearest >= ON_LINE else 0.0


def overlap(first: Sequence[np.ndarray], second: Sequence[np.ndarray]) -> bool:
    """Return whether two shapes overlap by more than rounding errors. Shapes that only touch do not overlap.

    first, second: outlines (k,2) of each shape, in any order, direction and unit.
    """
    boxes = [_box(outlines) for outlines in (first, second)]
    depth = DEPTH * min(float(np.linalg.norm(high - low)) for low, high in boxes)
    low, high = np.min([box[0] for box in boxes], axis=0), np.max([box[1] for box in boxes], axis=0)
    if np.any(np.min([box[1] for box in boxes], axis=0) - np.max([box[0] for box in boxes], axis=0) <= depth):
        return False
    if any(all(_is_thin(outline, depth) for outline in outlines) for outlines in (first, second)):
        return False  # Clipper refuses shapes without area
    step = float((high - low).max()) / RESOLUTION
    clipper = pyclipper.Pyclipper()
    for outlines, role in ((first, pyclipper.PT_SUBJECT), (second, pyclipper.PT_CLIP)):
        paths = [np.rint((outline - low) / step).astype(np.int64).tolist() for outline in outlines if len(outline) > 2]
        clipper.AddPaths(paths, role, True)
    shared = clipper.Execute(pyclipper.CT_INTERSECTION, pyclipper.PFT_EVENODD, pyclipper.PFT_EVENODD)
    return not all(_is_thin(np.array(part) * step, depth) for part in shared)


def _is_thin(outline: np.ndarray, depth: float) -> bool:
    """Return whether the shape is on average at most as wide as the depth."""
    around = float(np.linalg.norm(np.roll(outline, -1, axis=0) - outline, axis=1).sum())
    return 2 * abs(signed_area(outline)) <= depth * around


def _box(outlines: Sequence[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    points = np.concatenate(outlines)
    return points.min(axis=0), points.max(axis=0)


def _sides(outlines: Sequence[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    a = np.concatenate([np.empty((0, 2)), *outlines])
    return a, np.concatenate([np.empty((0, 2)), *(np.roll(outline, -1, axis=0) for outline in outlines)])


def _cross(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    return first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]


@dataclass(frozen=True)
class Motion:
    """A motion that can first mirror (x becomes -x), then turns about the origin, and then shifts."""

    offset: np.ndarray  # (2,) millimeters
    angle: float = 0.0  # degrees counterclockwise
    mirrored: bool = False

    def directions(self, vectors: np.ndarray) -> np.ndarray:
        """Return the images of vectors (..., 2). Vectors are mirrored and turned, but not shifted."""
        cosine, sine = math.cos(math.radians(self.angle)), math.sin(math.radians(self.angle))
        turned: np.ndarray = vectors * (-1 if self.mirrored else 1, 1) @ np.array([[cosine, sine], [-sine, cosine]])
        return turned

    def points(self, points: np.ndarray) -> np.ndarray:
        """Return the images of points (..., 2)."""
        moved: np.ndarray = (self.directions(points) if self.angle or self.mirrored else points) + self.offset
        return moved

    def text_angle(self, degrees: float) -> float:
        """Return the angle of a moved text in degrees. Texts are not mirrored, and are read from below or the right."""
        if not self.angle and not self.mirrored:
            return degrees
        turned = (-degrees if self.mirrored else degrees) + self.angle
        return 90.0 - (90.0 - turned) % 180.0
