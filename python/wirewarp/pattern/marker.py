# SPDX-License-Identifier: GPL-3.0-or-later
"""A marker: where the pieces of a pattern lie on the cloth. It is kept, for a search never ends the same way twice."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from .geometry import Motion
from .model import PatternPiece
from .units import UnitSystem, counted

SAME = 0.1  # millimeters: by which outlines may differ from those that a marker was made of
SHEETS_APART = 50.0  # millimeters between sheets, where they are drawn one above the other


@dataclass(frozen=True)
class Size:
    """Of the cut lines of a piece, whatever texts stand beside it. Lengths are in millimeters."""

    piece: int  # its number
    width: float
    height: float
    area: float
    x: float  # of the centroid, from the lower left corner: another where the piece was turned or mirrored since
    y: float

    def is_like(self, other: "Size") -> bool:
        """As where the outline is nowhere farther off than SAME."""
        lengths = (self.width - other.width, self.height - other.height, self.x - other.x, self.y - other.y)
        is_same_area = abs(self.area - other.area) <= SAME * 2 * (self.width + self.height)
        return self.piece == other.piece and is_same_area and max(map(abs, lengths)) <= 2 * SAME


def size_of(piece: PatternPiece) -> Size:
    width, height = piece.size.tolist()
    area, moments = 0.0, np.zeros(2)
    for line in at_corner(piece).of_role("cut"):
        a, b = line.points, np.roll(line.points, -1, axis=0)
        doubled = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]  # areas of the triangles with the corner
        doubled *= np.sign(doubled.sum())
        area += float(doubled.sum()) / 2
        moments += doubled @ (a + b) / 6
    return Size(piece.number, width, height, area, *(moments / area).tolist())


def at_corner(piece: PatternPiece) -> PatternPiece:
    """With the lower left corner of its cut lines at 0, 0: what a marker says holds wherever pieces lie."""
    return piece.moved(-piece.bounds[0])


@dataclass(frozen=True)
class Placement:
    """Of one copy of a piece, whose cut lines have their lower left corner at its origin."""

    piece: int  # its number
    x: float  # across the cloth, millimeters: where the origin of the piece comes to lie
    y: float  # along the cloth
    angle: float  # degrees counterclockwise
    mirrored: bool  # before it is turned
    sheet: int = 0  # always 0 on a roll


@dataclass(frozen=True)
class Marker:
    """Lengths are in millimeters, x across the cloth and y along it, from its lower left corner."""

    width: float  # of the cloth, as far as it can be used
    length: float  # that is used: of the roll, or of the last sheet
    sheet_length: float | None  # None on a roll
    gap: float  # at least, between pieces
    placements: tuple[Placement, ...]
    efficiency: float  # the share of the cloth that becomes pieces, of sheets the whole ones
    by: str  # what found it: "spyrrow", or "slides" where that is not installed or found nothing shorter
    made_of: tuple[Size, ...]  # in the order of the pattern
    warnings: tuple[str, ...] = ()

    @property
    def sheets(self) -> int:
        return 1 + max(placement.sheet for placement in self.placements)

    def is_of(self, pieces: Sequence[PatternPiece]) -> bool:
        """Whether it was made of pieces like these, none of them half, on the fold."""
        sizes = [size_of(piece) for piece in pieces]
        return len(sizes) == len(self.made_of) and all(map(Size.is_like, sizes, self.made_of))

    def motion(self, placement: Placement) -> Motion:
        """To the place in one drawing, sheets above each other."""
        above = 0.0 if self.sheet_length is None else placement.sheet * (self.sheet_length + SHEETS_APART)
        return Motion(np.array([placement.x, placement.y + above]), placement.angle, placement.mirrored)

    def sentence(self, units: UnitSystem) -> str:
        """ "12 pieces on 2.31 m of cloth 1.4 m wide, 71% of it used"."""
        pieces, width = counted(len(self.placements), "piece"), units.text(self.width)
        if self.sheet_length is None:
            where = f"{units.text(self.length)} of cloth {width} wide"
        else:
            where = f"{counted(self.sheets, 'sheet')} of {width} x {units.text(self.sheet_length)}"
        return f"{pieces} on {where}, {100 * self.efficiency:.0f}% of it used"

    def to_dict(self) -> dict[str, Any]:
        """All fields as plain, JSON-able values."""
        return asdict(self)

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> "Marker":
        """Of to_dict(), from JSON or elsewhere. Raises KeyError or TypeError for what is none."""
        fields = dict(values)
        fields["placements"] = tuple(Placement(**each) for each in fields["placements"])
        fields["made_of"] = tuple(Size(**each) for each in fields["made_of"])
        return cls(**fields | {"warnings": tuple(fields["warnings"])})
