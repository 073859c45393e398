# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams on the flat pieces: their sides: which are sewn first, how long their sides are, and what is eased in."""

import math
from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ..geometry import lengths_along, right_normals
from ..units import UnitSystem
from .outline import Side

LEAST = 0.5  # millimeters; nobody eases in less, and flat pieces in single precision are off by far less
GATHERED = 0.15  # of the shorter side: more than this no cloth is eased in without pleats, it is gathered


def longer_text(length: float, shortest: float, length_text: Callable[[float], str]) -> str:
    """ "12 mm longer, ease between notches" of a side of this length; empty of the shortest ones.

    length_text: writes a length. All lengths are in millimeters.
    """
    more = length - shortest
    if more < LEAST:
        return ""
    how = "ease" if more <= GATHERED * shortest else "gather"
    return f"{length_text(more)} longer, {how} between notches"


def longer_texts(lengths: Sequence[float], units: UnitSystem) -> list[str]:
    """Of all sides of a seam."""
    return [longer_text(length, min(lengths), units.text) for length in lengths]


STRAIGHT = math.radians(1)  # crossing lines that differ less in straightness are alike
SAME_LENGTH = 0.01  # millimeters
AT_VERTEX = 1e-6  # millimeters along a side from one of its points: rounding


@dataclass(frozen=True)
class SewnSide:
    """A side of a seam. All sides of the seam begin at the same vertex of the model."""

    side: Side
    is_forward: bool  # as the outline runs

    @property
    def sources(self) -> np.ndarray:
        return self.side.sources if self.is_forward else self.side.sources[::-1]

    @property
    def points(self) -> np.ndarray:
        return self.side.points if self.is_forward else self.side.points[::-1]

    @property
    def along(self) -> np.ndarray:
        return lengths_along(self.points)

    def at(self, length: float) -> tuple[np.ndarray, np.ndarray]:
        """The point at this length from the start, and the unit vector out of the piece there."""
        along, points = self.along, self.points
        row = min(int(np.searchsorted(along, length, side="right")) - 1, len(points) - 2)
        share = (length - along[row]) / (along[row + 1] - along[row])
        nearest = row + round(share)
        steps = slice(row, row + 2)
        if abs(along[nearest] - length) < AT_VERTEX and 0 < nearest < len(points) - 1:
            steps = slice(nearest - 1, nearest + 2)  # halfway between the steps on both sides: symmetric ones stay so
        normal = right_normals(points[steps]).sum(axis=0)
        normal /= max(float(np.linalg.norm(normal)), np.finfo(float).tiny)  # 0 where the outline turns back on itself
        return points[row] + share * (points[row + 1] - points[row]), normal if self.is_forward else -normal


@dataclass(frozen=True)
class SewnLengths:
    """Lengths along a seam as it is sewn: along the shortest of its sides, which nothing is eased in of.

    What is sewn together was one edge of the model, so that edges of the sides correspond one by one, and within an
    edge lengths are to each other as the edges are: all that was eased of it is spread evenly.
    """

    along: np.ndarray  # (k,) to each vertex of the seam

    @classmethod
    def of(cls, sides: Sequence[SewnSide]) -> "SewnLengths":
        lengths = [side.along for side in sides]
        return cls(min(lengths, key=lambda along: round(float(along[-1]) / SAME_LENGTH)))  # the first of equal ones

    @property
    def whole(self) -> float:
        return float(self.along[-1])

    def on(self, side: SewnSide, place: float) -> float:
        """The length along this side at which it is sewn to the others at this place."""
        return float(np.interp(place, self.along, side.along))

    def of_side(self, side: SewnSide, lengths: np.ndarray) -> np.ndarray:
        """(p,) where lengths (p,) along this side are sewn."""
        return np.interp(lengths, side.along, self.along)


def sewn_sides(loops: Sequence[Sequence[Side]], count: int) -> list[list[SewnSide]]:
    """Of each of the `count` seams the sides, over the outlines of all pieces."""
    sides: list[list[Side]] = [[] for _ in range(count)]
    for loop in loops:
        for side in loop:
            if side.seam is not None:
                sides[side.seam].append(side)
    return [[_directed(side, own[0]) for side in own] for own in sides]


def _directed(side: Side, first: Side) -> SewnSide:
    return SewnSide(side, bool(np.array_equal(side.sources, first.sources)))


def is_dart(first: Side, second: Side, widest: float) -> bool:
    """Whether the two, one after the other on an outline, are the legs of a dart with its tip between them.

    widest: angle in radians of the gap, at the tip and from there to the mouth; a wider one is the opening of a cone.
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
    """By how much the outline turns left where the second side follows the first, radians; at a slit's tip -pi."""
    (a,), (b,) = right_normals(first.points[-2:]), right_normals(second.points[:2])
    turn = math.atan2(a[0] * b[1] - a[1] * b[0], a @ b)
    return turn - 2 * math.pi if turn > math.pi - 1e-6 else turn


def _corners(loops: Sequence[Sequence[Side]]) -> Iterator[tuple[Side, Side]]:
    for loop in loops:
        for number, side in enumerate(loop):
            yield side, loop[(number + 1) % len(loop)]


def sewn_first(loops: Sequence[Sequence[Side]]) -> set[tuple[int, int]]:
    """(junction's input vertex, seam) of the seams that are sewn before what crosses them at their end.

    What crosses a seam should run on straight over it once it is sewn: so at each junction first the seam over which
    the two neighbors come nearest to a straight line, the shorter one of equals, then others that share no corner
    with one chosen. Neighbors that are alike, as at the pole of a ball, are both left out: symmetry is kept. On both
    sides of a seam the answer is the same, so that its two allowances end alike.
    """
    angles: dict[int, dict[int, list[float]]] = defaultdict(lambda: defaultdict(list))
    beside: dict[tuple[int, int], set[int]] = defaultdict(set)
    length: dict[int, float] = {}
    for first, second in _corners(loops):
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
