# SPDX-License-Identifier: GPL-3.0-or-later
"""A marker: where the pieces of a pattern lie on the cloth. It is kept, for a search never ends the same way twice."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from .model import PatternPiece
from .motion import Motion
from .units import UnitSystem, counted

SHEETS_APART = 50.0  # millimeters between sheets, where they are drawn one above the other


@dataclass(frozen=True)
class Placement:
    """Of one copy of a piece, from where it lies in the pattern."""

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
    sizes: tuple[tuple[int, float, float], ...]  # see sizes_of, of the pieces it was made of
    warnings: tuple[str, ...] = ()

    @property
    def sheets(self) -> int:
        return 1 + max(placement.sheet for placement in self.placements)

    def motion(self, placement: Placement) -> Motion:
        """To the place in one drawing, sheets above each other."""
        above = 0.0 if self.sheet_length is None else placement.sheet * (self.sheet_length + SHEETS_APART)
        return Motion(np.array([placement.x, placement.y + above]), placement.angle, placement.mirrored)

    def sentence(self, units: UnitSystem) -> str:
        """ "12 pieces on 2.31 m of cloth 1.4 m wide, 71 % of it used"."""
        pieces, width = counted(len(self.placements), "piece"), units.text(self.width)
        if self.sheet_length is None:
            where = f"{units.text(self.length)} of cloth {width} wide"
        else:
            where = f"{counted(self.sheets, 'sheet')} of {width} x {units.text(self.sheet_length)}"
        return f"{pieces} on {where}, {100 * self.efficiency:.0f} % of it used"

    def to_dict(self) -> dict[str, Any]:
        """All fields as plain, JSON-able values."""
        return asdict(self)

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> "Marker":
        """Of to_dict(), from JSON or elsewhere. Raises KeyError or TypeError for what is none."""
        fields = dict(values)
        fields["placements"] = tuple(Placement(**each) for each in fields["placements"])
        fields["sizes"] = tuple((int(number), float(w), float(h)) for number, w, h in fields["sizes"])
        return cls(**fields | {"warnings": tuple(fields["warnings"])})


def sizes_of(pieces: Sequence[PatternPiece]) -> tuple[tuple[int, float, float], ...]:
    """Number, width and height of each, whatever texts stand beside it."""
    return tuple((piece.number, *map(float, piece.cut_size)) for piece in pieces)
