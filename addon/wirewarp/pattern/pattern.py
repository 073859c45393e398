# SPDX-License-Identifier: GPL-3.0-or-later
"""What a pattern consists of, whatever it is written to. Everything is in millimeters, y upwards."""

from dataclasses import dataclass

import numpy as np

from .polygons import Segments, overlap


@dataclass(frozen=True)
class PatternWire:
    name: str
    kind: str  # "rigid", "elastic" or "free"
    points: np.ndarray  # (k,2); a closed wire repeats its first point


@dataclass(frozen=True)
class Notch:
    """A mark on the outline where the other side of a seam, or a wire, meets it."""

    point: np.ndarray  # (2,)
    inward: np.ndarray  # (2,) unit vector, into the piece
    length: float
    kind: str  # "wire": a wire ends here; "seam": at a measured length along the seam

    @property
    def line(self) -> np.ndarray:
        """(2,2) from the outline to the end of the notch."""
        return np.array([self.point, self.point + self.length * self.inward])


@dataclass(frozen=True)
class PieceText:
    lines: tuple[str, ...]
    center: np.ndarray  # (2,), inside the piece
    height: float  # of a line's letters
    angle: float  # degrees counterclockwise; of the piece's own text 0, or 90 where the piece is narrow


@dataclass(frozen=True)
class PatternPiece:
    name: str
    outlines: list[np.ndarray]  # (k,2) each, closed without repeating the first point; holes too
    wires: list[PatternWire]
    notches: list[Notch]
    text: PieceText
    line_names: list[PieceText]  # of seams and wires

    @property
    def size(self) -> np.ndarray:
        """Width and height."""
        low, high = bounds(self.outlines)
        return high - low


@dataclass(frozen=True)
class Ruler:
    """The square to measure after printing."""

    side: float
    text: str


INCH = 25.4
METRIC, IMPERIAL = Ruler(100.0, "100 mm"), Ruler(4 * INCH, "4 in")


@dataclass(frozen=True)
class Pattern:
    title: str
    pieces: list[PatternPiece]
    ruler: Ruler

    @property
    def bounds(self) -> tuple[np.ndarray, np.ndarray]:
        """The lowest and the highest corner."""
        return bounds([outline for piece in self.pieces for outline in piece.outlines])

    @property
    def largest(self) -> PatternPiece:
        """By the area of its box: what a sheet must have room for."""
        return max(self.pieces, key=lambda piece: float(np.prod(piece.size)))


def pieces_over_others(pattern: Pattern) -> list[str]:
    """The names of the pieces that lie over one another, as they were put by hand."""
    lines = [_segments(piece.outlines) for piece in pattern.pieces]
    low, high = np.array([line.box for line in lines]).transpose(1, 0, 2)
    meet = np.triu(np.all((low[:, None] < high) & (low < high[:, None]), axis=2), 1)
    pairs = [(first, second) for first, second in np.argwhere(meet).tolist() if overlap(lines[first], lines[second])]
    return [pattern.pieces[index].name for index in sorted({index for pair in pairs for index in pair})]


def _segments(outlines: list[np.ndarray]) -> Segments:
    return Segments(np.concatenate(outlines), np.concatenate([np.roll(outline, -1, axis=0) for outline in outlines]))


def bounds(outlines: list[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    points = np.concatenate(outlines)
    return points.min(axis=0), points.max(axis=0)
