# SPDX-License-Identifier: GPL-3.0-or-later
"""Divides a pattern into sheets. Each piece is on one sheet, or crosses the edges of sheets that are taped together."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Generic, NamedTuple, TypeVar

import numpy as np
import pyclipper

from ..checks import problem
from ..geometry import GRID, Motion
from ..label.leaders import Box
from ..model import PatternPiece
from ..pattern_data import OVERLAP, PatternData, in_rows
from .papers import MARGIN, SHEETS, sheet_name
from .sheet_packing import placed_on_sheets

INSET = 5.0  # millimeters around the pattern, so that no cutting line is on the edge of the printed area
MOST_SHEETS = 2000  # four packs of paper; a larger pattern probably has the wrong unit
MOST_PACKED = 60  # largest number of sheets for which packing is tried; with more sheets, it would take seconds
MOST_WIDTHS = 8  # number of column counts to try with packing; with more, it would take seconds
TURNS = (0.0, 90.0, 180.0, 270.0)  # degrees; all turns are possible on paper, but right angles look better
P = TypeVar("P", bound=PatternData)


@dataclass(frozen=True)
class Tile:
    row: int  # index of the row, from the top
    column: int
    low: np.ndarray  # (2,) lower left corner of the shown part, in the pattern

    @property
    def name(self) -> str:
        return sheet_name(self.row, self.column)


@dataclass(frozen=True)
class Tiles(Generic[P]):
    """A pattern on sheets. Lengths are in millimeters."""

    pattern: P
    paper: np.ndarray  # (2,) width and height of a sheet
    shown: np.ndarray  # (2,) width and height of the printed area of each sheet, inside its margins
    overlap: float  # overlap of neighboring sheets; 0 if each piece is on one sheet
    rows: int
    columns: int
    low: np.ndarray  # (2,) lower left corner of all sheets
    tiles: list[Tile]  # sheets to print; each shows a part that no other sheet shows

    @property
    def boxes(self) -> list[Box]:
        return [Box(tile.low, tile.low + self.shown) for tile in self.tiles]

    @property
    def borders(self) -> list[np.ndarray]:
        """Return the middle lines (2,2) of all overlaps of neighboring sheets. A line that crosses none of them is on
        one sheet."""
        if not self.overlap:
            return []
        found = []
        for low, high in self.boxes:
            middle = low + self.overlap / 2
            found += [np.array([middle, [middle[0], high[1]]])] if low[0] > self.low[0] + GRID else []
            found += [np.array([middle, [high[0], middle[1]]])] if low[1] > self.low[1] + GRID else []
        return found


class Shape(NamedTuple):
    """The cutting lines of a piece, for Clipper."""

    outlines: list[list[list[int]]]  # points on Clipper's grid
    bounds: tuple[np.ndarray, np.ndarray]  # lower left and upper right corner (2,) in millimeters


def divided(pattern: P, paper: str, keep_places: bool) -> Tiles[P]:
    """Return the pattern on the fewest sheets, which are all upright or all turned.

    keep_places: whether pieces keep their places, as they always do in a marker. Raises FlattenError for too many
    sheets.
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
    """Return the pieces in rows, each row on one sheet; None if a piece is larger than a sheet."""
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
    """Return the arrangement with the fewest sheets of all arrangements that are tried. Raises FlattenError for too
    many sheets."""
    sizes = np.array([piece.size for piece in pattern.pieces])
    in_row: tuple[int, float, np.ndarray] | None = None
    tried = []
    for upright in (SHEETS[paper], SHEETS[paper][::-1]):
        sheet = np.array(upright)
        step = sheet - 2 * MARGIN - OVERLAP
        first = max(1, math.ceil((sizes[:, 0].max() + 2 * INSET - OVERLAP) / step[0]))
        about_square = math.ceil(math.sqrt(float(np.prod(pattern.size))) / step[0])
        widths = range(first, max(first, 2 * about_square) + 1)
        tried.append((sheet, widths[:: 1 + len(widths) // MOST_WIDTHS]))
        for columns in widths:
            width = columns * step[0] + OVERLAP - 2 * INSET
            taken = (in_rows(sizes, width) + sizes).max(axis=0)
            count = int(np.prod(_counts(taken, step)))
            if in_row is None or count < in_row[0]:
                in_row = (count, width, sheet)
            if count > MOST_SHEETS:  # for such a large pattern, trying more columns would take too long
                break
    assert in_row is not None
    count, width, sheet = in_row
    _check_count(count, pattern)
    rows = _with_tiles(pattern.arranged(width), sheet)
    if len(rows.tiles) > MOST_PACKED:
        return rows
    variants = [[piece.placed(Motion(np.zeros(2), turn)) for turn in TURNS] for piece in pattern.pieces]
    outlines = [[_cut_lines(piece) for piece in turned] for turned in variants]
    best = rows
    for sheet, widths in tried:
        step = sheet - 2 * MARGIN - OVERLAP
        placed = placed_on_sheets(outlines, step, INSET, widths, len(best.tiles))
        if placed:
            pieces = [turned[turn] for turned, turn in zip(variants, placed.turns, strict=True)]
            packed = _with_tiles(replace(pattern, pieces=pieces).with_corners(placed.corners), sheet, placed.columns)
            best = min(best, packed, key=lambda plan: len(plan.tiles))
    return best


def _cut_lines(piece: PatternPiece) -> list[np.ndarray]:
    return [line.points - piece.bounds[0] for line in piece.of_role("cut")]


def _counts(size: np.ndarray, step: np.ndarray) -> np.ndarray:
    """Return the numbers of columns and rows (2,) of sheets for a pattern of this size (2,). step (2,): distance
    between neighboring sheets."""
    counts: np.ndarray = np.maximum(np.ceil((size + 2 * INSET - OVERLAP) / step - 1e-9), 1).astype(int)
    return counts


def _check_count(count: int, pattern: PatternData) -> None:
    if count > MOST_SHEETS:
        size = " x ".join(pattern.units.text(float(side)) for side in pattern.size)
        raise problem(f"The pattern is {size}: more than {MOST_SHEETS} sheets. Check millimeters_per_unit.")


def _with_tiles(pattern: P, sheet: np.ndarray, columns: int | None = None) -> Tiles[P]:
    """Return the pattern on sheets.

    - columns: number of columns, with the lower left corner of the sheets at 0, 0
    - columns=None: as many columns as needed, with the sheets beginning at the upper left of the pattern
    """
    shown = sheet - 2 * MARGIN
    step, top = shown - OVERLAP, pattern.size[1] + INSET
    if columns is None:
        columns, rows = _counts(pattern.size, step).tolist()
        lowest = np.array([-INSET, top - (rows - 1) * step[1] - shown[1]])
    else:
        rows = int(np.ceil((pattern.bounds[1][1] + INSET - OVERLAP) / step[1] - 1e-9))
        lowest = np.zeros(2)
    _check_count(columns * rows, pattern)
    shapes = [
        Shape([np.rint(line.points / GRID).astype(np.int64).tolist() for line in piece.of_role("cut")], piece.bounds)
        for piece in pattern.pieces
    ]
    tiles = []
    for row in range(rows):
        for column in range(columns):
            low = lowest + (column, rows - 1 - row) * step
            if any(_shows(low, low + shown, shape) for shape in shapes):
                tiles.append(Tile(row, column, low))
    return Tiles(pattern, sheet, shown, OVERLAP, rows, columns, lowest, _needed(tiles, shown, shapes))


def _needed(tiles: list[Tile], shown: np.ndarray, shapes: Sequence[Shape]) -> list[Tile]:
    """Return the sheets to print. A sheet is left out if other sheets show all its content, too."""
    kept = list(tiles)
    for tile in tiles:
        others = [other for other in kept if other != tile and np.all(np.abs(other.low - tile.low) < shown)]
        boxes = [_box(other.low, other.low + shown) for other in others]
        if not any(_shows(tile.low, tile.low + shown, shape, boxes) for shape in shapes):
            kept.remove(tile)
    return kept


def _box(low: np.ndarray, high: np.ndarray) -> list[list[int]]:
    corners = np.array([low, [high[0], low[1]], high, [low[0], high[1]]])
    return np.rint(corners / GRID).astype(np.int64).tolist()


def _shows(low: np.ndarray, high: np.ndarray, shape: Shape, others: Sequence[list[list[int]]] = ()) -> bool:
    """Return whether a sheet from low (2,) to high (2,) shows a part of a piece that no other sheet shows. others:
    boxes of the other sheets on Clipper's grid."""
    if np.any(shape.bounds[0] >= high) or np.any(shape.bounds[1] <= low):
        return False
    part = _clipped(shape.outlines, [_box(low, high)], pyclipper.CT_INTERSECTION)
    return bool(_clipped(part, others, pyclipper.CT_DIFFERENCE) if part and others else part)


def _clipped(paths: list[list[list[int]]], by: Sequence[list[list[int]]], how: int) -> list[list[list[int]]]:
    clipper = pyclipper.Pyclipper()
    clipper.AddPaths(paths, pyclipper.PT_SUBJECT, True)
    clipper.AddPaths(by, pyclipper.PT_CLIP, True)
    found: list[list[list[int]]] = clipper.Execute(how, pyclipper.PFT_NONZERO, pyclipper.PFT_NONZERO)
    return found
