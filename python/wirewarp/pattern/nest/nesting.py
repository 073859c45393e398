# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds a marker: the shortest roll, or the fewest sheets, from which the pieces of a pattern can be cut."""

import math
import time
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from numbers import Real
from typing import get_args

import numpy as np

from ..._errors import FlattenError
from ..checks import checked_length, problem
from ..geometry import Motion
from ..marker import Marker, Placement, size_of
from ..model import PatternPiece
from ..progress import Steps
from ..units import UnitSystem
from .items import Grain, Item, items_of, room_at_edges
from .slide_packing import Place, SlidePacking, TooLargeError
from .spyrrow_nesting import SpyrrowError, is_installed, searched

WIDEST = 100_000.0  # millimeters; a larger value is probably in another unit
MOST_GAP = 100.0  # millimeters; a larger gap is probably in another unit
MOST_PIECES = 10_000  # largest number of pieces to cut, including all copies; a larger number is probably a mistake
LONGEST = 3600.0  # seconds: longest duration of a search; a larger number is probably a mistake

Preview = Callable[[Marker], object]


@dataclass(frozen=True)
class Cloth:
    """The fabric and the rules for placing pieces on it. Lengths are in millimeters."""

    width: float
    length: float | None  # length of a sheet; None for a roll
    gap: float
    grain: Grain

    def __post_init__(self) -> None:
        """Convert the lengths to floats, and check all fields. Raises FlattenError."""
        for name, least, most in (("width", 1.0, WIDEST), ("length", 1.0, WIDEST), ("gap", 0.0, MOST_GAP)):
            given = getattr(self, name)
            if given is not None or name != "length":
                object.__setattr__(self, name, checked_length(name, given, least, most))
        if self.grain not in get_args(Grain):
            raise problem(f"grain is {self.grain!r}: give {', '.join(map(repr, get_args(Grain)))}.")


def nesting(
    pieces: Sequence[PatternPiece], cloth: Cloth, times: int, seconds: float, units: UnitSystem, preview: Preview | None
) -> Steps[Marker]:
    """Do the work of Pattern.nesting(). pieces: the pieces, with pieces on the fold already opened."""
    count = sum(sum(piece.quantity) for piece in pieces)
    if type(times) is not int or not 1 <= times * count <= MOST_PIECES:
        raise problem(f"times is {times!r}: give a whole number from 1, and at most {MOST_PIECES} pieces in total.")
    if not isinstance(seconds, Real) or not 0 <= seconds <= LONGEST:
        raise problem(f"seconds is {seconds!r}: give a number from 0 to {LONGEST:g}.")
    begin = time.monotonic()

    def share() -> float:
        return min((time.monotonic() - begin) / seconds, 1.0) if seconds else 1.0

    search = _Search(pieces, cloth, times, units)
    best: Marker | None = None
    try:
        # The function closing() ends the search after an error, so that no process continues.
        with closing(search.markers(seconds)) as markers:
            for marker in markers:
                yield "nesting", share()
                if marker and (best is None or _extent(marker) < _extent(best)):
                    best = marker
                    if preview:
                        preview(marker)
                if best and share() == 1.0:
                    break
    except FlattenError as error:
        if error.code != "cancelled" or best is None:
            raise
    assert best is not None
    return replace(best, warnings=tuple(search.warnings))


def _extent(marker: Marker) -> tuple[int, float]:
    return marker.sheets, marker.length


class _Search:
    def __init__(self, pieces: Sequence[PatternPiece], cloth: Cloth, times: int, units: UnitSystem) -> None:
        self.warnings: list[str] = []
        self._pieces, self._times, self._units = pieces, times, units
        self._cloth, self._room = cloth, room_at_edges(cloth.gap, cloth.grain)
        self._cut = {piece.number: np.concatenate([line.points for line in piece.of_role("cut")]) for piece in pieces}
        self._made_of = tuple(map(size_of, pieces))
        self._items: list[Item] = []
        self._width = cloth.width + 2 * self._room

    def markers(self, seconds: float) -> Generator[Marker | None, None, None]:
        """Yield markers, and None after a short time without a new marker. Raises FlattenError for a piece that is
        larger than the fabric."""
        self._items = yield from items_of(self._pieces, self._cloth.gap, self._times)
        asks_spyrrow = self._cloth.length is None and seconds > 0 and is_installed()
        for places in self._slides():
            yield self._marker(places, "slides") if places else None
            if places and asks_spyrrow:
                asks_spyrrow = False
                try:
                    with closing(searched(self._items, self._cloth.grain, self._width, seconds)) as found:
                        for better in found:
                            yield self._marker(better, "spyrrow") if better else None
                    return
                except SpyrrowError as error:
                    self.warnings.append(f"spyrrow failed, so pieces were packed without it: {error}.")

    def _slides(self) -> Iterator[list[Place] | None]:
        length = math.inf if self._cloth.length is None else self._cloth.length + 2 * self._room
        try:
            yield from SlidePacking(self._items, self._cloth.grain, self._width, length).trials()
        except TooLargeError as error:
            number = self._items[error.item].piece
            (piece,) = (piece for piece in self._pieces if piece.number == number)
            raise problem(_too_large(piece, self._cloth, self._units)) from error

    def _marker(self, places: Sequence[Place], by: str) -> Marker:
        placements, length = [], 0.0
        sheets = 1 + max(place.sheet for place in places)
        for place in places:
            item, (x, y) = self._items[place.item], (place.at - self._room).tolist()
            placements.append(Placement(item.piece, x, y, place.angle, item.mirrored, place.sheet))
            if place.sheet == sheets - 1:
                motion = Motion(np.array([x, y]), place.angle, item.mirrored)
                length = max(length, float(motion.points(self._cut[item.piece])[:, 1].max()))
        cloth = self._cloth
        taken = length if cloth.length is None else sheets * cloth.length
        area = sum(self._items[place.item].area for place in places)
        efficiency = area / (cloth.width * taken)
        return Marker(cloth.width, length, cloth.length, cloth.gap, tuple(placements), efficiency, by, self._made_of)


def _too_large(piece: PatternPiece, cloth: Cloth, units: UnitSystem) -> str:
    size = " x ".join(units.measured(float(side)) for side in piece.size)
    if cloth.length is None:
        where = f"a roll of {units.text(cloth.width)}"
    else:
        where = f"sheets of {units.text(cloth.width)} x {units.text(cloth.length)}"
    turned = "however it is turned" if cloth.grain == "free" else "with its grain lengthwise"
    return f'"{piece.name}" is {size}: too large for {where}, {turned}.'
