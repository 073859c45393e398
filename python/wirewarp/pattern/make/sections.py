# SPDX-License-Identifier: GPL-3.0-or-later
"""Divides the outlines of a piece into sections of one width, closes darts, and finds a rule for each corner."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal, get_args

import numpy as np

from ..checks import problem
from ..geometry import signed_area
from .allowance import Corner, Section
from .corners import CORNER_TYPES
from .outline import Side
from .seams import is_dart, sewn_first
from .widths import Widths

Darts = Literal["close", "cut", "slit"]
# A gap with a smaller angle, in radians, is a dart. A wider gap, such as the gap of a cone, is cut out.
WIDEST_DART = math.radians(50)
WIDEST_FOLD = 50.0  # millimeters of fabric in a closed dart, 25 on each side; tailors cut wider darts out
LEAST_GAP = 0.01  # millimeters; a narrower dart has no room between its legs, and is cut as one line
# A cap is the cutting line across the mouth of a closed dart. Its peak may be this multiple of the mouth away from the
# middle of the mouth. Otherwise, the cap is straight.
HIGHEST_CAP = 1.0


@dataclass(frozen=True)
class Run:
    """A part of a side that has one width of allowance."""

    side: Side
    points: np.ndarray  # (k,2)
    width: float | None  # None for a leg of a closed dart, where the fabric is not cut
    is_fold: bool = False


@dataclass(frozen=True)
class Dart:
    first: Side  # the leg that runs toward the tip
    second: Side

    @property
    def tip(self) -> np.ndarray:
        return self.first.points[-1]

    @property
    def mouth(self) -> np.ndarray:
        """Return the ends (2,2) of both legs on the outline."""
        return np.array([self.first.points[0], self.second.points[-1]])

    @property
    def gap(self) -> float:
        """Return the largest distance between the legs, in millimeters."""
        return float(np.linalg.norm(self.first.points - self.second.points[::-1], axis=1).max())


@dataclass(frozen=True)
class Outline:
    runs: list[Run]  # sewn or hemmed parts, in order
    sections: list[Section]  # parts from which the cutting line is made; none for a slit inside the piece
    darts: list[Dart]
    slits: list[np.ndarray]  # (k,2) cuts along the legs of darts without a gap

    @property
    def closed_darts(self) -> list[Dart]:
        closed = {id(run.side) for run in self.runs if run.width is None}
        return [dart for dart in self.darts if id(dart.first) in closed]


class Rules:
    """Rules for the ends of allowances at corners, and for cutting darts."""

    def __init__(self, loops: Sequence[Sequence[Side]], corner: str, darts: str) -> None:
        if corner not in ("auto", *CORNER_TYPES):
            raise problem(f"corner is {corner!r}: give {', '.join(map(repr, CORNER_TYPES))} or 'auto'.")
        if darts not in get_args(Darts):
            raise problem(f"darts is {darts!r}: give 'close', 'cut' or 'slit'.")
        self.darts = darts
        self._corner = corner
        self._first = sewn_first(loops) if corner == "auto" else set()

    def corner(self, first: Side, second: Side) -> Corner:
        """Return the rule for the corner between two successive sides of an outline."""
        if self._corner != "auto":
            return Corner(self._corner)  # type: ignore[arg-type]
        # A hem is folded last, onto the allowances of the seams that end at the hem.
        if (first.seam is None) != (second.seam is None):
            return Corner("fold-back", of_next=second.seam is None)
        # The allowance of a seam that is sewn first is folded back, and ends on the crossing seam's cutting line.
        vertex = int(first.sources[-1])
        for seam, of_next in ((first.seam, False), (second.seam, True)):
            if seam is not None and (vertex, seam) in self._first:
                return Corner("fold-back", of_next)
        return Corner()


def outline(loop: Sequence[Side], widths: Widths, rules: Rules) -> Outline:
    count = len(loop)
    # A slit inside a piece counts as two darts, because it has two tips.
    corners_of_loop = [*pairwise([*loop, loop[0]])] if rules.darts != "cut" else []
    darts = [Dart(first, second) for first, second in corners_of_loop if is_dart(first, second, WIDEST_DART)]
    if rules.darts == "close":
        darts = [dart for dart in darts if dart.gap <= WIDEST_FOLD]
    is_outer = signed_area(np.concatenate([side.points[:-1] for side in loop])) > 0
    if rules.darts == "close" and is_outer and 2 * len(darts) == count:
        darts = []  # the darts are cut out, because no other part of the outline is between them
    legs = [side for dart in darts for side in (dart.first, dart.second)]

    def is_leg(side: Side) -> bool:
        return any(side is leg for leg in legs)

    by_side = []
    for side in loop:
        runs = _runs(side, *widths.of(side))
        if is_leg(side):
            runs = [Run(side, side.points, None if rules.darts == "close" else 0.0)]
        by_side.append(runs)
    runs = [run for own in by_side for run in own]
    is_slit = rules.darts == "slit"
    slits = [dart.first.points for dart in darts if is_slit and dart.gap < LEAST_GAP]
    if all(map(is_leg, loop)) and (rules.darts == "close" or slits):
        return Outline(runs, [], darts, slits[:1])
    sections: list[Section] = []
    for number, (side, own) in enumerate(zip(loop, by_side, strict=True)):
        following = loop[(number + 1) % count]
        if rules.darts == "close" and is_leg(side):
            dart = next((dart for dart in darts if dart.first is side), None)
            # Without a gap, the outline continues past the dart.
            if dart and np.linalg.norm(dart.mouth[1] - dart.mouth[0]) > LEAST_GAP:
                before, after = by_side[number - 1][-1], by_side[(number + 2) % count][0]
                # If two darts begin at the same point, no part of the outline is between them, so the cap is straight.
                cap = dart.mouth if None in (before.width, after.width) else _cap(dart, before, after)
                sections.append(Section(cap, _width_before(by_side, number)))
            continue
        corners = [Corner()] * (len(own) - 1) + [rules.corner(side, following)]
        if rules.darts != "cut" and is_leg(following):
            corners[-1] = Corner()
        sections += [Section(run.points, run.width or 0.0, corner) for run, corner in zip(own, corners, strict=True)]
    return Outline(runs, sections, darts, slits)


def _runs(side: Side, widths: np.ndarray, folds: np.ndarray) -> list[Run]:
    changes = np.flatnonzero((np.diff(widths) != 0) | (folds[1:] != folds[:-1])) + 1
    ends = [0, *changes.tolist(), len(widths)]
    return [
        Run(side, side.points[a : b + 1], float(widths[a]), bool(folds[a]))
        for a, b in zip(ends[:-1], ends[1:], strict=True)
    ]


def _width_before(by_side: Sequence[Sequence[Run]], number: int) -> float:
    """Return the width of the last allowance before a side. Closed darts are skipped, because they have no allowance.

    number: index of the side.
    """
    runs = [run for own in (*by_side[number:], *by_side[:number]) for run in own]
    return next(run.width for run in reversed(runs) if run.width is not None)


def _cap(dart: Dart, before: Run, after: Run) -> np.ndarray:
    """Return the cutting line (k,2) across the mouth of a dart.

    It reflects the outlines beside the dart at the legs, so that the folded dart continues these outlines.
    """
    a, b = dart.mouth
    flat = np.array([a, b])
    first = _reflected(before.points[-2] - a, dart.first.points[1] - a)
    second = _reflected(after.points[1] - b, dart.second.points[-2] - b)
    system = np.column_stack([first, -second])
    if abs(np.linalg.det(system)) < 1e-6 * np.linalg.norm(first) * np.linalg.norm(second):
        return flat
    along, _ = shares = np.linalg.solve(system, b - a)
    peak = a + along * first
    is_near = np.linalg.norm(peak - (a + b) / 2) <= HIGHEST_CAP * np.linalg.norm(b - a)
    return np.array([a, peak, b]) if np.all(shares > 0) and is_near else flat


def _reflected(vector: np.ndarray, axis: np.ndarray) -> np.ndarray:
    axis = axis / np.linalg.norm(axis)
    return 2 * (vector @ axis) * axis - vector
