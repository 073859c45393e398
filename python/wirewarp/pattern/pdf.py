# SPDX-License-Identifier: GPL-3.0-or-later
"""A pattern as PDF: sheets to tape together, a roll for a plotter, or one page for a projector."""

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .checks import problem
from .drawing import Stroke, strokes_of
from .marker import Marker
from .marker_pages import Part, page_width, parts_of
from .model import PatternPiece, Text
from .papers import (
    LONGEST,
    MARGIN,
    OVERLAP,
    PROJECTOR,
    SHEETS,
    Page,
    Tiles,
    at_origin,
    divided,
    roll_width,
    tile_name,
)
from .pdf_document import Content, Document
from .progress import Steps
from .proof import proof_pages
from .roles import LAYERS, LOOKS
from .scale_block import SIZE, UNIT, scale_block
from .units import counted

if TYPE_CHECKING:
    from .pattern import Pattern

PROJECTED = 0.5  # millimeters: thinner lines look dotted under a projector
BORDER = 5.0  # millimeters round a piece's box: notches and letters may reach over it
SHEET_LAYER, GRID_LAYER = "Sheets", "Grid"
GRID_STEP = {"metric": 50.0, "imperial": 2 * 25.4}
Numbered = tuple[int, PatternPiece]  # with its index in the pattern
Drawn = tuple[Document, list[str]]  # with sentences on what could not be drawn


def write_pdf(
    path: Path,
    pattern: "Pattern",
    paper: str | float | None = None,
    proof: bool = False,
    keep_places: bool = False,
) -> Steps[tuple[int, list[str]]]:
    """Writes the file; returns the number of pages, and sentences on what could not be drawn.

    paper: "a4", "letter", "a4-letter" (fits both), "a3", "tabloid", "a0", "36in", "24in", "projector", or the width of
    a roll in millimeters; None takes A4, and for a marker a roll that is as wide as it needs.
    proof: last come pages with every piece and both sides of every seam, to check beforehand.
    keep_places: on sheets and rolls, too, the pieces stay as they lie; else they come in rows.
    """
    paper = _paper(pattern, paper)
    width = roll_width(paper)
    if width is not None:
        document, left_out = yield from (
            _marker(pattern, pattern.marker, width) if pattern.marker else _roll(pattern, width, keep_places)
        )
    elif paper == PROJECTOR:
        document, left_out = yield from _one_page(pattern)
    else:
        document, left_out = yield from _tiles(pattern, str(paper), keep_places)
    for content in proof_pages(pattern, _proof_size(paper)) if proof else []:
        document.add_page(_proof_size(paper), content)
        left_out += content.left_out
    document.write(path)
    return document.page_count, list(dict.fromkeys(left_out))


def pages_of(
    pattern: "Pattern", paper: str | float | None = None, keep_places: bool = False
) -> tuple["Pattern", list[Page]]:
    """The pattern as it lies on the pages that write_pdf would write, and those of them that show it."""
    paper = _paper(pattern, paper)
    width = roll_width(paper)
    if width is not None and pattern.marker:
        page_width(pattern.marker, width, pattern.units)
        parts = parts_of(pattern.marker)
        return pattern, [Page(str(number), part.low, part.size) for number, part in enumerate(parts, start=1)]
    if width is not None:
        arranged = _on_roll(pattern, width, keep_places)
        return arranged, [page for _, page in _roll_pages(arranged, width)]
    if paper == PROJECTOR:
        return pattern, [Page("1", pattern.bounds[0] - MARGIN - (0, SIZE[1]), _page_size(pattern))]
    plan = divided(pattern, str(paper), keep_places)
    return plan.pattern, [Page(tile.name, tile.low, plan.shown) for tile in plan.tiles]


def page_sizes(
    pattern: "Pattern", paper: str | float | None = None, proof: bool = False, keep_places: bool = False
) -> list[np.ndarray]:
    """(2,) width and height in millimeters of each page that write_pdf would write. Raises FlattenError as it does."""
    paper = _paper(pattern, paper)
    size = _proof_size(paper)
    return _pattern_sizes(pattern, paper, keep_places) + ([size] * len(proof_pages(pattern, size)) if proof else [])


def _paper(pattern: "Pattern", paper: str | float | None) -> str | float:
    if paper is not None:
        return paper
    return page_width(pattern.marker, None, pattern.units) if pattern.marker else "a4"


def _proof_size(paper: str | float) -> np.ndarray:
    """The sheet, if it is printed at home; else A4."""
    return np.array(SHEETS[paper if isinstance(paper, str) and paper in SHEETS else "a4"])


