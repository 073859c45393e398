# SPDX-License-Identifier: GPL-3.0-or-later
"""Divides a pattern over sheets: every piece on one sheet, or over the edges of sheets that are taped together."""

import math
from dataclasses import dataclass
from typing import Generic, TypeVar

import numpy as np
import pyclipper

from ..checks import problem
from ..geometry import GRID
from ..pattern_data import OVERLAP, PatternData, in_rows
from .papers import MARGIN, SHEETS, sheet_name

INSET = 5.0  # round the pattern, so that no cut line falls onto the edge of what is printed
MOST_SHEETS = 2000
P = TypeVar("P", bound=PatternData)


@dataclass(frozen=True)
class Tile:
    row: int  # from the top
    column: int
    low: np.ndarray  # (2,) lower left corner of what it shows

    @property
    def name(self) -> str:
        return sheet_name(self.row, self.column)


@dataclass(frozen=True)
class Tiles(Generic[P]):
    """A pattern on sheets."""

    pattern: P
    paper: np.ndarray  # (2,) width and height of a sheet
    shown: np.ndarray  # (2,) of each sheet, inside its margins
    overlap: float  # of neighboring sheets; 0 where every piece lies on one sheet
    rows: int
    columns: int
    low: np.ndarray  # (2,) lower left corner of all sheets
    tiles: list[Tile]  # those with something on them


def divided(pattern: P, paper: str, keep_places: bool) -> Tiles[P]:
    """On the fewest sheets, upright or on their side; if it takes no more, with every piece on one sheet.

    A marker stays as it is, and so does what keeps its places. Raises FlattenError if the sheets are too many.
    """
    if pattern.marker or keep_places:
        moved = pattern.at_origin()
        plans = [_with_tiles(moved, np.array(upright)) for upright in (SHEETS[paper], SHEETS[paper][::-1])]
        return min(plans, key=lambda plan: len(plan.tiles))
    taped = _taped(pattern, paper)
    whole = [plan for upright in (SHEETS[paper], SHEETS[paper][::-1]) if (plan := _whole(pattern, np.array(upright)))]
    fewest = min(whole, key=lambda plan: len(plan.tiles), default=None)
    return fewest if fewest and len(fewest.tiles) <= len(taped.tiles) else taped


def _whole(pattern: P, sheet: np.ndarray) -> Tiles[P] | None:
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
    low, count = np.array([-INSET, -INSET]), sheets + 1
    tiles = [Tile(row, 0, low + (0, (count - 1 - row) * shown[1])) for row in range(count)]
    return Tiles(pattern.with_corners(corners), sheet, shown, 0.0, count, 1, low, tiles)


def _taped(pattern: P, paper: str) -> Tiles[P]:
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


def _check_count(count: int, pattern: PatternData) -> None:
    """Raises FlattenError if these are too many sheets."""
    if count > MOST_SHEETS:
        size = " x ".join(pattern.units.text(float(side)) for side in pattern.size)
        raise problem(f"The pattern is {size}: more than {MOST_SHEETS} sheets; see millimeters_per_unit.")


def _with_tiles(pattern: P, sheet: np.ndarray) -> Tiles[P]:
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
