# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs pieces without a library: each piece slides along the fabric until it touches other pieces.

Only the used length of each lengthwise row of the fabric is stored, so gaps behind pieces stay empty.
"""

import math
from collections.abc import Generator, Sequence
from dataclasses import dataclass

import numpy as np

from .items import Grain, Item, angles

ROWS = 400  # number of rows; a row is 4 mm wide on a fabric of 1.5 m
FREE_STEP = 30.0  # degrees between two turns of a piece if all turns are allowed


@dataclass(frozen=True)
class Place:
    """Place of an item on the fabric, after room_at_edges() has enlarged the fabric. Lengths are in millimeters."""

    item: int
    angle: float
    at: np.ndarray  # (2,) place of the item's origin
    sheet: int


@dataclass(frozen=True)
class _Profile:
    """The start and end of an item in each row, after one of its turns. Lengths are in millimeters."""

    angle: float
    # For each of the r rows that the item covers, these are the lengths along the fabric from the lowest point of the
    # whole item to its start and to its end in this row.
    low: np.ndarray  # (r,)
    high: np.ndarray  # (r,)
    corner: np.ndarray  # (2,) lower left corner of the box of the turned item

    @property
    def height(self) -> float:
        return float(self.high.max())


class TooLargeError(Exception):
    def __init__(self, item: int) -> None:
        super().__init__(item)
        self.item = item


class SlidePacking:
    def __init__(self, items: Sequence[Item], grain: Grain, width: float, length: float) -> None:
        """Prepare to pack the items. length: length of a sheet, or infinity for a roll."""
        self._items, self._grain, self._length = items, grain, length
        self._row = width / ROWS
        self._profiles: list[list[_Profile]] = []
        self._random = np.random.default_rng(0)

    def trials(self) -> Generator[list[Place] | None, None, None]:
        """Yield packings without end, each in another order of the items, and None in between.

        Raises TooLargeError if an item does not fit.
        """
        for index, item in enumerate(self._items):
            yield None
            turned = (_profile(item, angle, self._row) for angle in angles(item, self._grain, FREE_STEP))
            fitting = [each for each in turned if len(each.low) <= ROWS and each.height <= self._length + 1e-9]
            if not fitting:
                raise TooLargeError(index)
            self._profiles.append(fitting)
        copies = [index for index, item in enumerate(self._items) for _ in range(item.count)]
        order, best = sorted(copies, key=lambda index: -self._items[index].area), (math.inf, math.inf)
        tried = order
        while True:
            places, score = yield from self._packed(tried)
            yield places
            if score <= best:
                order, best = tried, score
            tried = order.copy()
            first, second = self._random.integers(len(order), size=2)
            tried[first], tried[second] = tried[second], tried[first]

    def _packed(self, order: Sequence[int]) -> Generator[None, None, tuple[list[Place], tuple[int, float]]]:
        """Return the packing in this order of items, and its score: the number of sheets and the used length of the
        last sheet."""
        fronts: list[np.ndarray] = []
        places = []
        for index in order:
            yield
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
        """Return the turn, first row and start with which the item ends earliest and wastes least. Return None if there
        is no room.

        front (ROWS,): used length of each row.
        """
        best, found = (math.inf, math.inf), None
        for profile in self._profiles[index]:
            taken = np.lib.stride_tricks.sliding_window_view(front, len(profile.low))
            y = (taken - profile.low).max(axis=1)
            end = np.round(y + profile.height, 1)
            # The waste is rounded to whole millimeters, so that the leftmost of nearly equal places is chosen.
            wasted = np.round((y[:, None] + profile.low - taken).mean(axis=1))
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
        # Each side of the outline is divided at the borders of rows, so that each part is in one row.
        left, right = sorted((a[0], b[0]))
        borders = row * np.arange(math.floor(left / row) + 1, math.ceil(right / row))
        shares = np.sort((borders - a[0]) / (b[0] - a[0])) if len(borders) else np.empty(0)
        shares = np.concatenate([[0.0], shares, [1.0]])
        x, y = a[0] + shares * (b[0] - a[0]), a[1] + shares * (b[1] - a[1])
        own = np.clip(((x[:-1] + x[1:]) / 2 / row).astype(int), 0, rows - 1)
        np.minimum.at(low, own, np.minimum(y[:-1], y[1:]))
        np.maximum.at(high, own, np.maximum(y[:-1], y[1:]))
    return _Profile(angle, low, high, corner)
