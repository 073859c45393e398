# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the place with the most room for a text inside a piece."""

import math
import unicodedata
from collections.abc import Sequence

import numpy as np

from ..geometry import innermost_point
from ..model import Text

WIDE = 3.0  # ratio of width to height of a text that the search assumes
LETTER, LINE = 0.62, 1.35  # width of a letter and distance of lines, as shares of the height of the text
WIDE_LETTER = 1.0  # width of Chinese and similar letters and of emoji, as a share of the height
# Text is turned by 90 degrees only if its horizontal letters would be too small. They are too small below this share of
# the largest height, if they are also below this share of the height of turned letters.
NEARLY = 0.6
SMALL = 0.3125  # share of the largest height (2.5 of 8 mm); if text would be smaller, it may cross lines


def place_text(
    lines: tuple[str, ...], outlines: Sequence[np.ndarray], kinds: Sequence[Sequence[np.ndarray]], largest: float
) -> Text:
    """Return the text where its letters can be largest, at most `largest` millimeters high.

    - outlines (k,2): closed lines, never crossed
    - kinds: groups of lines (k,2) inside, crossed in this order if room is missing
    """
    for crossed in range(len(kinds) + 1):
        text = _place(lines, outlines, [line for kind in kinds[crossed:] for line in kind], largest)
        if text.height >= SMALL * largest:
            break
    return text


def _place(
    lines: tuple[str, ...], outlines: Sequence[np.ndarray], lines_inside: Sequence[np.ndarray], largest: float
) -> Text:
    level = _turned(lines, outlines, lines_inside, largest, 0.0)
    if level.height >= NEARLY * largest:
        return level
    upright = _turned(lines, outlines, lines_inside, largest, 90.0)
    return level if level.height >= NEARLY * upright.height else upright


def _turned(
    lines: tuple[str, ...],
    outlines: Sequence[np.ndarray],
    lines_inside: Sequence[np.ndarray],
    largest: float,
    angle: float,
) -> Text:
    cosine, sine = round(math.cos(math.radians(angle))), round(math.sin(math.radians(angle)))
    turn = np.array([[cosine, -sine], [sine, cosine]])  # turns directions of the text into directions of the piece
    squeezed = [[points @ turn / (WIDE, 1) for points in group] for group in (outlines, lines_inside)]
    center, radius = innermost_point(*squeezed)
    half_width, half_height = max(text_width(line, 1.0) for line in lines) / (2 * WIDE), LINE * len(lines) / 2
    height = 0.9 * radius / math.hypot(half_width, half_height)  # the corners of the text stay inside the free ellipse
    return Text(lines, turn @ (center * (WIDE, 1)), min(height, largest), angle)


def text_width(text: str, height: float) -> float:
    """Return a width that the text does not exceed in usual fonts, in the unit of the height."""
    return height * sum(WIDE_LETTER if unicodedata.east_asian_width(letter) in "FW" else LETTER for letter in text)
