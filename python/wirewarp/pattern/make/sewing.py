# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds an order for sewing the seams: darts, flat seams, rings, and last the seams that close a body."""

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np

from ..pattern_data import SewingStep, StepKind
from ..progress import Steps
from .outline import Side
from .pieces import Laid
from .seams import SewnSide, is_dart, sewn_first
from .sections import WIDEST_DART

RANKS: dict[StepKind, int] = {"dart": 0, "flat": 1, "ring": 2, "all around": 2, "closing": 3}
Likeness = tuple[set[int], float]  # pieces of a seam, and its length in millimeters
# In a seam below this many millimeters, an opening as wide as a hand (75 mm) would be more than half of the seam.
ROOM_FOR_GAP = 150.0


def sewing_steps(
    laid: Sequence[Laid], seams: Sequence[Sequence[SewnSide]], names: Sequence[str]
) -> Steps[list[SewingStep]]:
    """Return each seam once, in sewing order. names: names of the seams. If a body has no open edge, one of its seams
    has an opening through which the body is turned."""
    first = sewn_first([loop for piece in laid for loop in piece.loops])
    waiting = {number: [own.side for own in sides] for number, sides in enumerate(seams) if len(sides) > 1}
    ends = {number: {int(sides[0].sources[0]), int(sides[0].sources[-1])} for number, sides in waiting.items()}
    meeting: dict[int, set[int]] = {}  # seams that are not sewn yet, by the vertices at which they end
    for number, own in ends.items():
        for vertex in own:
            meeting.setdefault(vertex, set()).add(number)
    gaps = _gaps(laid, waiting)
    assemblies, steps = _Assemblies(laid), list[SewingStep]()
    last: Likeness | None = None
    while waiting:
        yield "marks and lines", 1.0
        ranks = {}
        for number, sides in waiting.items():
            kind = assemblies.kind(sides)
            is_other_side = kind != "closing" and _likeness(sides) == last
            crossed = sum((v, other) in first for v in ends[number] for other in meeting[v] if other != number)
            ranks[number] = not is_other_side, RANKS[kind], crossed, min(map(assemblies.area, sides))
        number = min(ranks, key=ranks.__getitem__)
        sides = waiting.pop(number)
        last = _likeness(sides)
        for vertex in ends[number]:
            meeting[vertex].remove(number)
        pieces = tuple(dict.fromkeys(laid[side.piece].name for side in sides))
        steps.append(SewingStep(names[number], assemblies.sew(sides), pieces, number in gaps))
    return steps


def _gaps(laid: Sequence[Laid], seams: Mapping[int, Sequence[Side]]) -> set[int]:
    """Return one seam for each body without an open edge: its straightest seam that is long enough for an opening.

    If all seams of a body are too short, return its longest seam.
    """
    bodies = [{piece.index} for piece in laid]
    for sides in seams.values():
        joined = {side.piece for side in sides}
        met = [body for body in bodies if body & joined]
        bodies = [body for body in bodies if not body & joined] + [set().union(*met)]
    gaps = set()
    for body in bodies:
        own = {number: sides[0] for number, sides in seams.items() if sides[0].piece in body}
        is_open = any(side.seam is None for piece in body for loop in laid[piece].loops for side in loop)
        if own and not is_open:
            gaps.add(max(own, key=lambda number: _fitness(own[number])))  # noqa: B023 (called immediately)
    return gaps


def _fitness(side: Side) -> tuple[bool, float]:
    length = float(side.along[-1])
    is_enough = length >= ROOM_FOR_GAP
    return is_enough, float(np.linalg.norm(side.points[-1] - side.points[0])) / length if is_enough else length


def _likeness(sides: Sequence[Side]) -> Likeness:
    """Return the pieces and the rounded length of a seam. Seams with equal pieces and lengths are sewn in sequence."""
    return {side.piece for side in sides}, round(float(sides[0].along[-1]), 1)


class _Assemblies:
    """Sets of pieces that are already sewn together. Each is stored as the closed loops of its open sides."""

    def __init__(self, laid: Sequence[Laid]) -> None:
        self._loops: dict[int, list[int]] = {}  # by number of the loop, the id() of each of its sides, in order
        self._of_side: dict[int, int] = {}  # number of the loop of each side, by the id() of the side
        self._assembly = list(range(len(laid)))  # assembly of each piece
        self._areas = [piece.area for piece in laid]  # area of each assembly
        self._legs: set[int] = set()  # the id() of each side of a dart
        for loop in (loop for piece in laid for loop in piece.loops):
            self._add([id(side) for side in loop])
            for side, following in pairwise([*loop, loop[0]]):
                if is_dart(side, following, WIDEST_DART):
                    self._legs |= {id(side), id(following)}

    def area(self, side: Side) -> float:
        return self._areas[self._assembly[side.piece]]

    def kind(self, sides: Sequence[Side]) -> StepKind:
        first, second = sides[:2]
        if first.is_closed:
            return "all around"
        if id(first) in self._legs:
            return "dart"
        if self._assembly[first.piece] != self._assembly[second.piece]:
            return "flat"
        if self._of_side[id(first)] != self._of_side[id(second)]:
            return "ring"
        between = self._between(first, second)
        if all(between):
            return "ring"
        # Sewing successive sides keeps the assembly flat. If the loop has no other side, sewing them closes the body.
        return "flat" if any(between) else "closing"

    def sew(self, sides: Sequence[Side]) -> StepKind:
        """Sew the first two sides, and return the kind of step. Further sides, for example of a pocket, are sewn on
        top."""
        kind, (first, second) = self.kind(sides), sides[:2]
        if self._of_side[id(first)] == self._of_side[id(second)]:
            left = self._between(first, second)
        else:
            left = (self._after(first) + self._after(second), [])
        for side in (first, second):
            self._loops.pop(self._of_side[id(side)], None)
        for loop in left:
            self._add(loop)
        joined = {self._assembly[side.piece] for side in sides}
        self._areas[min(joined)] = sum(self._areas[each] for each in joined)
        self._assembly = [min(joined) if each in joined else each for each in self._assembly]
        return kind

    def _add(self, loop: list[int]) -> None:
        number = max(self._loops, default=-1) + 1 + len(self._of_side)
        self._loops[number] = loop
        self._of_side.update(dict.fromkeys(loop, number))

    def _after(self, side: Side) -> list[int]:
        """Return the id() of the other sides of a side's loop, beginning with the side after it."""
        loop = self._loops[self._of_side[id(side)]]
        at = loop.index(id(side))
        return loop[at + 1 :] + loop[:at]

    def _between(self, first: Side, second: Side) -> tuple[list[int], list[int]]:
        """Return the id() of the sides between two sides of one loop: from `first` to `second`, and then back to
        `first`."""
        after = self._after(first)
        at = after.index(id(second))
        return after[:at], after[at + 1 :]
