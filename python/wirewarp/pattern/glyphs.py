# SPDX-License-Identifier: GPL-3.0-or-later
"""Letters of any script as outlines, joined and ordered as the script wants it by HarfBuzz.

Of Unicode's rules for lines in both directions the first ones are followed: parts are in the order of the first letter,
spaces and signs go with what is around them. Brackets are not mirrored, nor are parts within parts ordered.
"""

import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
import uharfbuzz

from .fonts import Font, font_with
from .glyph_pen import Part

JOINING = ("Mn", "Me", "Mc", "Cf")  # categories of what belongs to the letter before it
RIGHT_TO_LEFT = ("R", "AL")


class NoLettersError(Exception):
    """str() says which letters cannot be drawn, and why."""


@dataclass(frozen=True)
class Line:
    parts: list[Part]  # from 0, 0 on the base line
    width: float  # in heights of the text


@dataclass(frozen=True)
class _Run:
    """Letters of one font and one direction."""

    font: Font
    text: str
    is_leftwards: bool


@cache
def line_of(text: str) -> Line:
    """Raises NoLettersError."""
    letters = [letter for letter in text if unicodedata.category(letter) not in ("Cc", "Cs", "Cn")]
    strong = [_direction(letter) for letter in letters]
    is_leftwards = next((each for each in strong if each is not None), False)
    runs = list(_runs(letters, _resolved(strong, is_leftwards)))
    parts: list[Part] = []
    width = 0.0
    for run in runs[::-1] if is_leftwards else runs:
        own, advance = _shaped(run)
        parts += [(operator, points + (width, 0)) for operator, points in own]
        width += advance
    return Line(parts, width)


def _direction(letter: str) -> bool | None:
    """Whether it runs from right to left; None of spaces and signs."""
    direction = unicodedata.bidirectional(letter)
    return direction in RIGHT_TO_LEFT if direction in ("L", "EN", *RIGHT_TO_LEFT) else None


def _resolved(strong: Sequence[bool | None], is_leftwards: bool) -> list[bool]:
    """Spaces and signs go with letters of one direction on both of their sides, else with the line."""
    before, after = list(strong), list(strong)
    for number in range(len(strong)):
        if before[number] is None:
            before[number] = before[number - 1] if number else is_leftwards
        if after[-1 - number] is None:
            after[-1 - number] = after[-number] if number else is_leftwards
    return [bool(one) if one == other else is_leftwards for one, other in zip(before, after, strict=True)]


def _runs(letters: Sequence[str], directions: Sequence[bool]) -> Iterator[_Run]:
    font: Font | None = None
    text, is_leftwards = "", False
    for letter, leftwards in zip(letters, directions, strict=True):
        found = _font_of(letter, font)
        if text and font and (found is not font or leftwards != is_leftwards):
            yield _Run(font, text, is_leftwards)
            text = ""
        font, text, is_leftwards = found, text + letter, leftwards
    if text and font:
        yield _Run(font, text, is_leftwards)


def _font_of(letter: str, before: Font | None) -> Font:
    """The font before it where that will do. Raises NoLettersError."""
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
    buffer.direction = "rtl" if run.is_leftwards else "ltr"
    uharfbuzz.shape(run.font.shapes, buffer)
    unit = 1 / run.font.shapes.face.upem
    parts: list[Part] = []
    at = np.zeros(2)
    for info, place in zip(buffer.glyph_infos, buffer.glyph_positions, strict=True):
        offset = at + (place.x_offset, place.y_offset)
        parts += [(operator, (points + offset) * unit) for operator, points in run.font.outline(info.codepoint)]
        at = at + (place.x_advance, place.y_advance)
    return parts, float(at[0]) * unit
