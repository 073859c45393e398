# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws letters of any script as outlines. HarfBuzz joins the letters, and bidi.py orders runs of letters."""

import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
import uharfbuzz

from .bidi import in_visual_order, levels
from .fonts import Font, Part, font_with

JOINING = ("Mn", "Me", "Mc", "Cf")  # categories of characters that belong to the letter before them


class NoLettersError(Exception):
    """Raised for letters that cannot be drawn. str() names the letters and the reason."""


@dataclass(frozen=True)
class Line:
    parts: list[Part]  # outlines, in units of the text's height; the line begins at 0, 0 on the base line
    width: float  # as a multiple of the height of the text


@dataclass(frozen=True)
class _Run:
    """Successive letters with one font and one embedding level."""

    font: Font
    text: str
    level: int  # odd levels run from right to left


@cache
def line_of(text: str) -> Line:
    """Return the outlines of a line of text. Raises NoLettersError."""
    letters = [letter for letter in text if unicodedata.category(letter) not in ("Cc", "Cs", "Cn")]
    runs = list(_runs(letters, levels(letters)))
    parts: list[Part] = []
    width = 0.0
    for run in in_visual_order(runs, [run.level for run in runs]):
        own, advance = _shaped(run)
        parts += [(operator, points + (width, 0)) for operator, points in own]
        width += advance
    return Line(parts, width)


def _runs(letters: Sequence[str], own_levels: Sequence[int]) -> Iterator[_Run]:
    run: _Run | None = None
    for letter, level in zip(letters, own_levels, strict=True):
        font = _font_of(letter, run.font if run else None)
        if run and (font is not run.font or level != run.level):
            yield run
            run = None
        run = _Run(font, (run.text if run else "") + letter, level)
    if run:
        yield run


def _font_of(letter: str, before: Font | None) -> Font:
    """Return the font of the previous letter if that font has this letter, otherwise another font.

    Raises NoLettersError.
    """
    if before and (before.has(letter) or unicodedata.category(letter) in JOINING):
        return before
    found = font_with("n" if letter.isspace() else letter)
    if found is None:
        raise NoLettersError(f'no font with the letter "{letter}" was found')
    return found


def _shaped(run: _Run) -> tuple[list[Part], float]:
    buffer = uharfbuzz.Buffer()
    buffer.add_str(run.text)
    buffer.guess_segment_properties()
    buffer.direction = "rtl" if run.level % 2 else "ltr"
    uharfbuzz.shape(run.font.shapes, buffer)
    unit = 1 / run.font.shapes.face.upem
    parts: list[Part] = []
    at = np.zeros(2)
    for info, place in zip(buffer.glyph_infos, buffer.glyph_positions, strict=True):
        offset = at + (place.x_offset, place.y_offset)
        parts += [(operator, (points + offset) * unit) for operator, points in run.font.outline(info.codepoint)]
        at = at + (place.x_advance, place.y_advance)
    return parts, float(at[0]) * unit