def _pattern_sizes(pattern: "Pattern", paper: str | float, keep_places: bool) -> list[np.ndarray]:
    width = roll_width(paper)
    if width is not None and pattern.marker:
        page_width(pattern.marker, width, pattern.units)
        return [_marker_page(width, number, part) for number, part in enumerate(parts_of(pattern.marker))]
    if width is not None:
        return [page.size for _, page in _roll_pages(_on_roll(pattern, width, keep_places), width)]
    if paper == PROJECTOR:
        return [_page_size(pattern)]
    plan = divided(pattern, str(paper), keep_places)
    return [np.array(SHEETS[str(paper)]), *[plan.paper] * len(plan.tiles)]


def _document(pattern: "Pattern", *layers: str, hidden: tuple[str, ...] = ()) -> Document:
    return Document(pattern.title or "Pattern", [*LAYERS, *layers], hidden)


def _add_forms(document: Document, pattern: "Pattern", thinnest: float = 0.0) -> Steps[list[str]]:
    """One form per piece; returns sentences on texts that could not be drawn."""
    left_out = []
    for index, piece in enumerate(pattern.pieces):
        yield "writing", index / len(pattern.pieces)
        content = _drawn(piece, thinnest)
        low, high = piece.bounds
        document.add_form(_form(index), content, low - BORDER, high + BORDER)
        left_out += content.left_out
    return left_out


def _form(index: int) -> str:
    return f"P{index}"


def _drawn(piece: PatternPiece, thinnest: float) -> Content:
    content = Content(thinnest)
    strokes = list(strokes_of(piece))
    for layer in reversed(LAYERS):
        own = [stroke for stroke in strokes if stroke.look.layer == layer]
        content.in_layer(layer, own, [text for text in piece.texts if LOOKS[text.role].layer == layer])
    return content


def _one_page(pattern: "Pattern") -> Steps[Drawn]:
    """All on one page as large as it takes, with a grid that is hidden at first."""
    size, low = _page_size(pattern), pattern.bounds[0]
    document = _document(pattern, GRID_LAYER, hidden=(GRID_LAYER,))
    left_out = yield from _add_forms(document, pattern, PROJECTED)
    content = Content()
    content.in_layer(GRID_LAYER, _grid(size, GRID_STEP[pattern.units.name]))
    _add_scale(content, pattern, np.array([MARGIN, MARGIN]))
    for index in range(len(pattern.pieces)):
        content.add_form(_form(index), np.array([MARGIN, MARGIN + SIZE[1]]) - low)
    document.add_page(size, content)
    return document, left_out


def _page_size(pattern: "Pattern") -> np.ndarray:
    size: np.ndarray = np.maximum(pattern.size, (SIZE[0], 0)) + 2 * MARGIN + (0, SIZE[1])
    if size.max() > LONGEST:
        width, height, most = (pattern.units.text(float(side)) for side in (*size, LONGEST))
        raise problem(
            f"The pattern takes a page of {width} x {height}, and readers show no more than {most}: choose a roll or "
            "sheets."
        )
    return size


def _grid(size: np.ndarray, step: float) -> Iterator[Stroke]:
    for x in np.arange(step, size[0], step):
        yield Stroke("scale", np.array([[x, 0.0], [x, size[1]]]))
    for y in np.arange(step, size[1], step):
        yield Stroke("scale", np.array([[0.0, y], [size[0], y]]))


def _roll(pattern: "Pattern", width: float, keep_places: bool) -> Steps[Drawn]:
    """Pages as wide as the roll."""
    arranged = _on_roll(pattern, width, keep_places)
    pages = _roll_pages(arranged, width)
    document = _document(pattern)
    left_out = yield from _add_forms(document, arranged)
    for number, (pieces, page) in enumerate(pages):
        content = Content()
        if number == 0:
            _add_scale(content, pattern, np.array([MARGIN, MARGIN]))
        for index, _ in pieces:
            content.add_form(_form(index), -page.low)
        document.add_page(page.size, content)
    return document, left_out


