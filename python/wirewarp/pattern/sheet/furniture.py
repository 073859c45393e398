# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws squares and bars to measure, marks for joining sheets, and a map of the sheets."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from ...report.words import counted
from ..label import helvetica
from ..label.room import Segments, joined, touches
from ..label.room import strokes as text_strokes
from ..label.text_place import text_width
from ..model import PatternPiece, Text
from ..pattern_data import OVERLAP, PatternData
from ..units import INCH, UnitSystem
from .drawing import LOOKS, Stroke, strokes_of
from .papers import MARGIN, sheet_name
from .tiles import Tile, Tiles

SIZE = np.array([168.0, 158.0])  # size of the block of squares and bars in millimeters; fits on A4 and Letter
CORNER = 4.0  # millimeters between the lower left corner of the block and its bars
# Heights of the name of a sheet, and of the names of its neighbors, which fit in the overlap. Both are in millimeters.
NAME_TEXT, NEIGHBOR_TEXT = 5.0, 4.0
NAME_PLACES = np.linspace(0, 1, 9)  # places to try for the name of a sheet, as shares of its width and height
# The name of a neighbor is tried at steps of NEIGHBOR_STEP along the edge, and at these depths inwards from the middle
# of the overlap. Both are in millimeters. A step is longer than half of a diamond and half of a name together.
NEIGHBOR_STEP, DEPTHS = 12.0, (0.0, OVERLAP, 2 * OVERLAP)
# Millimeters from the lower left corner of the block to the upper left corner of the key. The key is above the squares,
# beside the upright bar. A column is wide enough for a sample, a gap of 2 mm and the longest label, 22.4 mm. So the
# four columns of all kinds of lines are inside the block.
KEY = (18.0, 150.0)
KEY_ROWS, KEY_WIDTH, KEY_HEIGHT, KEY_SAMPLE, KEY_TEXT = 3, 38.0, 7.0, 12.0, 3.0
TICK = 3.0  # millimeters: half of the length of a tick; less than CORNER, so that ticks stay in the block
UNIT = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
SHEET_LAYER, GRID_LAYER = "Sheets", "Grid"
GRID_STEP = {"metric": 50.0, "imperial": 2 * INCH}  # millimeters; multiples of the 10 mm or 1 in of cutting mats


class Marks(NamedTuple):
    """Strokes and texts of one layer, in millimeters from the lower left corner of the page."""

    layer: str
    strokes: list[Stroke]
    texts: list[Text]


def scale_marks(pattern: PatternData, corner: np.ndarray) -> Marks:
    """Return a block with squares and bars to measure, the allowance, and a key of the lines. corner (2,): its lower
    left corner."""
    strokes, texts = _scale_block(corner, pattern.units)
    key = _key_of_lines(pattern, corner + KEY)
    included = f"Allowance included: {pattern.allowance_text}"
    texts += [Text((included,), corner + (62.0, 116.0), 4.0), *key.texts]
    return Marks("Scale", [*strokes, *key.strokes], texts)


def _key_of_lines(pattern: PatternData, corner: np.ndarray) -> Marks:
    """Return a sample of each kind of line in the pattern. corner (2,): upper left corner of the key."""
    roles = {stroke.role for piece in pattern.pieces for stroke in strokes_of(piece)}
    shown = [role for role, look in LOOKS.items() if look.label and role in roles]
    strokes, texts = [], []
    for number, role in enumerate(shown):
        column, row = divmod(number, KEY_ROWS)
        at = corner + (KEY_WIDTH * column, -KEY_HEIGHT * row)
        label = LOOKS[role].label
        strokes.append(Stroke(role, at + [[0.0, 0.0], [KEY_SAMPLE, 0.0]]))
        half = helvetica.width(label.encode("ascii"), KEY_TEXT) / 2
        texts.append(Text((label,), at + (KEY_SAMPLE + 2.0 + half, 0.0), KEY_TEXT))
    return Marks("Scale", strokes, texts)


