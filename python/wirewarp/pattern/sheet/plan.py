# SPDX-License-Identifier: GPL-3.0-or-later
"""Plans the pages of a PDF for each kind of paper. Each page has a part of the pattern and marks."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Generic, TypeVar

import numpy as np

from ..checks import problem
from ..label.card import Sheets
from ..marker import SHEETS_APART, Marker
from ..model import PatternPiece, Text
from ..pattern_data import OVERLAP, PatternData
from ..units import UnitSystem
from .furniture import GRID_LAYER, SHEET_LAYER, SIZE, Marks, grid_marks, map_marks, part_marks, scale_marks, sheet_marks
from .papers import LONGEST, MARGIN, PROJECTOR, SHEETS, Page, roll_width
from .tiles import Tile, Tiles, divided

PROJECTED = 0.5  # millimeters; a projector shows thinner lines as dots
BORDER = 5.0  # millimeters around the box of a piece, for letters and lines that extend beyond the box
AT_MARGIN = np.array([MARGIN, MARGIN])
P = TypeVar("P", bound=PatternData)


@dataclass(frozen=True)
class Sheet(Page):
    paper: np.ndarray  # (2,) width and height in millimeters, including margins
    corner: np.ndarray  # (2,) place of `low` on the paper
    pieces: Sequence[int]  # indices of the pieces on the sheet
    marks: Callable[[PatternData], list[Marks]]  # returns the marks for the drawn pattern
    is_clipped: bool = False  # whether the drawing is clipped to the shown part


@dataclass(frozen=True)
class Plan(Generic[P]):
    pattern: P  # pieces in their places on the sheets
    sheets: list[Sheet]
    layers: tuple[str, ...] = ()  # layers of the file besides the layers of the pieces
    hidden: tuple[str, ...] = ()  # layers that are off until the reader turns them on
    thinnest: float = 0.0  # millimeters: least width of all lines
    cover: Sheet | None = None  # the first page, with a map of the sheets
    text_sheets: Sheets | None = None  # sheets to tape together; each text should be on one sheet

    @property
    def all_sheets(self) -> list[Sheet]:
        return [self.cover, *self.sheets] if self.cover else self.sheets


def plan(pattern: P, paper: str | float | None, keep_places: bool) -> Plan[P]:
    """Return the plan. paper and keep_places: as for write_pdf(). Raises FlattenError if the paper is too small."""
    if paper is None:
        paper = page_width(pattern.marker, None, pattern.units) if pattern.marker else "a4"
    width = roll_width(paper)
    if width is not None:
        return _marker(pattern, pattern.marker, width) if pattern.marker else _roll(pattern, width, keep_places)
    return _one_page(pattern) if paper == PROJECTOR else _tiles(pattern, str(paper), keep_places)


def _one_page(pattern: P) -> Plan[P]:
    """Return the plan of one page of the necessary size, with a hidden layer for the grid."""
    size: np.ndarray = np.maximum(pattern.size, (SIZE[0], 0)) + 2 * MARGIN + (0, SIZE[1])
    if size.max() > LONGEST:
        width, height, most = (pattern.units.text(float(side)) for side in (*size, LONGEST))
        raise problem(
            f"The pattern needs a page of {width} x {height}, and PDF viewers support at most {most}: choose a roll or "
            "sheets."
        )

    def marks(drawn: PatternData) -> list[Marks]:
        return [grid_marks(drawn, size), scale_marks(drawn, AT_MARGIN)]

    low = pattern.bounds[0] - MARGIN - (0, SIZE[1])
    sheet = Sheet("1", low, size, size, np.zeros(2), range(len(pattern.pieces)), marks)
    return Plan(pattern, [sheet], (GRID_LAYER,), (GRID_LAYER,), PROJECTED)


def _roll(pattern: P, width: float, keep_places: bool) -> Plan[P]:
    """Return the plan of pages as wide as the roll. Each piece is whole on one page."""
    arranged = _on_roll(pattern, width, keep_places)
    sheets = []
    for number, pieces in enumerate(_pages_of_rows(arranged.pieces)):
        bounds = np.array([arranged.pieces[index].bounds for index in pieces])
        low, high = bounds[:, 0, 1].min(), bounds[:, 1, 1].max()
        block = SIZE[1] if number == 0 else 0.0  # height of the squares to measure
        size = np.array([width, high - low + 2 * MARGIN + block])
        marks = partial(_scale_on_first, number)
        corner = np.array([-MARGIN, low - MARGIN - block])
        sheets.append(Sheet(str(number + 1), corner, size, size, np.zeros(2), pieces, marks))
    return Plan(arranged, sheets)


def _scale_on_first(number: int, pattern: PatternData) -> list[Marks]:
    return [scale_marks(pattern, AT_MARGIN)] if number == 0 else []


def _on_roll(pattern: P, width: float, keep_places: bool) -> P:
    """Return the pattern with its pieces in rows across the roll, or in their places. Raises FlattenError if the roll
    is too narrow or a piece is too large."""
    inner, units = width - 2 * MARGIN, pattern.units
    for piece in pattern.pieces:
        if piece.size[0] > inner or piece.size[1] > LONGEST - 2 * MARGIN - SIZE[1]:
            size = " x ".join(units.measured(float(side)) for side in piece.size)
            raise problem(
                f'"{piece.name}" is {size}: too large for a roll of {units.text(width)}. Its printed width is '
                f"{units.text(inner)}, and pages are at most {units.text(LONGEST)} long. Choose a wider roll or sheets."
            )
    if inner < SIZE[0]:
        raise problem(
            f"A roll of {units.text(width)} is too narrow for the test square: choose a wider roll or sheets."
        )
    if keep_places and pattern.size[0] > inner:
        raise problem(
            f"The pieces as laid out are {units.text(float(pattern.size[0]))} wide, but only {units.text(inner)} of a "
            f"roll of {units.text(width)} can be printed. Choose In Rows, or move the pieces."
        )
    return pattern.at_origin() if keep_places else pattern.arranged(inner)


def _pages_of_rows(pieces: Sequence[PatternPiece]) -> list[list[int]]:
    """Return the indices of the pieces on each page. No page is longer than PDF viewers support."""
    pages: list[list[int]] = []
    low = 0.0
    room = LONGEST - 2 * MARGIN - SIZE[1]
    for index, piece in sorted(enumerate(pieces), key=lambda each: float(each[1].bounds[0][1])):
        bottom, top = float(piece.bounds[0][1]), float(piece.bounds[1][1])
        if not pages or top - low > room:
            pages.append([])
            low = bottom
        pages[-1].append(index)
    return pages


def page_width(marker: Marker, roll: float | None, units: UnitSystem) -> float:
    """Return the width of the pages for a marker, in millimeters. roll: width of the paper, or None for the necessary
    width. Raises FlattenError if the roll is too narrow, or the marker is too wide for a PDF page."""
    needed = max(marker.width, float(SIZE[0])) + 2 * MARGIN
    if roll is not None and roll < needed - 1e-6:
        raise problem(
            f"The marker is {units.text(marker.width)} wide and needs a roll of {units.text(needed)}, "
            f"not {units.text(roll)}: choose a wider roll, or sheets."
        )
    if needed > LONGEST:
        raise problem(
            f"The marker is {units.text(marker.width)} wide, wider than a PDF page can be: choose sheets of paper."
        )
    return needed if roll is None else roll


def _marker(pattern: P, marker: Marker, width: float) -> Plan[P]:
    """Return the plan of a marker with the edges of the fabric, on pages as wide as the roll of paper. If the fabric
    needs several pages, they overlap."""
    page_width(marker, width, pattern.units)
    length = marker.length if marker.sheet_length is None else marker.sheet_length
    most = LONGEST - 2 * MARGIN - SIZE[1]
    count = max(1, int(np.ceil((length - OVERLAP) / (most - OVERLAP) - 1e-9)))
    sheets: list[Sheet] = []
    for cloth in range(marker.sheets):
        for number in range(count):
            begin = number * (most - OVERLAP)
            low = np.array([0.0, cloth * (length + SHEETS_APART) + begin])
            size = np.array([marker.width, min(length - begin, most)])
            corner = AT_MARGIN if sheets else AT_MARGIN + (0, SIZE[1])
            paper = np.array([width, size[1] + MARGIN + corner[1]])
            place = len(sheets) + 1
            marks = partial(_marker_marks, marker, corner, size, place, number == 0, number == count - 1)
            pieces = _met(pattern.pieces, low, low + size)
            sheets.append(Sheet(str(place), low, size, paper, corner, pieces, marks, is_clipped=True))
    return Plan(pattern, sheets, (SHEET_LAYER,))


def _marker_marks(
    marker: Marker, corner: np.ndarray, size: np.ndarray, page: int, is_first: bool, is_last: bool, pattern: PatternData
) -> list[Marks]:
    edges = part_marks(corner, size, page, is_first, is_last)
    if page > 1:
        return [edges]
    sentence = Text((marker.sentence(pattern.units),), AT_MARGIN + (85.0, 122.0), 4.0)
    return [scale_marks(pattern, AT_MARGIN), Marks("Scale", [], [sentence]), edges]


def _tiles(pattern: P, paper: str, keep_places: bool) -> Plan[P]:
    """Return the plan of a first page with a map and squares to measure, and of the sheets."""
    tiles = divided(pattern, paper, keep_places)
    upright = np.array(SHEETS[paper])
    cover = Sheet("", np.zeros(2), upright, upright, np.zeros(2), (), lambda _: map_marks(tiles, upright))
    sheets = []
    for tile in tiles.tiles:
        met = _met(tiles.pattern.pieces, tile.low, tile.low + tiles.shown)
        marks = partial(_tile_marks, tiles, tile, met)
        sheets.append(Sheet(tile.name, tile.low, tiles.shown, tiles.paper, AT_MARGIN, met, marks, is_clipped=True))
    texts = Sheets(tiles.boxes, tiles.borders) if tiles.overlap and not pattern.marker else None
    return Plan(tiles.pattern, sheets, (SHEET_LAYER,), cover=cover, text_sheets=texts)


def _tile_marks(tiles: Tiles[P], tile: Tile, met: Sequence[int], pattern: PatternData) -> list[Marks]:
    return [sheet_marks(tiles, tile, [pattern.pieces[index] for index in met])]


def _met(pieces: Sequence[PatternPiece], low: np.ndarray, high: np.ndarray) -> list[int]:
    """Return the indices of the pieces whose box with its border overlaps the box from low (2,) to high (2,)."""
    boxes = (piece.bounds for piece in pieces)
    return [n for n, box in enumerate(boxes) if np.all(box[0] - BORDER < high) and np.all(box[1] + BORDER > low)]
