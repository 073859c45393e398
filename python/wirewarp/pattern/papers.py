# SPDX-License-Identifier: GPL-3.0-or-later
"""Papers to print on, and how a pattern is divided into their sheets."""

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import pyclipper

from .allowance import GRID
from .arrange import in_rows
from .checks import checked_length, problem
from .units import INCH

if TYPE_CHECKING:
    from .pattern import Pattern

SHEETS = {
    "a4": (210.0, 297.0),
    "letter": (8.5 * INCH, 11 * INCH),
    "a4-letter": (210.0, 11 * INCH),  # what fits on both
    "a3": (297.0, 420.0),
    "tabloid": (11 * INCH, 17 * INCH),
    "a0": (841.0, 1189.0),
}
ROLLS = {"36in": 36 * INCH, "24in": 24 * INCH}
PROJECTOR = "projector"
LONGEST = 5000.0  # millimeters: readers take pages up to 5.08 m
MARGIN = 10.0  # few printers reach nearer to the edge of a sheet
OVERLAP = 10.0  # of neighboring sheets, to glue or tape
INSET = 5.0  # round the pattern, so that no cut line falls onto the edge of what is printed
MOST_SHEETS = 2000


@dataclass(frozen=True)
class Page:
    """Of a file to print, and what it shows of the pattern. Lengths are in millimeters."""

    name: str  # "A1" of sheets to tape together, else its number
    low: np.ndarray  # (2,) lower left corner
    size: np.ndarray  # (2,) width and height: of sheets without their margins


@dataclass(frozen=True)
class Tile:
    row: int  # from the top
    column: int
    low: np.ndarray  # (2,) lower left corner of what it shows

    @property
    def name(self) -> str:
        return tile_name(self.row, self.column)


@dataclass(frozen=True)
class Tiles:
    """A pattern on sheets."""

    pattern: "Pattern"
    paper: np.ndarray  # (2,) width and height of a sheet
    shown: np.ndarray  # (2,) of each sheet, inside its margins
    overlap: float  # of neighboring sheets; 0 where every piece lies on one sheet
    rows: int
    columns: int
    low: np.ndarray  # (2,) lower left corner of all sheets
    tiles: list[Tile]  # those with something on them


def tile_name(row: int, column: int) -> str:
    """ "A1" is the first sheet of the top row; after row Z comes row AA."""
    letters = ""
    row += 1
    while row:
        row, letter = divmod(row - 1, 26)
        letters = chr(ord("A") + letter) + letters
    return f"{letters}{column + 1}"


def roll_width(paper: str | float) -> float | None:
    """Millimeters; None if the paper is no roll. Raises FlattenError for what is no paper at all."""
    if isinstance(paper, str):
        if paper in ROLLS:
            return ROLLS[paper]
        if paper in SHEETS or paper == PROJECTOR:
            return None
        known = ", ".join([*SHEETS, *ROLLS, PROJECTOR])
        raise problem(f"paper is {paper!r}: give one of {known}, or the width of a roll in millimeters.")
    return checked_length("paper, the width of a roll,", paper, 100.0, LONGEST)


def at_origin(pattern: "Pattern") -> "Pattern":
    """As it lies, but with the lower left corner at 0, 0."""
    low, _ = pattern.bounds
    return replace(pattern, pieces=[piece.moved(-low) for piece in pattern.pieces])


def divided(pattern: "Pattern", paper: str, keep_places: bool) -> Tiles:
    """On the fewest sheets, upright or on their side; if it takes no more, with every piece on one sheet.

    A marker stays as it is, and so does what keeps its places. Raises FlattenError if the sheets are too many.
    """
    if pattern.marker or keep_places:
        moved = at_origin(pattern)
        plans = [_with_tiles(moved, np.array(upright)) for upright in (SHEETS[paper], SHEETS[paper][::-1])]
        return min(plans, key=lambda plan: len(plan.tiles))
    taped = _taped(pattern, paper)
    whole = [plan for upright in (SHEETS[paper], SHEETS[paper][::-1]) if (plan := _whole(pattern, np.array(upright)))]
    fewest = min(whole, key=lambda plan: len(plan.tiles), default=None)
    return fewest if fewest and len(fewest.tiles) <= len(taped.tiles) else taped


