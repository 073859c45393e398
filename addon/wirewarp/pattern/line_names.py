# SPDX-License-Identifier: GPL-3.0-or-later
"""Names along the lines: on paper, too, the sides that are sewn together have one number."""

import math

import numpy as np

from .flat_pieces import FlatPieces
from .interior import LETTER
from .notches import vertices_at_wires
from .outlines import OutlineEdges
from .pattern import PatternWire, PieceText
from .seam_sides import SeamFinder, SeamSide

HEIGHT = 4.5  # of the letters, in millimeters
BESIDE_SEAM = 9.0  # from the outline to the middle of the letters: beyond the notches
BESIDE_WIRE = 3.5
ALONG_SEAM = (0.5, 0.4, 0.6, 0.3, 0.7)  # of its length: where no wire ends, the first best
ROOM = 20.0  # from a wire's end
ALONG_WIRE = 0.3  # wires often cross in their middles


def seam_names(flat: FlatPieces, outline: OutlineEdges, seams: list[list]) -> dict[int, list[PieceText]]:
    """By piece, at the same place of all sides of each run of a seam: its number, and "Seam" where there is room."""
    finder, at_wires = SeamFinder(flat, outline), vertices_at_wires(flat, outline)
    names: dict[int, list[PieceText]] = {}
    for number, seam in enumerate(seams, start=1):
        for sides in finder.sides(seam):
            share = _free_share(flat, sides, at_wires)
            for side in sides:
                name = _seam_name(flat, outline, side, number, share)
                names.setdefault(side.piece, []).append(name)
    return names


def _free_share(flat: FlatPieces, sides: list[SeamSide], at_wires: set[int]) -> float:
    if not sides:
        return ALONG_SEAM[0]
    along = sides[0].lengths(flat)
    ends = [along[place] for place, vertex in enumerate(sides[0].vertices) if vertex in at_wires]
    return max(ALONG_SEAM, key=lambda share: min([ROOM, *(abs(end - share * along[-1]) for end in ends)]))


def _seam_name(flat: FlatPieces, outline: OutlineEdges, side: SeamSide, number: int, share: float) -> PieceText:
    along = side.lengths(flat)
    length = share * along[-1]
    row = int(np.searchsorted(along, length, side="right")) - 1
    a, b = flat.vertices[side.vertices[row : row + 2]]
    point = a + (b - a) * (length - along[row]) / (along[row + 1] - along[row])
    long = f"Seam {number}"
    text = long if _width(long) <= along[-1] / 2 else str(number)
    return PieceText((text,), point + BESIDE_SEAM * outline.inward[side.edges[row]], HEIGHT, _angle(b - a))


def wire_name(wire: PatternWire) -> PieceText | None:
    """Beside the line; None where the name is longer than the wire."""
    along = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(wire.points, axis=0), axis=1))])
    if along[-1] < _width(wire.name):
        return None
    row = int(np.searchsorted(along, ALONG_WIRE * along[-1], side="right")) - 1
    a, b = wire.points[row : row + 2]
    point = np.array([np.interp(ALONG_WIRE * along[-1], along, column) for column in wire.points.T])
    angle = _angle(b - a)
    above = np.array([-math.sin(math.radians(angle)), math.cos(math.radians(angle))])
    return PieceText((wire.name,), point + BESIDE_WIRE * above, HEIGHT, angle)


def _width(text: str) -> float:
    return LETTER * HEIGHT * len(text)


def _angle(direction: np.ndarray) -> float:
    """Degrees counterclockwise, over -90 to 90, so that the text is not upside down."""
    angle = math.degrees(math.atan2(direction[1], direction[0]))
    return angle - 180 if angle > 90 else angle + 180 if angle <= -90 else angle