def _marker(pattern: "Pattern", marker: Marker, width: float) -> Steps[Drawn]:
    """The cloth with its edges, on pages as wide as the roll of paper."""
    page_width(marker, width, pattern.units)
    document = _document(pattern, SHEET_LAYER)
    left_out = yield from _add_forms(document, pattern)
    boxes = [piece.bounds for piece in pattern.pieces]
    parts = parts_of(marker)
    for number, part in enumerate(parts):
        content = Content()
        corner = np.array([MARGIN, MARGIN])
        if number == 0:
            _add_scale(content, pattern, corner)
            content.in_layer("Scale", (), [Text((marker.sentence(pattern.units),), corner + (85.0, 122.0), 4.0)])
            corner = corner + (0, SIZE[1])
        content.clip(corner, corner + part.size)
        for index, (low, high) in enumerate(boxes):
            if np.all(low - BORDER < part.low + part.size) and np.all(high + BORDER > part.low):
                content.add_form(_form(index), corner - part.low)
        content.unclip()
        texts = [
            Text((f"{what} page {number + step}",), corner + (marker.width / 2, y), 4.0)
            for is_joined, what, step, y in (
                (not part.is_first, "Lay on", 0, OVERLAP / 2),
                (not part.is_last, "Continues on", 2, part.size[1] - OVERLAP / 2),
            )
            if is_joined
        ]
        content.in_layer(SHEET_LAYER, [Stroke("sheet", corner + part.size * UNIT, True)], texts)
        document.add_page(_marker_page(width, number, part), content)
    return document, left_out


def _marker_page(width: float, number: int, part: Part) -> np.ndarray:
    return np.array([width, part.size[1] + 2 * MARGIN + (SIZE[1] if number == 0 else 0.0)])


def _on_roll(pattern: "Pattern", width: float, keep_places: bool) -> "Pattern":
    """With the pieces in rows across the roll, or in their places. Raises FlattenError for what is too large for it."""
    inner, units = width - 2 * MARGIN, pattern.units
    for piece in pattern.pieces:
        if piece.size[0] > inner or piece.size[1] > LONGEST - 2 * MARGIN - SIZE[1]:
            size = " x ".join(units.measured(float(side)) for side in piece.size)
            raise problem(
                f'"{piece.name}" is {size}: too large for a roll of {units.text(width)}, of which '
                f"{units.text(inner)} can be printed, and for pages of {units.text(LONGEST)}."
            )
    if inner < SIZE[0]:
        raise problem(
            f"A roll of {units.text(width)} is too narrow for the square to measure: choose a wider one or sheets."
        )
    if keep_places and pattern.size[0] > inner:
        raise problem(
            f"As they lie the pieces are {units.text(float(pattern.size[0]))} wide: too wide for a roll of "
            f"{units.text(width)}, of which {units.text(inner)} can be printed. Lay them in rows, or move them."
        )
    return at_origin(pattern) if keep_places else pattern.arranged(inner)


def _roll_pages(arranged: "Pattern", width: float) -> list[tuple[list[Numbered], Page]]:
    """Of each page its pieces, which stay whole; none too long for readers."""
    pages = []
    for number, pieces in enumerate(_pages_of_rows(arranged)):
        low = min(piece.bounds[0][1] for _, piece in pieces)
        high = max(piece.bounds[1][1] for _, piece in pieces)
        block = SIZE[1] if number == 0 else 0.0  # what is to be measured
        size = np.array([width, high - low + 2 * MARGIN + block])
        pages.append((pieces, Page(str(number + 1), np.array([-MARGIN, low - MARGIN - block]), size)))
    return pages


def _pages_of_rows(pattern: "Pattern") -> list[list[Numbered]]:
    """The pieces of each page, none longer than readers show."""
    pages: list[list[Numbered]] = []
    low = 0.0
    room = LONGEST - 2 * MARGIN - SIZE[1]
    for index, piece in sorted(enumerate(pattern.pieces), key=lambda each: float(each[1].bounds[0][1])):
        bottom, top = float(piece.bounds[0][1]), float(piece.bounds[1][1])
        if not pages or top - low > room:
            pages.append([])
            low = bottom
        pages[-1].append((index, piece))
    return pages


def _add_scale(content: Content, pattern: "Pattern", corner: np.ndarray) -> None:
    strokes, texts = scale_block(corner, pattern.units)
    included = f"Allowance included: {pattern.allowance_text}"
    content.in_layer("Scale", strokes, [*texts, Text((included,), corner + (62.0, 116.0), 4.0)])


def _tiles(pattern: "Pattern", paper: str, keep_places: bool) -> Steps[Drawn]:
    """A first page with a map and what is to be measured, then the sheets."""
    plan = divided(pattern, paper, keep_places)
    document = _document(pattern, SHEET_LAYER)
    left_out = yield from _add_forms(document, plan.pattern)
    cover = _map_page(plan, np.array(SHEETS[paper]))
    document.add_page(np.array(SHEETS[paper]), cover)
    margin = np.array([MARGIN, MARGIN])
    boxes = [piece.bounds for piece in plan.pattern.pieces]
    for number, tile in enumerate(plan.tiles):
        yield "sheets", number / len(plan.tiles)
        content = Content()
        content.clip(margin, margin + plan.shown)
        for index, (low, high) in enumerate(boxes):
            if np.all(low - BORDER < tile.low + plan.shown) and np.all(high + BORDER > tile.low):
                content.add_form(_form(index), margin - tile.low)
        content.unclip()
        content.in_layer(SHEET_LAYER, *_sheet_marks(plan, tile.row, tile.column))
        document.add_page(plan.paper, content)
    return document, left_out + cover.left_out


