# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the sides of seams on flat pieces, their lengths and ease, and the seams that are sewn first at a junction."""

import math
from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..geometry import lengths_along, right_normals
from ..units import UnitSystem
from .outline import Side

LEAST = 0.5  # millimeters; a smaller difference needs no ease, and errors of single precision are far smaller
GATHERED = 0.15  # share of the shorter side; a side with more ease is gathered, because it would get pleats


def longer_text(length: float, shortest: float, length_text: Callable[[float], str]) -> str:
    """Return a text such as "12 mm longer, ease between notches" about a side of a seam; "" for a shortest side.

    - length, shortest: lengths of this and the shortest side, in millimeters
    - length_text: writes a length as a text
    """
    more = length - shortest
    if more < LEAST:
        return ""
    how = "ease" if more <= GATHERED * shortest else "gather"
    return f"{length_text(more)} longer, {how} between notches"


def longer_texts(lengths: Sequence[float], units: UnitSystem) -> list[str]:
    """Return the text of longer_text() for each side of a seam. lengths: in millimeters."""
    return [longer_text(length, min(lengths), units.text) for length in lengths]


STRAIGHT = math.radians(1)  # radians; lines across a seam are equally straight if their turns differ by less
SAME_LENGTH = 0.01  # millimeters; lengths that differ by less count as equal, because nobody cuts more exactly
AT_VERTEX = 1e-6  # millimeters; a place closer to a point of the side counts as this point


@dataclass(frozen=True)
class SewnSide:
    """A side of a seam. All sides of the seam begin at the same vertex of the model."""

    side: Side
    is_forward: bool = True  # whether the seam runs in the direction of the outline
    start: int = 0  # row of the side at which the seam begins; 0 if the side is not a whole outline

    @property
    def sources(self) -> np.ndarray:
        return self._along_seam(self.side.sources)

    @property
    def points(self) -> np.ndarray:
        return self._along_seam(self.side.points)

    def _along_seam(self, rows: np.ndarray) -> np.ndarray:
        if self.start:
            rows = np.concatenate([rows[self.start : -1], rows[: self.start + 1]])
        return rows if self.is_forward else rows[::-1]

    @property
    def along(self) -> np.ndarray:
        return lengths_along(self.points)

    def at(self, length: float) -> tuple[np.ndarray, np.ndarray]:
        """Return the point (2,) at this length from the start, and the unit vector (2,) out of the piece there."""
        along, points = self.along, self.points
        row = min(int(np.searchsorted(along, length, side="right")) - 1, len(points) - 2)
        share = (length - along[row]) / (along[row + 1] - along[row])
        nearest = row + round(share)
        steps = points[row : row + 2]
        if abs(along[nearest] - length) < AT_VERTEX:
            # The mean of the normals before and after the point is used, so that symmetric places stay symmetric.
            if 0 < nearest < len(points) - 1:
                steps = points[nearest - 1 : nearest + 2]
            elif self.side.is_closed:
                steps = points[[-2, 0, 1]]
        normal = right_normals(steps).sum(axis=0)
        # The sum of the normals is 0 if the outline turns back on itself.
        normal /= max(float(np.linalg.norm(normal)), np.finfo(float).tiny)
        return points[row] + share * (points[row + 1] - points[row]), normal if self.is_forward else -normal


@dataclass(frozen=True)
class SewnLengths:
    """Sewn lengths along a seam: the lengths along its shortest side.

    Edges of all sides correspond one by one. Within an edge, ease is spread evenly.
    """

    along: np.ndarray  # (k,) length from the start to each vertex of the seam, millimeters

    @classmethod
    def of(cls, sides: Sequence[SewnSide]) -> "SewnLengths":
        lengths = [side.along for side in sides]
        # The lengths are rounded, so that the first of equally long sides is chosen.
        return cls(min(lengths, key=lambda along: round(float(along[-1]) / SAME_LENGTH)))

    @property
    def whole(self) -> float:
        return float(self.along[-1])

    def on(self, side: SewnSide, place: float) -> float:
        """Return the length along a side at this place. place: sewn length from the start of the seam."""
        return float(np.interp(place, self.along, side.along))

    def of_side(self, side: SewnSide, lengths: np.ndarray) -> np.ndarray:
        """Return the places (p,) in the seam, as sewn lengths, for these lengths (p,) along a side."""
        return np.interp(lengths, side.along, self.along)


