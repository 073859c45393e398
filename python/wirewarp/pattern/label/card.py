# SPDX-License-Identifier: GPL-3.0-or-later
"""Places the texts on a piece: the card and the names of its lines."""

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ..geometry import innermost_point
from ..model import LEADERS, PatternPiece, Text
from ..units import UnitSystem
from .grain_beside import grain_beside
from .leaders import Beside, Box
from .line_names import line_names
from .room import Room
from .text_place import place_text

TEXT_HEIGHT, LEAST_HEIGHT = 8.0, 2.5  # largest and smallest height in millimeters; nobody can read smaller letters
SHOWN_NAMES = 2  # largest number of names on a card; with more names, the letters would be too small
DOWN = np.array([0.0, -1.0])


class Sheets(NamedTuple):
    """Sheets of paper below a pattern. Each text stays on one sheet if there is room."""

    boxes: Sequence[Box] = ()  # the part of the pattern that each sheet shows
    borders: Sequence[np.ndarray] = ()  # (2,2) middle lines of the overlaps of sheets; texts avoid them
    others: Sequence[np.ndarray] = ()  # (k,2) closed lines around other pieces and their texts


ANYWHERE = Sheets()


def with_card(
    piece: PatternPiece, number: int, count: int, heading: str, units: UnitSystem, sheets: Sheets = ANYWHERE
) -> PatternPiece:
    """Return the piece with its number and texts: a card for the maker, and names along its lines.

    The card contains heading (title and date), number of the piece, name, quantity, material, allowance and area.
    """
    allowance = units.range_of(piece.allowances)
    includes = "No seam allowance" if allowance == "none" else f"Includes {allowance} allowance"
    place = f"{number} of {count}"
    name = _name_with_copies(piece)
    lines = (heading, place, name, how_to_cut(piece), piece.material, includes, units.area_text(piece.area))
    outlines = [line.points for line in piece.of_role("cut", "inner_cut")]
    wires, seams, grain = ([line.path for line in piece.of_role(role)] for role in ("wire", "sew", "grain"))
    # If there is too little room, the card crosses the grain arrow first, because the arrow can be moved.
    kinds = [grain, [*wires, *seams], sheets.borders]
    text = _card([tuple(line for line in lines if line.strip()), (piece.name,), (place,)], outlines, kinds)
    if text:
        places, widest = (outlines, wires, seams), max(piece.allowances, default=0.0)
        moved = [grain_beside(text[0], line, *places, widest) if line.role == "grain" else line for line in piece.lines]
        piece = replace(piece, lines=moved)
    drawn = [*(line.path for line in piece.of_role("wire", "grain", "sew")), *sheets.borders]
    notches = [point.stroke for point in piece.points]
    room, beside = Room(outlines, [*drawn, *notches], text), Beside(outlines, sheets.boxes, sheets.others)
    short = [name for name in (piece.name, place) if name]
    led = None if text else beside.lead(_short_cards(short, outlines), DOWN)
    names, leaders = line_names(piece.lines, room, beside)
    kept = [line for line in piece.lines if line.role not in LEADERS.values()]
    if led:
        text, leaders = [led[0]], [led[1], *leaders]
    return replace(piece, number=number, lines=[*kept, *leaders], texts=[*text, *names])


def _name_with_copies(piece: PatternPiece) -> str:
    names = [name for name in (piece.name, *piece.copied_names) if name]
    return " / ".join(names) if len(names) <= SHOWN_NAMES else f"{names[0]} and {len(names) - 1} more"


def with_card_anew(
    piece: PatternPiece, count: int, heading: str, units: UnitSystem, sheets: Sheets = ANYWHERE
) -> PatternPiece:
    """Return the piece with its texts placed again, for example after a change of its lines.

    Kinds of texts that the piece does not have are not added.
    """
    roles = {text.role for text in piece.texts}
    whole = with_card(piece, piece.number, count, heading, units, sheets)
    left_out = {LEADERS[role] for role in LEADERS if role not in roles}
    return replace(
        whole,
        lines=[line for line in whole.lines if line.role not in left_out],
        texts=[text for text in whole.texts if text.role in roles],
    )


def _card(cards: list[tuple[str, ...]], outlines: list[np.ndarray], kinds: list[Sequence[np.ndarray]]) -> list[Text]:
    """Return the first card whose letters are large enough to read, or no card.

    cards: the lines of each card, the card with the most text first. kinds: as for place_text().
    """
    texts = (place_text(card, outlines, kinds, TEXT_HEIGHT) for card in cards)
    return next(([text] for text in texts if text.height >= LEAST_HEIGHT), [])


def _short_cards(texts: list[str], outlines: list[np.ndarray]) -> list[Text]:
    """Return a card for each of the texts, at the middle of a piece that is too small for a card inside it."""
    center, _ = innermost_point(outlines, [])
    return [Text((text,), center, LEAST_HEIGHT) for text in texts]


def how_to_cut(piece: PatternPiece) -> str:
    """Return the text for the quantity, such as "Cut 1 on the fold" or "Cut 1 pair (2 pieces, one mirrored)"."""
    if piece.on_fold:
        return f"Cut {sum(piece.quantity)} on the fold"  # an opened piece is its own mirror image
    return piece.quantity_text + (" (2 pieces, one mirrored)" if piece.quantity == (1, 1) else "")