def _sheet_marks(plan: Tiles, row: int, column: int) -> tuple[list[Stroke], list[Text]]:
    """The frame, its name, diamonds that two sheets complete, and which sheet comes at which side."""
    low, high = np.array([MARGIN, MARGIN]), MARGIN + plan.shown
    strokes = [Stroke("sheet", low + plan.shown * UNIT, True)]
    texts = [Text((tile_name(row, column),), low + (9.0, 7.0), 6.0)]
    middle = (low + high) / 2
    sides = (
        (np.array([-1, 0]), (row, column - 1), np.array([low[0] + OVERLAP / 2, middle[1]])),
        (np.array([1, 0]), (row, column + 1), np.array([high[0] - OVERLAP / 2, middle[1]])),
        (np.array([0, 1]), (row - 1, column), np.array([middle[0], high[1] - OVERLAP / 2])),
        (np.array([0, -1]), (row + 1, column), np.array([middle[0], low[1] + OVERLAP / 2])),
    )
    for direction, (other_row, other_column), at in sides:
        if plan.overlap and 0 <= other_row < plan.rows and 0 <= other_column < plan.columns:
            # Both sheets show the whole overlap, so the diamond in its middle lies on itself.
            strokes.append(Stroke("sheet", at + OVERLAP / 2 * np.array([[1, 0], [0, 1], [-1, 0], [0, -1]]), True))
            aside = np.array([direction[1], direction[0]])
            angle = 90.0 if direction[0] else 0.0
            texts.append(Text((tile_name(other_row, other_column),), at + 12.0 * np.abs(aside), 3.0, angle))
    return strokes, texts


def _map_page(plan: Tiles, paper: np.ndarray) -> Content:
    """Title and advice, the sheets with the pieces on them, and what is to be measured."""
    pattern, content = plan.pattern, Content()
    _add_scale(content, pattern, np.array([MARGIN, MARGIN]))
    skipped = plan.rows * plan.columns - len(plan.tiles)
    sheets = f"{counted(len(plan.tiles), 'sheet')} in {counted(plan.rows, 'row')} of {plan.columns}"
    sheets += f", {skipped} more are empty and left out" if skipped else ""
    lines = [
        pattern.title or "Pattern",
        "Print at 100% (actual size), not fitted to the page; then measure the squares and bars.",
        f"{sheets}; neighbors overlap by {pattern.units.text(OVERLAP)}: lay diamond on diamond."
        if plan.overlap
        else f"{counted(len(plan.tiles), 'sheet')}, every piece on one of them.",
        f"{counted(len(pattern.pieces), 'piece')}. Allowance included: {pattern.allowance_text}.",
    ]
    top = paper[1] - MARGIN
    texts = [
        Text((line,), np.array([paper[0] / 2, top - 4 - 5.0 * n]), 4.5 if n == 0 else 3.4)
        for n, line in enumerate(lines)
    ]
    content.in_layer("Text", (), texts)
    room = np.array([paper[0] - 2 * MARGIN, top - 26 - MARGIN - SIZE[1]])
    whole = np.array([plan.columns, plan.rows]) * (plan.shown - plan.overlap) + plan.overlap
    scale = float((room / whole).min())
    corner = np.array([(paper[0] - scale * whole[0]) / 2, MARGIN + SIZE[1] + 2]) - scale * plan.low

    def placed(points: np.ndarray) -> np.ndarray:
        return corner + scale * points

    outlines = [Stroke("scale", placed(line.points), True) for piece in pattern.pieces for line in piece.of_role("cut")]
    numbers = [Text((str(piece.number),), placed(piece.bounds[0] + piece.size / 2), 3.0) for piece in pattern.pieces]
    content.in_layer("Scale", outlines, numbers)
    frames = [Stroke("sheet", placed(tile.low + plan.shown * UNIT), True) for tile in plan.tiles]
    height = min(3.0, 0.12 * scale * float(plan.shown.min()))
    names = [Text((tile.name,), placed(tile.low + plan.shown * (0.15, 0.1)), height) for tile in plan.tiles]
    content.in_layer(SHEET_LAYER, frames, names)
    return content
