# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes pages to check before cutting: tables of pieces, measures and seams, and a sewing order."""

from collections.abc import Sequence

import numpy as np

from ..label import helvetica
from ..label.card import how_to_cut
from ..label.glyphs import NoLettersError, line_of
from ..make.seams import longer_texts
from ..model import Text
from ..pattern_data import PatternData, SeamWalk, SewingStep
from ..units import UnitSystem
from .papers import MARGIN

HEIGHT, LINE = 3.2, 5.0  # millimeters: letters of 9 points, and the distance between the base lines of rows
COLUMNS = (0.0, 0.32, 0.55, 0.77, 0.89)  # starts of the columns, as shares of the width; names need the most room
SHOWN = 0.0005  # millimeters; a smaller deviation is left out, because it would be printed as 0.000 mm
CLOTHS = (900.0, 1400.0, 1500.0)  # millimeters: usual widths of fabric
AT_ONCE = 6  # number of notches whose places are printed in one row; it fits on A4 beside a short name
SHORTENED = "..."
Row = Sequence[str]


def proof_pages(pattern: PatternData, paper: np.ndarray) -> list[list[Text]]:
    """Return the texts of each page. paper (2,): size of a page in millimeters."""
    parts = [_piece_rows(pattern), _measure_rows(pattern), _step_rows(pattern), _seam_rows(pattern)]
    rows = [row for part in parts if part for row in ((), *part)][1:]
    at_once = max(int((paper[1] - 2 * MARGIN) / LINE), 1)
    return [_page(rows[start : start + at_once], paper) for start in range(0, len(rows), at_once)]


def _piece_rows(pattern: PatternData) -> list[Row]:
    units = pattern.units
    rows: list[Row] = [(pattern.heading or "Pattern",), (), ("Piece", "Cut", "Size to cut", "Area sewn")]
    for piece in pattern.pieces:
        cut = how_to_cut(piece).split(" (")[0]
        size = " × ".join(units.measured(float(side)) for side in piece.size)
        rows.append((f"{piece.number}  {piece.name}", cut, size, units.area_text(piece.area)))
        if piece.deviation > SHOWN:
            off = units.difference_text(piece.deviation)
            rows.append(("", f"Drawn once. A copy differs by up to {off}"))
    if pattern.marker:
        return [*rows, (pattern.marker.sentence(units),)]
    for width in CLOTHS:
        if max(piece.size[0] for piece in pattern.pieces) <= width:
            length = units.text(float(pattern.arranged(width).size[1]))
            rows.append((f"Fabric {units.text(width)} wide, pieces in rows and not turned: {length}",))
    return rows


def _measure_rows(pattern: PatternData) -> list[Row]:
    if not pattern.measures:
        return []
    rows = [("", name, pattern.units.measured(length)) for name, length in pattern.measures]
    return [("Finished measures", "Line", "Length"), *rows]


def _step_rows(pattern: PatternData) -> list[Row]:
    rows = [(f"{number}  {step.seam}", _step_text(step)) for number, step in enumerate(pattern.steps, start=1)]
    if rows and any(step.has_gap for step in pattern.steps):
        rows.append((f"{len(rows) + 1}", "Turn the work through the gap and close the gap by hand"))
    return [("Sewing order", "Step"), *rows] if rows else []


def _step_text(step: SewingStep) -> str:
    names = " to ".join(step.pieces)
    match step.kind:
        case "dart":
            text = f"Close the dart in {names}"
        case "all around":
            text = f"Sew {names} all around"
        case _:
            what = f"the two sides of {names} together" if len(step.pieces) == 1 else names
            text = f"Sew {what}{', which closes a ring' if step.kind == 'ring' else ''}"
    return f"{text}, and leave a gap for turning" if step.has_gap else text


def _seam_rows(pattern: PatternData) -> list[Row]:
    """Return the rows for each seam: its sides with lengths and allowances, their difference, and the notches."""
    rows: list[Row] = [("Seam", "Side", "Sewn length", "Allowance", "Difference")]
    for walk in pattern.walks:
        if not walk.lengths:  # true for pieces without a layout
            continue
        difference = max(walk.lengths) - min(walk.lengths)
        sides = zip(walk.pieces, walk.lengths, walk.allowances, strict=True)
        for side, (name, length, widths) in enumerate(sides):
            allowance = pattern.units.range_of(widths)
            note = pattern.units.difference_text(difference) if side == 0 else ""
            rows.append((walk.name if side == 0 else "", name, pattern.units.measured(length), allowance, note))
        eased = zip(walk.pieces, longer_texts(walk.lengths, pattern.units), strict=True)
        rows += [("", f"{name} {text}") for name, text in eased if text]
        rows += _notch_rows(walk, pattern.units)
    return rows


def _notch_rows(walk: SeamWalk, units: UnitSystem) -> list[Row]:
    """Return the rows for the notches of a seam, as lengths from the same end of all sides. If the notches of the sides
    differ, each side has its own rows."""
    sides = [[units.measured(place) for place in places] for places in walk.notches]
    if not any(sides):
        return []
    if all(places == sides[0] for places in sides):
        return _in_lines("Notches at ", sides[0])
    named = zip(walk.pieces, sides, strict=True)
    return [row for name, places in named for row in _in_lines(f"Notches of {name} at ", places)]


def _in_lines(begin: str, places: Sequence[str]) -> list[Row]:
    """Return rows with AT_ONCE places each. The first row begins with the text `begin`."""
    lines = [", ".join(places[start : start + AT_ONCE]) for start in range(0, len(places), AT_ONCE)]
    return [("", (begin if number == 0 else "") + line) for number, line in enumerate(lines)]


def _page(rows: Sequence[Row], paper: np.ndarray) -> list[Text]:
    texts = []
    width = float(paper[0]) - 2 * MARGIN
    for number, row in enumerate(rows):
        ends = [*COLUMNS[1 : len(row)], 1.0]
        for words, begin, end in zip(row, COLUMNS, ends, strict=False):
            if words:
                shown = _fitted(words, (end - begin) * width)
                middle = MARGIN + begin * width + _width(shown) / 2
                texts.append(Text((shown,), np.array([middle, paper[1] - MARGIN - LINE * (number + 0.5)]), HEIGHT))
    return texts


def _fitted(words: str, room: float) -> str:
    """Return the text, shortened if it is wider than `room` millimeters."""
    shown = words
    while _width(shown) > room and len(shown) > len(SHORTENED):
        shown = shown.removesuffix(SHORTENED)[:-1] + SHORTENED
    return shown


def _width(words: str) -> float:
    """Return the width of a text in millimeters; 0 if its letters cannot be drawn."""
    letters = helvetica.encoded(words)
    if letters is not None:
        return helvetica.width(letters, HEIGHT)
    try:
        return HEIGHT * line_of(words).width
    except NoLettersError:
        return 0.0
