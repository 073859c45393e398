# SPDX-License-Identifier: GPL-3.0-or-later
"""Defines markers. A marker contains the places of a pattern's pieces on the fabric. Save it, because another search
finds other places."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from ..report.words import counted
from .geometry import Motion
from .model import PatternPiece
from .units import UnitSystem

SAME = 0.1  # millimeters by which outlines may differ from the outlines for which the marker was made
SHEETS_APART = 50.0  # millimeters between sheets that are drawn one above the other


@dataclass(frozen=True)
class Size:
    """Size of the cutting lines of a piece, without texts beside the piece. Lengths are in millimeters."""

    piece: int  # number of the piece
    width: float
    height: float
    area: float
    x: float  # centroid from the lower left corner; it changes if a piece is turned or mirrored
    y: float

    def is_like(self, other: "Size") -> bool:
        """Return whether both sizes may belong to the same outline, with differences of at most SAME millimeters."""
        lengths = (self.width - other.width, self.height - other.height, self.x - other.x, self.y - other.y)
        is_same_area = abs(self.area - other.area) <= SAME * 2 * (self.width + self.height)
        return self.piece == other.piece and is_same_area and max(map(abs, lengths)) <= 2 * SAME


def size_of(piece: PatternPiece) -> Size:
    width, height = piece.size.tolist()
    area, moments = 0.0, np.zeros(2)
    for line in at_corner(piece).of_role("cut"):
        a, b = line.points, np.roll(line.points, -1, axis=0)
        doubled = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]  # doubled areas of the triangles from the origin to each side
        doubled *= np.sign(doubled.sum())
        area += float(doubled.sum()) / 2
        moments += doubled @ (a + b) / 6
    return Size(piece.number, width, height, area, *(moments / area).tolist())


def at_corner(piece: PatternPiece) -> PatternPiece:
    """Return the piece with the lower left corner of its cutting lines at 0, 0, the origin in a marker."""
    return piece.moved(-piece.bounds[0])


@dataclass(frozen=True)
class Placement:
    """Place of one copy of a piece. The origin of a piece is the lower left corner of its cutting lines, as drawn."""

    piece: int  # number of the piece
    x: float  # across the fabric, millimeters: place of the origin of the piece from the corner of the fabric
    y: float  # along the fabric, millimeters
    angle: float  # degrees counterclockwise
    mirrored: bool  # whether the piece is mirrored, before it is turned
    sheet: int = 0  # index of the sheet; always 0 on a roll


@dataclass(frozen=True)
class Marker:
    """Places of the pieces of a pattern on the fabric. Lengths are in millimeters.

    x is across the fabric and y along it, from the lower left corner of the fabric or sheet.
    """

    width: float  # usable width of the fabric
    length: float  # used length of the roll, or of the last sheet
    sheet_length: float | None  # None for a roll
    gap: float  # smallest distance between pieces
    placements: tuple[Placement, ...]
    efficiency: float  # share of the fabric that becomes pieces; the last sheet counts as a whole
    by: str  # the search that found the marker: "slides", or "spyrrow" (only for rolls)
    made_of: tuple[Size, ...]  # sizes of the pieces, in the order of the pattern
    warnings: tuple[str, ...] = ()

    @property
    def sheets(self) -> int:
        return 1 + max(placement.sheet for placement in self.placements)

    def is_of(self, pieces: Sequence[PatternPiece]) -> bool:
        """Return whether the marker was made from pieces with the same sizes. Pieces on the fold must be opened."""
        sizes = [size_of(piece) for piece in pieces]
        return len(sizes) == len(self.made_of) and all(map(Size.is_like, sizes, self.made_of))

    def motion(self, placement: Placement) -> Motion:
        """Return the motion from the piece as drawn to its place in a drawing of all sheets, one above the other."""
        above = 0.0 if self.sheet_length is None else placement.sheet * (self.sheet_length + SHEETS_APART)
        return Motion(np.array([placement.x, placement.y + above]), placement.angle, placement.mirrored)

    def sentence(self, units: UnitSystem) -> str:
        """Return a text such as "12 pieces on 2.31 m of fabric 1.4 m wide, 71% of it used"."""
        pieces, width = counted(len(self.placements), "piece"), units.text(self.width)
        if self.sheet_length is None:
            where = f"{units.text(self.length)} of fabric {width} wide"
        else:
            where = f"{counted(self.sheets, 'sheet')} of {width} x {units.text(self.sheet_length)}"
        return f"{pieces} on {where}, {100 * self.efficiency:.0f}% of it used"

    def to_dict(self) -> dict[str, Any]:
        """Return all fields as plain values that JSON can store."""
        return asdict(self)

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> "Marker":
        """Return the marker from the result of to_dict(). Raises KeyError or TypeError for anything else."""
        fields = dict(values)
        fields["placements"] = tuple(Placement(**each) for each in fields["placements"])
        fields["made_of"] = tuple(Size(**each) for each in fields["made_of"])
        return cls(**fields | {"warnings": tuple(fields["warnings"])})
