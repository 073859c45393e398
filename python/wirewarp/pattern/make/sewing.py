# SPDX-License-Identifier: GPL-3.0-or-later
"""An order in which the seams can be sewn: darts, then what stays flat, then rings, and last what closes a body.

Each assembly of pieces is kept as the closed loops of sides around it. Sewing two sides of different assemblies makes
one that is still flat, and so does sewing two that follow each other on a loop. Other sides of one loop close a ring,
such as a sleeve or a neckline.
"""

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np

from ..pattern_data import SewingStep, StepKind
from .outline import Side
from .pieces import Laid
from .seams import SewnSide, is_dart, sewn_first
from .sections import WIDEST_DART

RANKS: dict[StepKind, int] = {"dart": 0, "flat": 1, "ring": 2, "all around": 2, "closing": 3}
Likeness = tuple[set[int], float]
LEAST_GAP = 150.0  # millimeters: a shorter seam has no room for a gap of half its length to turn the work through


def sewing_steps(laid: Sequence[Laid], seams: Sequence[Sequence[SewnSide]], names: Sequence[str]) -> list[SewingStep]:
    """Each seam once. names: of the seams. If nothing stays open, one seam has a gap to turn the work through."""
    loops = [loop for piece in laid for loop in piece.loops]
    first = sewn_first(loops)
    waiting = {number: sides for number, sides in enumerate(seams) if len(sides) > 1}
    ends = {number: {int(sides[0].sources[0]), int(sides[0].sources[-1])} for number, sides in waiting.items()}
    gap = None if any(side.seam is None for loop in loops for side in loop) else _gap(waiting)
    assemblies, steps = _Assemblies(laid), list[SewingStep]()
    last: Likeness | None = None
    while waiting:
        ranks = {number: _rank(number, waiting, ends, first, assemblies, last) for number in waiting}
        number = min(ranks, key=ranks.__getitem__)
        last = _likeness(waiting[number])
        sides = [own.side for own in waiting.pop(number)]
        kind = assemblies.sew(sides)
        pieces = tuple(dict.fromkeys(laid[side.piece].name for side in sides))
        steps.append(SewingStep(names[number], kind, pieces, number == gap))
    return steps


def _rank(
    number: int,
    waiting: Mapping[int, Sequence[SewnSide]],
    ends: Mapping[int, set[int]],
    first: set[tuple[int, int]],
    assemblies: "_Assemblies",
    last: Likeness | None,
) -> tuple[bool, int, int, float]:
    """The lowest is sewn next. first: see sewn_first; last: of the seam before this one."""
    sides = [own.side for own in waiting[number]]
    kind = assemblies.kind(sides)
    is_other_side = kind != "closing" and _likeness(waiting[number]) == last
    crossed = sum(
        vertex in ends[other] and (vertex, other) in first
        for other in waiting
        for vertex in ends[number]
        if other != number
    )
    return not is_other_side, RANKS[kind], crossed, min(map(assemblies.area, sides))


def _gap(seams: dict[int, Sequence[SewnSide]]) -> int | None:
    """The straightest of the seams that are long enough; the longest if none is."""
    lengths = {number: float(sides[0].along[-1]) for number, sides in seams.items()}
    enough = [number for number, length in lengths.items() if length >= LEAST_GAP]
    if not enough:
        return max(lengths, key=lambda number: lengths[number], default=None)

    def straightness(number: int) -> float:
        return min(float(np.linalg.norm(own.points[-1] - own.points[0])) for own in seams[number]) / lengths[number]

    return max(enough, key=straightness)


def _likeness(sides: Sequence[SewnSide]) -> Likeness:
    """What a seam has in common with that on the other side of the body, which is sewn next: pieces and length."""
    return {own.side.piece for own in sides}, round(float(sides[0].along[-1]), 1)


class _Assemblies:
    def __init__(self, laid: Sequence[Laid]) -> None:
        self._loops: dict[int, list[int]] = {}  # by number, the id() of each side, in order
        self._of_side: dict[int, int] = {}  # by its id(), the loop of a side
        self._assembly = list(range(len(laid)))  # by piece
        self._areas = [piece.area for piece in laid]
        self._legs: set[int] = set()  # the id() of each side of a dart
        for loop in (loop for piece in laid for loop in piece.loops):
            self._add([id(side) for side in loop])
            for side, following in pairwise([*loop, loop[0]]):
                if is_dart(side, following, WIDEST_DART):
                    self._legs |= {id(side), id(following)}

    def area(self, side: Side) -> float:
        """Of the whole assembly that the side belongs to."""
        own = self._assembly[side.piece]
        return sum(area for area, assembly in zip(self._areas, self._assembly, strict=True) if assembly == own)

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
        return "flat" if any(between) else "closing"

    def sew(self, sides: Sequence[Side]) -> StepKind:
        """Sides beyond the second, as of a pocket, lie on these."""
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
        self._assembly = [min(joined) if each in joined else each for each in self._assembly]
        return kind

    def _add(self, loop: list[int]) -> None:
        number = max(self._loops, default=-1) + 1 + len(self._of_side)
        self._loops[number] = loop
        self._of_side.update(dict.fromkeys(loop, number))

    def _after(self, side: Side) -> list[int]:
        """The other sides of its loop, from its end on."""
        loop = self._loops[self._of_side[id(side)]]
        at = loop.index(id(side))
        return loop[at + 1 :] + loop[:at]

    def _between(self, first: Side, second: Side) -> tuple[list[int], list[int]]:
        """What lies between two sides of one loop, on both ways round."""
        after = self._after(first)
        at = after.index(id(second))
        return after[:at], after[at + 1 :]