def _scale_block(corner: np.ndarray, units: UnitSystem) -> tuple[list[Stroke], list[Text]]:
    origin = corner + CORNER
    if units.name == "metric":
        bar, first, second = (150.0, "150 mm"), (100.0, "100 mm"), (2 * INCH, "2 in")
    else:
        bar, first, second = (6 * INCH, "6 in"), (4 * INCH, "4 in"), (50.0, "50 mm")
    strokes = [*_bar(origin, bar[0], np.array([1.0, 0.0])), *_bar(origin, bar[0], np.array([0.0, 1.0]))]
    texts = [Text((bar[1],), origin + (bar[0] - 10, 5.0), 4.0), Text((bar[1],), origin + (5.0, bar[0] - 10), 4.0, 90.0)]
    at = origin + 8.0
    for (side, label), lines in ((first, ("Measure before cutting",)), (second, ())):
        strokes.append(Stroke("scale", at + side * UNIT, True))
        texts.append(Text((label, *lines), at + side / 2, 5.0))
        at = at + (side + 4.0, 0.0)
    return strokes, texts


def _bar(origin: np.ndarray, length: float, along: np.ndarray) -> Iterator[Stroke]:
    """Yield the strokes of a bar of this length, with a tick at both ends. along (2,): unit vector of its direction."""
    aside = np.array([-along[1], along[0]]) * TICK
    yield Stroke("scale", np.array([origin, origin + length * along]))
    for end in (origin, origin + length * along):
        yield Stroke("scale", np.array([end - aside, end + aside]))


def grid_marks(pattern: PatternData, size: np.ndarray) -> Marks:
    """Return the grid over the whole page of this size (2,), for adjusting a projector."""
    step, (width, height) = GRID_STEP[pattern.units.name], size
    lines = [[[x, 0.0], [x, height]] for x in np.arange(step, width, step)]
    lines += [[[0.0, y], [width, y]] for y in np.arange(step, height, step)]
    return Marks(GRID_LAYER, [Stroke("scale", np.array(line)) for line in lines], [])


def sheet_marks(plan: Tiles, tile: Tile, pieces: Sequence[PatternPiece]) -> Marks:
    """Return the frame of a sheet, its name, diamonds at the overlaps, and the names of its neighbors.

    Names avoid lines and texts if there is room. pieces: pieces on the sheet, in their places.
    """
    row, column = tile.row, tile.column
    low, high = np.array([MARGIN, MARGIN]), MARGIN + plan.shown
    middle = (low + high) / 2
    printed = {(other.row, other.column) for other in plan.tiles}
    sides = (
        (np.array([-1, 0]), (row, column - 1), np.array([low[0] + OVERLAP / 2, middle[1]])),
        (np.array([1, 0]), (row, column + 1), np.array([high[0] - OVERLAP / 2, middle[1]])),
        (np.array([0, 1]), (row - 1, column), np.array([middle[0], high[1] - OVERLAP / 2])),
        (np.array([0, -1]), (row + 1, column), np.array([middle[0], low[1] + OVERLAP / 2])),
    )
    diamonds, names = [], [_own_names(plan, tile)]
    for outward, other, at in sides:
        if plan.overlap and other in printed:
            # Both sheets show the whole overlap with a diamond in its middle, and these diamonds coincide.
            diamonds.append(Stroke("sheet", at + OVERLAP / 2 * np.array([[1, 0], [0, 1], [-1, 0], [0, -1]]), True))
            names.append(_neighbor_names(sheet_name(*other), at, outward, plan.shown))
    drawn = _segments(pieces, diamonds, MARGIN - tile.low)
    texts: list[Text] = []
    for choices in names:
        texts.append(next((text for text in choices if not touches(text, drawn)), choices[0]))
        drawn = joined([drawn, text_strokes(texts[-1])])
    return Marks(SHEET_LAYER, [Stroke("sheet", low + plan.shown * UNIT, True), *diamonds], texts)


def _neighbor_names(name: str, at: np.ndarray, outward: np.ndarray, shown: np.ndarray) -> list[Text]:
    """Return the name of a neighbor at each place to try, the nearest to the diamond first.

    - at (2,): center of the diamond
    - outward (2,): unit vector toward the neighbor
    - shown (2,): size of the printed area
    """
    along, angle = np.abs(outward[::-1]), 90.0 if outward[0] else 0.0
    steps = np.arange(NEIGHBOR_STEP, shown @ along / 2 - NEIGHBOR_STEP, NEIGHBOR_STEP)
    places = [at + sign * step * along - depth * outward for depth in DEPTHS for step in steps for sign in (1, -1)]
    return [Text((name,), place, NEIGHBOR_TEXT, angle) for place in places]


