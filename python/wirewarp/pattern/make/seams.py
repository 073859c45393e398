# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams on the flat pieces: their sides and lengths, the sewing order, and the ease."""

import math
from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..geometry import lengths_along, right_normals
from ..units import UnitSystem
from .outline import Side

LEAST = 0.5  # millimeters; smaller eases are ignored (errors of single precision are far smaller)
GATHERED = 0.15  # share of the shorter side; with more ease, fabric would get pleats, so it is gathered


def longer_text(length: float, shortest: float, length_text: Callable[[float], str]) -> str:
    """Return a text such as "12 mm longer, ease between notches" for a side; empty for the shortest sides. length_text:
    writes a length as text. All lengths are in millimeters."""
    more = length - shortest
    if more < LEAST:
        return ""
    how = "ease" if more <= GATHERED * shortest else "gather"
    return f"{length_text(more)} longer, {how} between notches"


def longer_texts(lengths: Sequence[float], units: UnitSystem) -> list[str]:
    """Return the texts of all sides of a seam."""
    return [longer_text(length, min(lengths), units.text) for length in lengths]


STRAIGHT = math.radians(1)  # radians; crossing lines are equally straight if their turns differ by less
SAME_LENGTH = 0.01  # millimeters
AT_VERTEX = 1e-6  # millimeters; a place this close to a point of the side is that point, except for rounding


@dataclass(frozen=True)
class SewnSide:
    """A side of a seam. All sides of the seam begin at the same vertex of the model."""

    side: Side
    is_forward: bool = True  # in the direction of the outline
    start: int = 0  # row of the side at which the seam begins; 0 unless the side is a whole outline

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
        """Return the point at this length from the start, and the unit vector that points out of the piece there."""
        along, points = self.along, self.points
        row = min(int(np.searchsorted(along, length, side="right")) - 1, len(points) - 2)
        share = (length - along[row]) / (along[row + 1] - along[row])
        nearest = row + round(share)
        steps = points[row : row + 2]
        if abs(along[nearest] - length) < AT_VERTEX:
            # halfway between the steps on both sides, so that symmetric places stay symmetric
            if 0 < nearest < len(points) - 1:
                steps = points[nearest - 1 : nearest + 2]
            elif self.side.is_closed:
                steps = points[[-2, 0, 1]]
        normal = right_normals(steps).sum(axis=0)
        # the length is 0 if the outline turns back on itself
        normal /= max(float(np.linalg.norm(normal)), np.finfo(float).tiny)
        return points[row] + share * (points[row + 1] - points[row]), normal if self.is_forward else -normal


@dataclass(frozen=True)
class SewnLengths:
    """Lengths along a seam as it is sewn: along its shortest side, which has no ease.

    The sides were one edge chain of the model, so their edges correspond one by one. Within an edge, lengths scale with
    the edge, because its ease is spread evenly.
    """

    along: np.ndarray  # (k,) to each vertex of the seam

    @classmethod
    def of(cls, sides: Sequence[SewnSide]) -> "SewnLengths":
        lengths = [side.along for side in sides]
        return cls(min(lengths, key=lambda along: round(float(along[-1]) / SAME_LENGTH)))  # the first of equal lengths

    @property
    def whole(self) -> float:
        return float(self.along[-1])

    def on(self, side: SewnSide, place: float) -> float:
        """Return the length along this side at this place of the seam."""
        return float(np.interp(place, self.along, side.along))

    def of_side(self, side: SewnSide, lengths: np.ndarray) -> np.ndarray:
        """Return the places in the seam for these lengths (p,) along this side."""
        return np.interp(lengths, side.along, self.along)


def fixed_starts(sides: Iterable[Side]) -> dict[int, int]:
    """Return the vertex where each seam around a tube begins: the end of the seam along the tube, which opens it."""
    return {
        side.seam: int(side.sources[0])
        for side in sides
        if side.seam is not None and side.sources[0] == side.sources[-1] and not side.is_closed
    }


def sewn_sides(
    loops: Sequence[Sequence[Side]], count: int, starts: Mapping[int, int] | None = None
) -> list[list[SewnSide]]:
    """Return the sides of each of the `count` seams, over the outlines of all pieces.

    starts: for each seam, the vertex where its sides that are whole outlines begin. The default is the end of a side
    that is open, or else their lowest vertex.
    """
    sides: list[list[Side]] = [[] for _ in range(count)]
    for side in (side for loop in loops for side in loop):
        if side.seam is not None:
            sides[side.seam].append(side)
    begins = fixed_starts(side for own in sides for side in own) | dict(starts or {})
    return [_begun_together(own, begins.get(seam)) for seam, own in enumerate(sides)]


def _begun_together(sides: Sequence[Side], vertex: int | None) -> list[SewnSide]:
    """Return the sides of one seam. vertex: where whole outlines begin; None for the lowest."""
    begun: list[SewnSide] = []
    for side in sides:
        start = row_of(side, vertex) if side.is_closed else 0
        forward = SewnSide(side, start=start)
        is_forward = not begun or np.array_equal(forward.sources, begun[0].sources)
        begun.append(SewnSide(side, is_forward, start))
    return begun


def row_of(side: Side, vertex: int | None) -> int:
    """Return the row of this vertex in a side that is a whole outline. vertex: None for the lowest."""
    sources = side.sources[:-1]
    return int(np.argmin(sources) if vertex is None else np.flatnonzero(sources == vertex)[0])


def is_dart(first: Side, second: Side, widest: float) -> bool:
    """Return whether two successive sides of an outline are the legs of a dart with its tip between them.

    widest: largest angle of the gap in radians, at the tip and from there to the mouth; a wider gap is the opening of a
    cone.
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
    """Return the left turn of the outline from the first to the second side, radians; -pi at the tip of a slit."""
    (a,), (b,) = right_normals(first.points[-2:]), right_normals(second.points[:2])
    turn = math.atan2(a[0] * b[1] - a[1] * b[0], a @ b)
    return turn - 2 * math.pi if turn > math.pi - 1e-6 else turn


def sewn_first(loops: Sequence[Sequence[Side]]) -> set[tuple[int, int]]:
    """Return (vertex of the junction, seam) for each seam that is sewn before the seams that cross its end.

    Once a seam is sewn, a line that crosses it should continue straight. At each junction, the first seam is therefore
    the one whose two neighbors form the straightest line across it, or the shorter one if two are equal. Other seams of
    the junction follow if they share no corner with a chosen one. Equal neighbors, as at the pole of a ball, are both
    left out, so that symmetric pieces stay symmetric. The answer is the same on both sides of a seam, so that its two
    allowances end alike.
    """
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
        rank = {
            seam: (round(abs(sum(inside) - math.pi) / STRAIGHT), round(length[seam] / SAME_LENGTH))
            for seam, inside in by_seam.items()
        }
        first_here: set[int] = set()
        for seam in sorted(rank, key=lambda seam: (rank[seam], seam)):
            others = beside[vertex, seam]
            if not others & (first_here | {seam}) and all(rank[other] != rank[seam] for other in others):
                first_here.add(seam)
        chosen |= {(vertex, seam) for seam in first_here}
    return chosen
