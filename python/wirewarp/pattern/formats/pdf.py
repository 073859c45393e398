# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a pattern as PDF: sheets to tape together, a roll for a plotter, or one page for a projector."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from ..label.card import with_card_anew
from ..label.room import corners
from ..model import PatternPiece
from ..pattern_data import PatternData
from ..progress import Steps
from ..sheet.drawing import LAYERS, LOOKS, strokes_of
from ..sheet.papers import SHEETS
from ..sheet.plan import BORDER, Plan, plan
from ..sheet.proof import proof_pages
from .file_format import Format, Option
from .pdf_document import Content, Document
from .read_back import read_pdf

Paper = str | float | None


def write_pdf(
    path: Path, pattern: PatternData, paper: Paper = None, proof: bool = False, keep_places: bool = False
) -> Steps[tuple[int, list[str]]]:
    """Write the file in steps. Return the number of pages, and sentences about texts that could not be drawn.

    - paper: a key of PAPERS, or the width of a roll in millimeters
    - paper=None: A4 for a pattern, and a roll of the necessary width for a marker
    - proof: whether to add pages with all pieces, finished measures, all seams, and a sewing order
    - keep_places: whether pieces keep their places on sheets and rolls; otherwise they are arranged anew
    """
    planned = yield from _with_texts_on_sheets(plan(pattern, paper, keep_places))
    document = Document(pattern.title or "Pattern", [*LAYERS, *planned.layers], planned.hidden)
    left_out = yield from _add_forms(document, planned)
    for number, sheet in enumerate(planned.all_sheets):
        yield "sheets", number / len(planned.all_sheets)
        content = Content()
        for layer, strokes, texts in sheet.marks(planned.pattern):
            content.in_layer(layer, strokes, texts)
        if sheet.is_clipped:
            content.clip(sheet.corner, sheet.corner + sheet.size)
        for index in sheet.pieces:
            content.add_form(_form(index), sheet.corner - sheet.low)
        if sheet.is_clipped:
            content.unclip()
        document.add_page(sheet.paper, content)
        left_out += content.left_out
    for texts in proof_pages(pattern, _proof_size(paper)) if proof else []:
        content = Content()
        content.in_layer("Text", (), texts)
        document.add_page(_proof_size(paper), content)
        left_out += content.left_out
    document.write(path)
    return document.page_count, list(dict.fromkeys(left_out))


def page_sizes(
    pattern: PatternData, paper: Paper = None, proof: bool = False, keep_places: bool = False
) -> list[np.ndarray]:
    """Return width and height (2,) in millimeters of each page that write_pdf() would write. Raises FlattenError for a
    pattern that does not fit on the paper."""
    size = _proof_size(paper)
    sizes = [sheet.paper for sheet in plan(pattern, paper, keep_places).all_sheets]
    return sizes + ([size] * len(proof_pages(pattern, size)) if proof else [])


def _proof_size(paper: Paper) -> np.ndarray:
    """Return the size (2,) of a proof page in millimeters: the paper, or A4 if the paper is not a sheet."""
    return np.array(SHEETS[paper if isinstance(paper, str) and paper in SHEETS else "a4"])


def _add_forms(document: Document, planned: Plan[PatternData]) -> Steps[list[str]]:
    """Add one form (a shared drawing) per piece, in steps. Return sentences about texts that could not be drawn."""
    left_out = []
    pieces = planned.pattern.pieces
    for index, piece in enumerate(pieces):
        yield "writing", index / len(pieces)
        content = _drawn(piece, planned.thinnest)
        low, high = piece.bounds
        document.add_form(_form(index), content, low - BORDER, high + BORDER)
        left_out += content.left_out
    return left_out


def _with_texts_on_sheets(planned: Plan[PatternData]) -> Steps[Plan[PatternData]]:
    """Return the plan with its texts placed again, in steps. Each text is on a single sheet if there is room."""
    if planned.text_sheets is None:
        return planned
    pattern, pieces = planned.pattern, list[PatternPiece]()
    cut = [[line.points for line in piece.of_role("cut")] for piece in pattern.pieces]
    low, high = np.array([piece.bounds for piece in pattern.pieces]).transpose(1, 0, 2)
    beside: list[np.ndarray] = []
    for index, piece in enumerate(pattern.pieces):
        yield "texts", index / len(pattern.pieces)
        borders = [
            line
            for line in planned.text_sheets.borders
            if np.all(line.min(axis=0) < high[index]) and np.all(line.max(axis=0) > low[index])
        ]
        can_cross = borders or any(text.is_beside for text in piece.texts)
        # If the stitching lines are left out, names along them cannot be placed again.
        if can_cross and piece.of_role("sew") and piece.texts:
            near = np.all((low - BORDER < high[index]) & (high + BORDER > low[index]), axis=1)
            others = [line for n in np.flatnonzero(near) if n != index for line in cut[n]]
            sheets = planned.text_sheets._replace(borders=borders, others=[*others, *beside])
            piece = with_card_anew(piece, len(pattern.pieces), pattern.heading, pattern.units, sheets)
            beside += [corners(text) for text in piece.texts if text.is_beside]
        pieces.append(piece)
    return replace(planned, pattern=replace(pattern, pieces=pieces))


def _form(index: int) -> str:
    return f"P{index}"


def _drawn(piece: PatternPiece, thinnest: float) -> Content:
    content = Content(thinnest)
    strokes = list(strokes_of(piece))
    for layer in reversed(LAYERS):
        own = [stroke for stroke in strokes if stroke.look.layer == layer]
        content.in_layer(layer, own, [text for text in piece.texts if LOOKS[text.role].layer == layer])
    return content


PDF_FORMAT = Format(
    ".pdf",
    "PDF, to print",
    "Sheets to tape together, a roll for a plotter, or one page for a projector",
    write_pdf,
    read_pdf,
    options=(
        Option(
            "proof",
            "Proof Sheet",
            "Add sheets at the end with all pieces, finished measures and seams, and a sewing order",
        ),
    ),
    has_pages=True,
)
