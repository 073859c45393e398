# SPDX-License-Identifier: GPL-3.0-or-later
"""Places texts beside a piece without room for them, each with a leader line to the place it names.

Texts are so near to the piece that the pattern needs no more pages.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ..geometry import are_inside, distances_to, sampled
from ..model import LEADERS, Line, Text
from ..pattern_data import GAP, OVERLAP
from .room import CLEAR, axes, joined, strokes, touches
from .text_place import text_width

# The distances tried between the named line and the middle of the text, in millimeters, increase by STEP. At the least
# distance, the smallest text, 2.5 mm high, keeps CLEAR from the line.
NEAREST, FARTHEST, STEP = 2.0, 40.0, 0.5
TURNS = (0, 30, -30, 60, -60, 90, -90, 135, -135, 180)  # degrees; 0 is straight out of the piece; best turn first
# These angles of the text, in degrees, are tried in this order, the easiest to read first. Turned text stays close to a
# narrow piece.
ANGLES = (0.0, 90.0, 45.0, -45.0)
# A text is at most this far from the box of the cutting lines, in millimeters, so that texts of two pieces do not meet.
REACH = GAP / 2
# A text is at most this far from the cutting lines, in millimeters. Sheets overlap by more, so the text is on the sheet
# of the piece.
NEAR = OVERLAP - STEP


class Box(NamedTuple):
    low: np.ndarray  # (2,)
    high: np.ndarray  # (2,)


class Beside:
    """The free places around one piece."""

    def __init__(
        self, outlines: Sequence[np.ndarray], sheets: Sequence[Box] = (), others: Sequence[np.ndarray] = ()
    ) -> None:
        """Begin without texts.

        - outlines (k,2): cutting lines of the piece
        - sheets: if there are any, each text must be on one sheet
        - others (k,2): closed lines around neighbors
        """
        self._sheets, self._others = sheets, others
        self._outlines = list(outlines)
        points = np.concatenate(self._outlines)
        self._low, self._high = points.min(axis=0) - REACH, points.max(axis=0) + REACH
        self._taken = joined([(line, np.roll(line, -1, axis=0)) for line in (*self._outlines, *others)])
        self._texts: list[Text] = []

    def lead(self, texts: Iterable[Text], outward: np.ndarray) -> tuple[Text, Line] | None:
        """Return the first text with a place outside the piece, and its leader line. Return None if no place near the
        piece is free.

        - texts: alternative texts, each centered at the place that it names
        - outward (2,): preferred direction, a unit vector
        """
        for placed, points in self._choices(texts, outward):
            if self._is_free(placed, points) and self._is_near(placed, points):
                self._texts.append(placed)
                self._taken = joined([self._taken, strokes(placed), (points[:-1], points[1:])])
                return placed, Line(LEADERS[placed.role], points)
        return None  # a long leader line could be taken for a line of the piece

    def _choices(self, texts: Iterable[Text], outward: np.ndarray) -> Iterator[tuple[Text, np.ndarray]]:
        """Yield each text at each place within reach, with its leader line (3,2), the best first."""
        for text in texts:
            centers = self._centers(text.center, outward)
            for angle in ANGLES:
                placed = Text(text.lines, np.zeros(2), text.height, angle, text.role, is_beside=True)
                leaders = _leaders(placed, centers, text.center)
                points = np.concatenate([centers[:, None] + np.concatenate(strokes(placed)), leaders], axis=1)
                within = np.all((points >= self._low) & (points <= self._high), axis=(1, 2))
                for row in np.flatnonzero(within):
                    yield replace(placed, center=centers[row]), leaders[row]

    def _centers(self, target: np.ndarray, outward: np.ndarray) -> np.ndarray:
        """Return the centers (c,2) of texts to try around the target, the nearest first."""
        nearest = max(NEAREST, float(distances_to(target[None], self._outlines)[0]))
        cosines, sines = np.cos(np.radians(TURNS)), np.sin(np.radians(TURNS))
        ways = np.array([[cosines, -sines], [sines, cosines]]).transpose(2, 0, 1) @ outward
        around: np.ndarray = target + np.arange(nearest, FARTHEST, STEP)[:, None, None] * ways
        return around.reshape(-1, 2)

    def _is_free(self, text: Text, leader: np.ndarray) -> bool:
        over_line = replace(text, center=(leader[1:].mean(axis=0) + text.center) / 2)
        if touches(text, self._taken) or touches(over_line, self._taken):
            return False
        if are_inside(text.center[None], [*self._outlines, *self._others])[0] or touches(
            text, (leader[:1], leader[1:2])
        ):
            return False
        return not any(touches(other, (leader[:-1], leader[1:])) for other in self._texts)

    def _is_near(self, text: Text, leader: np.ndarray) -> bool:
        """Return whether the text and its leader line are near the piece and on one sheet."""
        first, last = strokes(text)
        edges = [np.array([first[row], last[row]]) for row in (0, -1)]
        points = np.concatenate([sampled(line, STEP) for line in (leader, *edges)])
        if self._sheets and not any(np.all((points > box.low) & (points < box.high)) for box in self._sheets):
            return False
        outside = points[~are_inside(points, self._outlines)]
        return bool(np.all(distances_to(outside, self._outlines) < NEAR))


def _leaders(text: Text, centers: np.ndarray, target: np.ndarray) -> np.ndarray:
    """Return a leader line (3,2) for each center (c,2) of the text.

    Each line ends along the top or bottom edge of the text, so it does not cross the letters.
    """
    sides = np.where((target - centers) @ axes(text) > 0, 1, -1)
    along, up = (sides[:, [side]] * axes(text)[:, side] for side in (0, 1))
    edges = centers + (text.height / 2 + 2 * CLEAR) * up
    halves = text_width(text.lines[0], text.height) / 2 * along
    return np.stack([np.broadcast_to(target, centers.shape), edges + halves, edges - halves], axis=1)