def _whole(pattern: "Pattern", sheet: np.ndarray) -> Tiles | None:
    """Rows of pieces, each row on one sheet; None where a piece is larger than that."""
    shown = sheet - 2 * MARGIN
    room = shown - 2 * INSET
    sizes = np.array([piece.size for piece in pattern.pieces])
    if np.any(sizes > room):
        return None
    corners = in_rows(sizes, float(room[0]))
    sheets, start = -1, -math.inf
    for row in np.unique(corners[:, 1]):
        in_row = corners[:, 1] == row
        if row + sizes[in_row, 1].max() > start + room[1]:
            sheets, start = sheets + 1, float(row)
        corners[in_row, 1] += sheets * shown[1] - start
    moved = [piece.moved(to - piece.bounds[0]) for piece, to in zip(pattern.pieces, corners, strict=True)]
    low, count = np.array([-INSET, -INSET]), sheets + 1
    tiles = [Tile(row, 0, low + (0, (count - 1 - row) * shown[1])) for row in range(count)]
    return Tiles(replace(pattern, pieces=moved), sheet, shown, 0.0, count, 1, low, tiles)


def _taped(pattern: "Pattern", paper: str) -> Tiles:
    """In rows as wide as takes the fewest sheets. Raises FlattenError if these are too many."""
    sizes = np.array([piece.size for piece in pattern.pieces])
    best: tuple[int, float, np.ndarray] | None = None
    for upright in (SHEETS[paper], SHEETS[paper][::-1]):
        sheet = np.array(upright)
        step = sheet - 2 * MARGIN - OVERLAP
        first = max(1, math.ceil((sizes[:, 0].max() + 2 * INSET - OVERLAP) / step[0]))
        about_square = math.ceil(math.sqrt(float(np.prod(pattern.size))) / step[0])
        for columns in range(first, max(first, 2 * about_square) + 1):
            width = columns * step[0] + OVERLAP - 2 * INSET
            taken = (in_rows(sizes, width) + sizes).max(axis=0)
            count = int(np.prod(_counts(taken, step)))
            if best is None or count < best[0]:
                best = (count, width, sheet)
            if count > MOST_SHEETS:  # so many columns that it takes long to go through them
                break
    assert best is not None
    count, width, sheet = best
    _check_count(count, pattern)
    return _with_tiles(pattern.arranged(width), sheet)


def _counts(size: np.ndarray, step: np.ndarray) -> np.ndarray:
    """(2,) columns and rows of sheets for what is so large, each sheet a step from the one before."""
    counts: np.ndarray = np.maximum(np.ceil((size + 2 * INSET - OVERLAP) / step - 1e-9), 1).astype(int)
    return counts


def _check_count(count: int, pattern: "Pattern") -> None:
    """Raises FlattenError if these are too many sheets."""
    if count > MOST_SHEETS:
        size = " x ".join(pattern.units.text(float(side)) for side in pattern.size)
        raise problem(f"The pattern is {size}: more than {MOST_SHEETS} sheets; see millimeters_per_unit.")


def _with_tiles(pattern: "Pattern", sheet: np.ndarray) -> Tiles:
    shown = sheet - 2 * MARGIN
    step, top = shown - OVERLAP, pattern.size[1] + INSET
    columns, rows = _counts(pattern.size, step).tolist()
    _check_count(columns * rows, pattern)
    shapes = [([line.points for line in piece.of_role("cut")], piece.bounds) for piece in pattern.pieces]
    tiles = []
    for row in range(rows):
        for column in range(columns):
            low = np.array([column * step[0] - INSET, top - row * step[1] - shown[1]])
            if any(_shows(low, low + shown, cut, bounds) for cut, bounds in shapes):
                tiles.append(Tile(row, column, low))
    lowest = np.array([-INSET, top - (rows - 1) * step[1] - shown[1]])
    return Tiles(pattern, sheet, shown, OVERLAP, rows, columns, lowest, tiles)


def _shows(low: np.ndarray, high: np.ndarray, cut: list[np.ndarray], bounds: tuple[np.ndarray, np.ndarray]) -> bool:
    """Whether a sheet from low to high shows a part of a piece."""
    if np.any(bounds[0] >= high) or np.any(bounds[1] <= low):
        return False
    clipper = pyclipper.Pyclipper()
    box = np.array([low, [high[0], low[1]], high, [low[0], high[1]]])
    clipper.AddPath(np.rint((box - low) / GRID).astype(np.int64).tolist(), pyclipper.PT_CLIP, True)
    clipper.AddPaths(
        [np.rint((line - low) / GRID).astype(np.int64).tolist() for line in cut], pyclipper.PT_SUBJECT, True
    )
    return bool(clipper.Execute(pyclipper.CT_INTERSECTION, pyclipper.PFT_NONZERO, pyclipper.PFT_NONZERO))
