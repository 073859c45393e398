# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds room for another text in a piece: inside its outline, and away from lines and other texts."""

import math
from collections.abc import Iterable

import numpy as np

from ..geometry import are_inside
from ..model import Text
from .text_place import LINE, text_width

CLEAR = 0.5  # millimeters between a text and its neighbors: the thickness of the thickest line
# These are the places of the strokes that represent a line of text, in heights of the text. No other text fits between
# two strokes.
STROKES = np.linspace(-0.5, 0.5, 5)

Segments = tuple[np.ndarray, np.ndarray]  # first and second ends (s,2) of segments


class Room:
    """The free room in a piece. If there is no other place, a text may cross lines, but not outlines or other texts."""

    def __init__(self, outlines: Iterable[np.ndarray], lines: Iterable[np.ndarray], texts: Iterable[Text]) -> None:
        """Begin with the outlines (k,2), lines (k,2) such as wires and notches, and texts of the piece."""
        self._outlines = list(outlines)
        self._outline = joined([(line, np.roll(line, -1, axis=0)) for line in self._outlines])
        self._lines = joined([(line[:-1], line[1:]) for line in lines])
        self._texts = joined([strokes(text) for text in texts])

    def take(self, choices: Iterable[Text]) -> Text | None:
        """Return the first text that fits without crossing a line, or else the first that fits, and reserve its place.
        Return None if no text fits."""
        found = None
        for text in filter(self._is_inside, choices):
            is_clear = not touches(text, self._lines)
            found = text if is_clear or not found else found
            if is_clear:
                break
        if found:
            self._texts = joined([self._texts, strokes(found)])
        return found

    def _is_inside(self, text: Text) -> bool:
        if touches(text, self._texts) or touches(text, self._outline):
            return False
        return bool(are_inside(text.center[None], self._outlines)[0])


def joined(parts: list[Segments]) -> Segments:
    first, second = (np.concatenate([np.empty((0, 2)), *(part[end] for part in parts)]) for end in (0, 1))
    return first, second


def axes(text: Text) -> np.ndarray:
    """Return the unit vectors along the lines of a text and up its letters, as the columns of (2,2)."""
    cosine, sine = math.cos(math.radians(text.angle)), math.sin(math.radians(text.angle))
    return np.array([[cosine, -sine], [sine, cosine]])


def corners(text: Text, clear: float = 0.0) -> np.ndarray:
    """Return the corners (4,2) of the box of a text. clear: millimeters between the text and its box."""
    return text.center + (_half_size(text, clear) * [[-1, -1], [1, -1], [1, 1], [-1, 1]]) @ axes(text).T


def _half_size(text: Text, clear: float) -> np.ndarray:
    width = max(text_width(line, text.height) for line in text.lines)
    height = text.height * (1 + LINE * (len(text.lines) - 1))
    half: np.ndarray = np.array([width, height]) / 2 + clear
    return half


def strokes(text: Text) -> Segments:
    strokes = []
    for number, line in enumerate(text.lines):
        middle = LINE * ((len(text.lines) - 1) / 2 - number)
        y = text.height * (middle + STROKES)
        x = np.full(len(y), text_width(line, text.height) / 2)
        first, second = (np.column_stack([side, y]) @ axes(text).T + text.center for side in (-x, x))
        strokes.append((first, second))
    return joined(strokes)


def touches(text: Text, segments: Segments, clear: float = CLEAR) -> bool:
    """Return whether a segment crosses the box of a text with `clear` millimeters around the text."""
    half = _half_size(text, clear)
    a, b = ((ends - text.center) @ axes(text) for ends in segments)
    apart = np.any((np.minimum(a, b) > half) | (np.maximum(a, b) < -half), axis=1)
    normal = (b - a)[:, ::-1] * (-1, 1)
    beside = np.abs((normal * a).sum(axis=1)) > np.abs(normal) @ half
    return bool(np.any(~apart & ~beside))
