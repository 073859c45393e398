# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs pieces without a library: each slides along the cloth until it touches those that lie there already.

The cloth is divided into narrow rows along it, of which each knows how far it is taken; a piece knows where it begins
and ends in each row that it covers. Gaps behind pieces stay empty. Other orders are tried while there is time.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from .nest_items import STAGE, Grain, Item, angles
from .progress import Watch

ROWS = 400  # of a cloth of 1.5 m each is 4 mm wide
FREE_STEP = 30.0  # degrees between the turns that are tried where all are allowed


@dataclass(frozen=True)
class Place:
    """Where an item lies, in the cloth with room at its edges."""

    item: int
    angle: float
    at: np.ndarray  # (2,) of the item's origin
    sheet: int


@dataclass(frozen=True)
class _Profile:
    """Of an item that is turned."""

    angle: float
    low: np.ndarray  # (r,) where it begins in each row that it covers, from its lowest point
    high: np.ndarray  # (r,)
    corner: np.ndarray  # (2,) the lowest corner of its box

    @property
    def height(self) -> float:
        return float(self.high.max())


class SlidePacking:
    def __init__(self, items: Sequence[Item], grain: Grain, width: float, length: float, watch: Watch) -> None:
        """length: of a sheet; infinite of a roll. Raises ValueError with the item's index if one does not fit."""
        self._items, self._length, self._watch = items, length, watch
        self._row = width / ROWS
        self._profiles = []
        for index, item in watch.each(list(enumerate(items)), STAGE):
            turned = (_profile(item, angle, self._row) for angle in angles(item, grain, FREE_STEP))
            fitting = [each for each in turned if len(each.low) <= ROWS and each.height <= length + 1e-9]
            if not fitting:
                raise ValueError(index)
            self._profiles.append(fitting)
        copies = [index for index, item in enumerate(items) for _ in range(item.count)]
        self._order = sorted(copies, key=lambda index: -items[index].area)
        self._random = np.random.default_rng(0)

    def trials(self) -> Iterator[list[Place]]:
        """Without end: packings, each in another order, which is kept where it takes no more cloth."""
        order, best = self._order, (math.inf, math.inf)
        tried = order
        while True:
            places, score = self._packed(tried)
            yield places
            if score <= best:
                order, best = tried, score
            tried = order.copy()
            first, second = self._random.integers(len(order), size=2)
            tried[first], tried[second] = tried[second], tried[first]

    def _packed(self, order: Sequence[int]) -> tuple[list[Place], tuple[int, float]]:
        """With the number of sheets and the length that is used of the last one."""
        fronts: list[np.ndarray] = []
        places = []
        for index in self._watch.each(order, STAGE):
            sheet, found = -1, None
            while found is None:
                sheet += 1
                if sheet == len(fronts):
                    fronts.append(np.zeros(ROWS))
                found = self._best(index, fronts[sheet])
            profile, row, y = found
            fronts[sheet][row : row + len(profile.low)] = y + profile.high
            at = np.array([row * self._row, y]) - profile.corner
            places.append(Place(index, profile.angle, at, sheet))
        return places, (len(fronts), float(fronts[-1].max()))

    def _best(self, index: int, front: np.ndarray) -> tuple[_Profile, int, float] | None:
        """How it is turned, the first row, and where in these it lies: where it ends earliest, and wastes least."""
        best, found = (math.inf, math.inf), None
        for profile in self._profiles[index]:
            taken = np.lib.stride_tricks.sliding_window_view(front, len(profile.low))
            y = (taken - profile.low).max(axis=1)
            end = np.round(y + profile.height, 1)
            wasted = np.round((y[:, None] + profile.low - taken).mean(axis=1))  # in whole millimeters: else left first
            row = int(np.lexsort((wasted, end))[0])
            rank = (float(end[row]), float(wasted[row]))
            if y[row] + profile.height <= self._length + 1e-9 and rank < best:
                best, found = rank, (profile, row, float(y[row]))
        return found


def _profile(item: Item, angle: float, row: float) -> _Profile:
    points = item.turned(angle)
    corner = points.min(axis=0)
    points = points - corner
    rows = max(math.ceil(points[:, 0].max() / row - 1e-9), 1)
    low, high = np.full(rows, math.inf), np.full(rows, -math.inf)
    for a, b in zip(points, np.roll(points, -1, axis=0), strict=True):
        # Cut at the borders of rows, so that each part lies in one of them.
        left, right = sorted((a[0], b[0]))
        borders = row * np.arange(math.floor(left / row) + 1, math.ceil(right / row))
        shares = np.sort((borders - a[0]) / (b[0] - a[0])) if len(borders) else np.empty(0)
        shares = np.concatenate([[0.0], shares, [1.0]])
        x, y = a[0] + shares * (b[0] - a[0]), a[1] + shares * (b[1] - a[1])
        own = np.clip(((x[:-1] + x[1:]) / 2 / row).astype(int), 0, rows - 1)
        np.minimum.at(low, own, np.minimum(y[:-1], y[1:]))
        np.maximum.at(high, own, np.maximum(y[:-1], y[1:]))
    return _Profile(angle, low, high, corner)
