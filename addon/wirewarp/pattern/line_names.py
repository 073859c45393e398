# SPDX-License-Identifier: GPL-3.0-or-later
"""Names along the lines: on paper, too, the sides that are sewn together have one number."""

import math
from collections.abc import Iterable, Iterator

import numpy as np

from .notches import NOTCH, vertices_at_wires
from .outlines import FlatPieces, OutlineEdges
from .pattern import PatternWire, PieceText
from .piece_texts import LETTER, LINE
from .polygons import Segments, are_inside
from .seam_sides import SeamSide

HEIGHTS = (4.5, 3.5, 2.5)  # of the letters, in millimeters; where none fits, the line goes without a name
BESIDE = 0.75  # from a line to the letters
ALONG_SEAM = (0.5, 0.4, 0.6, 0.3, 0.7)  # of its length: where no wire ends, the first best
ROOM = 20.0  # from a wire's end
ALONG_WIRE = (0.3, 0.7, 0.4, 0.6, 0.2, 0.8, 0.5)  # wires often cross in their middles
CLEAR = 0.5  # millimeters between a text and what stands beside it
STROKES = np.linspace(-0.5, 0.5, 5)  # a text as level strokes, too close for another text to lie between them


class Room:
    """Of one piece. Lines may be written over where there is no other place; cut lines and texts never."""

    def __init__(self, outlines: Iterable[np.ndarray], lines: Iterable[np.ndarray], texts: Iterable[PieceText]) -> None:
        """outlines (k,2), closed; lines (k,2): wires and notches."""
        self._outline = _joined([_segments(np.concatenate([outline, outline[:1]])) for outline in outlines])
        self._lines = _joined([_segments(line) for line in lines])
        self._texts = _joined([_strokes(text) for text in texts])

    def take(self, choices: Iterable[PieceText]) -> PieceText | None:
        """The first of the texts that fits, and from now on its place is taken; None where none does."""
        found = None
        for text in filter(self._is_inside, choices):
            is_clear = not _touches(text, self._lines)
            found = text if is_clear or not found else found
            if is_clear:
                break
        if found:
            self._texts = _joined([self._texts, _strokes(found)])
        return found

    def _is_inside(self, text: PieceText) -> bool:
        if _touches(text, self._texts) or _touches(text, self._outline):
            return False
        return bool(are_inside(text.center[None], self._outline)[0])


def text_width(text: str, height: float) -> float:
    return LETTER * height * len(text)


def _segments(line: np.ndarray) -> Segments:
    return Segments(line[:-1], line[1:])


def _joined(parts: list[Segments]) -> Segments:
    """One set of segments; at least an empty one."""
    return Segments(*(np.concatenate([np.empty((0, 2)), *(part[end] for part in parts)]) for end in (0, 1)))


def _axes(text: PieceText) -> np.ndarray:
    """(2,2) unit vectors along the line and up the letters, one a column."""
    cosine, sine = math.cos(math.radians(text.angle)), math.sin(math.radians(text.angle))
    return np.array([[cosine, -sine], [sine, cosine]])


def _strokes(text: PieceText) -> Segments:
    strokes = []
    for number, line in enumerate(text.lines):
        middle = LINE * ((len(text.lines) - 1) / 2 - number)
        y = text.height * (middle + STROKES)
        x = np.full(len(y), text_width(line, text.height) / 2)
        strokes.append(Segments(*(np.column_stack([side, y]) @ _axes(text).T + text.center for side in (-x, x))))
    return _joined(strokes)


def _touches(text: PieceText, segments: Segments) -> bool:
    """Whether one of the segments meets the box of a text of one line: no axis separates the two."""
    half = np.array([text_width(text.lines[0], text.height), text.height]) / 2 + CLEAR
    a, b = ((ends - text.center) @ _axes(text) for ends in segments)
    apart = np.any((np.minimum(a, b) > half) | (np.maximum(a, b) < -half), axis=1)
    normal = (b - a)[:, ::-1] * (-1, 1)
    beside = np.abs((normal * a).sum(axis=1)) > np.abs(normal) @ half
    return bool(np.any(~apart & ~beside))


def seam_names(
    flat: FlatPieces, outline: OutlineEdges, seams: list[list[list[SeamSide]]], rooms: dict[int, Room]
) -> dict[int, list[PieceText]]:
    """By piece, at the same place of all sides of each run of a seam: its number, and "Seam" where there is room.

    seams: of each its runs, of each run the sides; rooms: by piece, of those that are wanted.
    """
    at_wires = vertices_at_wires(flat, outline)
    names: dict[int, list[PieceText]] = {}
    for number, seam in enumerate(seams, start=1):
        for sides in seam:
            shares = _shares(flat, sides, at_wires)
            for side in [side for side in sides if side.piece in rooms]:
                name = rooms[side.piece].take(_on_side(flat, outline, side, number, shares))
                if name:
                    names.setdefault(side.piece, []).append(name)
    return names


def _shares(flat: FlatPieces, sides: list[SeamSide], at_wires: set[int]) -> list[float]:
    """Where along the seam its name may stand, the best first."""
    if not sides:
        return []
    along = sides[0].lengths(flat)
    ends = [along[place] for place, vertex in enumerate(sides[0].vertices) if vertex in at_wires]
    return sorted(ALONG_SEAM, key=lambda share: -min([ROOM, *(abs(end - share * along[-1]) for end in ends)]))


def _on_side(
    flat: FlatPieces, outline: OutlineEdges, side: SeamSide, number: int, shares: list[float]
) -> Iterator[PieceText]:
    """Beyond the notches, or between them."""
    along = side.lengths(flat)
    for height in HEIGHTS:
        long = f"Seam {number}"
        text = long if text_width(long, height) <= along[-1] / 2 else str(number)
        for distance in (NOTCH + BESIDE, BESIDE):
            for share in shares:
                point, direction, row = _place(flat.vertices[side.vertices], along, share)
                center = point + (distance + height / 2) * outline.inward[side.edges[row]]
                yield PieceText((text,), center, height, _angle(direction))


def wire_name(wire: PatternWire, room: Room) -> PieceText | None:
    """Beside the line; None where the name is longer than the wire, or the piece too narrow for it."""
    along = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(wire.points, axis=0), axis=1))])
    return room.take(
        _beside(wire, along, share, height, side)
        for height in HEIGHTS
        if text_width(wire.name, height) <= along[-1]
        for share in ALONG_WIRE
        for side in (1, -1)
    )


def _beside(wire: PatternWire, along: np.ndarray, share: float, height: float, side: int) -> PieceText:
    """side: 1 above the line, -1 below it."""
    point, direction, _ = _place(wire.points, along, share)
    angle = _angle(direction)
    above = np.array([-math.sin(math.radians(angle)), math.cos(math.radians(angle))])
    return PieceText((wire.name,), point + side * (BESIDE + height / 2) * above, height, angle)


def _place(points: np.ndarray, along: np.ndarray, share: float) -> tuple[np.ndarray, np.ndarray, int]:
    """Of a line: the point at this share of its length, the direction there, and the row of its step there."""
    length = share * along[-1]
    row = int(np.searchsorted(along, length, side="right")) - 1
    a, b = points[row : row + 2]
    return a + (b - a) * (length - along[row]) / (along[row + 1] - along[row]), b - a, row


def _angle(direction: np.ndarray) -> float:
    """Degrees counterclockwise, over -90 to 90, so that the text is not upside down."""
    angle = math.degrees(math.atan2(direction[1], direction[0]))
    return angle - 180 if angle > 90 else angle + 180 if angle <= -90 else angle