def fixed_starts(sides: Iterable[Side]) -> dict[int, int]:
    """Return the vertex at which each seam around an opened tube begins: the end of the seam along the tube."""
    return {
        side.seam: int(side.sources[0])
        for side in sides
        if side.seam is not None and side.sources[0] == side.sources[-1] and not side.is_closed
    }


def sewn_sides(
    loops: Sequence[Sequence[Side]], count: int, starts: Mapping[int, int] | None = None
) -> list[list[SewnSide]]:
    """Return the sides of each of the `count` seams.

    - loops: outlines of all pieces
    - starts: by seam, the vertex at which whole outlines begin. Default: the end of an open side, or the lowest vertex
    """
    sides: list[list[Side]] = [[] for _ in range(count)]
    for side in (side for loop in loops for side in loop):
        if side.seam is not None:
            sides[side.seam].append(side)
    begins = fixed_starts(side for own in sides for side in own) | dict(starts or {})
    return [_begun_together(own, begins.get(seam)) for seam, own in enumerate(sides)]


def _begun_together(sides: Sequence[Side], vertex: int | None) -> list[SewnSide]:
    """Return the sides of one seam. vertex: vertex at which whole outlines begin; None for the lowest vertex."""
    begun: list[SewnSide] = []
    for side in sides:
        start = row_of(side, vertex) if side.is_closed else 0
        forward = SewnSide(side, start=start)
        is_forward = not begun or np.array_equal(forward.sources, begun[0].sources)
        begun.append(SewnSide(side, is_forward, start))
    return begun


def row_of(side: Side, vertex: int | None) -> int:
    """Return the row of a vertex in a side that is a whole outline. vertex: None for the lowest vertex."""
    sources = side.sources[:-1]
    return int(np.argmin(sources) if vertex is None else np.flatnonzero(sources == vertex)[0])


def is_dart(first: Side, second: Side, widest: float) -> bool:
    """Return whether two successive sides of an outline are the legs of a dart.

    widest: largest angle in radians at the tip, between the legs and between the lines to the mouth's ends.
    """
    if first.seam is None or first.seam != second.seam or first.piece != second.piece:
        return False
    if not np.array_equal(first.sources, second.sources[::-1]):
        return False
    tip, legs = first.points[-1], (first.points[0], second.points[-1])
    return math.pi + turn_between(first, second) < widest and _angle(*(leg - tip for leg in legs)) < widest


def _angle(first: np.ndarray, second: np.ndarray) -> float:
    return abs(math.atan2(first[0] * second[1] - first[1] * second[0], float(first @ second)))


def turn_between(first: Side, second: Side) -> float:
    """Return the left turn of the outline from the first to the second side in radians; -pi at the tip of a slit."""
    (a,), (b,) = right_normals(first.points[-2:]), right_normals(second.points[:2])
    turn = math.atan2(a[0] * b[1] - a[1] * b[0], a @ b)
    return turn - 2 * math.pi if turn > math.pi - 1e-6 else turn


def sewn_first(loops: Sequence[Sequence[Side]]) -> set[tuple[int, int]]:
    """Return pairs (vertex, seam): at the junction at this vertex, the seam is sewn before seams that cross its end."""
    angles: dict[int, dict[int, list[float]]] = defaultdict(lambda: defaultdict(list))
    beside: dict[tuple[int, int], set[int]] = defaultdict(set)
    length: dict[int, float] = {}
    for first, second in (corner for loop in loops for corner in pairwise([*loop, loop[0]])):
        vertex, inside = int(first.sources[-1]), math.pi - turn_between(first, second)
        for side, other in ((first, second), (second, first)):
            if side.seam is not None:
                angles[vertex][side.seam].append(inside)
                length[side.seam] = float(side.along[-1])
                if other.seam is not None:
                    beside[vertex, side.seam].add(other.seam)
    chosen = set()
    for vertex, by_seam in angles.items():
        # First is the seam whose crossing lines continue straightest, and of several such seams the shortest.
        rank = {
            seam: (round(abs(sum(inside) - math.pi) / STRAIGHT), round(length[seam] / SAME_LENGTH))
            for seam, inside in by_seam.items()
        }
        first_here: set[int] = set()
        for seam in sorted(rank, key=lambda seam: (rank[seam], seam)):
            others = beside[vertex, seam]
            # Equal neighbors, as at the pole of a ball, are not chosen, so that symmetric pieces stay symmetric.
            if not others & (first_here | {seam}) and all(rank[other] != rank[seam] for other in others):
                first_here.add(seam)
        chosen |= {(vertex, seam) for seam in first_here}
    return chosen
