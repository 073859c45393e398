# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts that a piece has no room for: beside it, underlined, with a line that leads to what they are about."""

import math
from collections.abc import Iterator, Sequence

import numpy as np

from .interior import are_inside, distance_to, text_width
from .model import LEADERS, Line, Text
from .room import CLEAR, joined, strokes, touches

NEAREST, FARTHEST, STEP = 2.0, 40.0, 1.0  # millimeters from what is named to the middle of the text
TURNS = (0, 30, -30, 60, -60, 90, -90, 135, -135, 180)  # degrees from the way straight out, the best first


class Beside:
    """The surroundings of one piece."""

    def __init__(self, outlines: Sequence[np.ndarray]) -> None:
        """outlines (k,2): the cut lines, closed, repeating their first point."""
        self._outlines = list(outlines)
        self._taken = joined([(line[:-1], line[1:]) for line in self._outlines])
        self._texts: list[Text] = []

    def lead(self, text: Text, outward: np.ndarray) -> tuple[Text, Line] | None:
        """The text, of one line, outside of the piece, and the line to it from its center, where it had no room.

        outward (2,): a unit vector, the way to where it would best stand. None where nothing near is free: a line far
        across the piece would be taken for one of its own.
        """
        for center in self._centers(text.center, outward):
            placed = Text(text.lines, center, text.height, role=text.role)
            points = _leader(placed, text.center)
            if self._is_free(placed, points):
                self._texts.append(placed)
                self._taken = joined([self._taken, strokes(placed), (points[:-1], points[1:])])
                return placed, Line(LEADERS[text.role], points)
        return None

    def _centers(self, target: np.ndarray, outward: np.ndarray) -> Iterator[np.ndarray]:
        """The nearest first; none inside of the outline."""
        nearest = max(NEAREST, min(distance_to(target, outline) for outline in self._outlines))
        for distance in np.arange(nearest, FARTHEST, STEP):
            for turn in np.radians(TURNS):
                cosine, sine = math.cos(turn), math.sin(turn)
                yield target + distance * np.array([[cosine, -sine], [sine, cosine]]) @ outward

    def _is_free(self, text: Text, leader: np.ndarray) -> bool:
        if touches(text, self._taken) or are_inside(text.center[None], self._outlines)[0]:
            return False
        return not any(touches(other, (leader[:-1], leader[1:])) for other in self._texts)


def _leader(text: Text, target: np.ndarray) -> np.ndarray:
    """(3,2) from the target to the nearer end of the line below the text, and along that."""
    half, below = text_width(text.lines[0], text.height) / 2, text.height / 2 + 2 * CLEAR
    side = 1 if target[0] > text.center[0] else -1
    return np.array([target, text.center + (side * half, -below), text.center - (side * half, below)])