def _own_names(plan: Tiles, tile: Tile) -> list[Text]:
    """Return a text such as "C3 of 11" at each place to try: first the corners of the sheet, then places near them."""
    words = f"{tile.name} of {len(plan.tiles)}"
    inset = np.array([text_width(words, NAME_TEXT) / 2 + 2.0, 7.0])
    shares = [np.array([x, y]) for y in NAME_PLACES for x in NAME_PLACES]
    shares.sort(key=lambda share: float(np.minimum(share, 1 - share).sum()))
    return [Text((words,), MARGIN + inset + share * (plan.shown - 2 * inset), NAME_TEXT) for share in shares]


def _segments(pieces: Sequence[PatternPiece], marks: Sequence[Stroke], offset: np.ndarray) -> Segments:
    """Return the segments of the marks, and of the lines and texts of the pieces. offset (2,): moves the pieces."""
    texts = [text_strokes(text) for piece in pieces for text in piece.texts]
    first, second = joined([*(stroke.segments for piece in pieces for stroke in strokes_of(piece)), *texts])
    return joined([(first + offset, second + offset), *(mark.segments for mark in marks)])


def part_marks(corner: np.ndarray, size: np.ndarray, page: int, is_first: bool, is_last: bool) -> Marks:
    """Return the edges of a marker's part on one page, and the numbers of the adjoining pages.

    corner, size (2,): lower left corner and size of the part, in millimeters; page: number of its page.
    """
    texts = [
        Text((f"{what} page {other}",), corner + (size[0] / 2, y), 4.0)
        for is_joined, what, other, y in (
            (not is_first, "Lay on", page - 1, OVERLAP / 2),
            (not is_last, "Continues on", page + 1, size[1] - OVERLAP / 2),
        )
        if is_joined
    ]
    return Marks(SHEET_LAYER, [Stroke("sheet", corner + size * UNIT, True)], texts)


def map_marks(plan: Tiles, paper: np.ndarray) -> list[Marks]:
    """Return the marks of the first page: title and advice, a map of the sheets and pieces, and squares to measure.

    paper (2,): size of the page in millimeters.
    """
    pattern = plan.pattern
    top = paper[1] - MARGIN
    room = np.array([paper[0] - 2 * MARGIN, top - 31 - MARGIN - SIZE[1]])
    whole = np.array([plan.columns, plan.rows]) * (plan.shown - plan.overlap) + plan.overlap
    scale = float((room / whole).min())
    corner = np.array([(paper[0] - scale * whole[0]) / 2, MARGIN + SIZE[1] + 2]) - scale * plan.low

    def placed(points: np.ndarray) -> np.ndarray:
        return corner + scale * points

    def named(tile: Tile) -> Text:
        height = min(3.0, 0.12 * scale * float(plan.shown.min()))
        return Text((tile.name,), placed(tile.low + plan.shown * (0.15, 0.1)), height)

    outlines = [Stroke("scale", placed(line.points), True) for piece in pattern.pieces for line in piece.of_role("cut")]
    numbers = [Text((str(piece.number),), placed(piece.bounds[0] + piece.size / 2), 3.0) for piece in pattern.pieces]
    frames = [Stroke("sheet", placed(tile.low + plan.shown * UNIT), True) for tile in plan.tiles]
    lines = [
        Text((line,), np.array([paper[0] / 2, top - 4 - 5.0 * n]), 4.5 if n == 0 else 3.4)
        for n, line in enumerate(_advice(plan))
    ]
    return [
        scale_marks(pattern, np.array([MARGIN, MARGIN])),
        Marks("Text", [], lines),
        Marks("Scale", outlines, numbers),
        Marks(SHEET_LAYER, frames, [named(tile) for tile in plan.tiles]),
    ]


def _advice(plan: Tiles) -> list[str]:
    pattern, count = plan.pattern, counted(len(plan.tiles), "sheet")
    skipped = plan.rows * plan.columns - len(plan.tiles)
    sheets = f"{count} in {counted(plan.rows, 'row')} of {plan.columns}"
    sheets += f", without {counted(skipped, 'empty sheet')}" if skipped else ""
    return [
        pattern.title or "Pattern",
        "Print at 100% (actual size). Turn off Fit to Page. Measure the squares before you cut.",
        f"{sheets}." if plan.overlap else f"{count}.",
        f"Neighboring sheets overlap by {pattern.units.text(OVERLAP)}: lay each diamond on the matching diamond."
        if plan.overlap
        else "No piece crosses two sheets.",
        f"{counted(len(pattern.pieces), 'piece')}. Allowance included: {pattern.allowance_text}.",
    ]
