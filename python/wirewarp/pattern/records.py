# SPDX-License-Identifier: GPL-3.0-or-later
"""What a pattern says besides its pieces: how long the sides of seams are, and what was written."""

from dataclasses import dataclass
from pathlib import Path

from .units import counted


@dataclass(frozen=True)
class SeamWalk:
    """The sides of a seam, as one walks them with a tape."""

    name: str
    pieces: tuple[str, ...]  # of each side the piece
    lengths: tuple[float, ...]  # millimeters along the sew line
    allowances: tuple[tuple[float, ...], ...]  # of each side the widths, millimeters
    notches: tuple[tuple[float, ...], ...]  # of each side where they stand, millimeters from the same end of the seam


@dataclass(frozen=True)
class Written:
    """What was written, and read again. As a text: "8 pieces on 23 sheets, read again: 0.00 mm off"."""

    path: Path
    sheets: int  # of PDF the pages; 1 of other files
    pieces: int
    off: float  # millimeters from the worst point in the file to where it should be
    warnings: list[str]  # sentences

    def __str__(self) -> str:
        what = f"{counted(self.pieces, 'piece')} on {counted(self.sheets, 'sheet')}"
        return f"{what}, read again: {self.off:.2f} mm off"
