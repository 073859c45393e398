# SPDX-License-Identifier: GPL-3.0-or-later
"""Defines the data of a pattern, from which every file and drawing is made."""

import math
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal, Self

import numpy as np

from ..report.words import counted
from .checks import problem
from .geometry import Motion
from .marker import Marker
from .model import KINDS, PatternPiece
from .units import UnitSystem

GAP = 10.0  # millimeters between pieces in rows, with room for texts beside both: see REACH in label/leaders.py
OVERLAP = 10.0  # millimeters that neighboring sheets share, to glue or tape


@dataclass(frozen=True)
class SeamWalk:
    """The sides of a seam, with their lengths measured along the stitching lines."""

    name: str
    pieces: tuple[str, ...]  # for each side, the name of its piece
    lengths: tuple[float, ...]  # length of each side, millimeters
    allowances: tuple[tuple[float, ...], ...]  # widths of the allowance of each side, millimeters
    notches: tuple[tuple[float, ...], ...]  # notches of each side, millimeters from the same end of the seam


StepKind = Literal["dart", "flat", "ring", "all around", "closing"]


@dataclass(frozen=True)
class SewingStep:
    """A step of sewing: one seam. After a step of the kind "closing", the sewn pieces have no open edge."""

    seam: str
    kind: StepKind
    pieces: tuple[str, ...]  # names of the pieces, each once
    has_gap: bool  # whether an opening for turning is left; it is closed by hand at the end


@dataclass(frozen=True)
class Written:
    """The result of writing a file and reading it again. str() is a text for the maker.

    Example of the text: "8 pieces on 23 sheets, read again: 0.00 mm off".
    """

    path: Path
    sheets: int  # pages of a PDF; 1 for other files
    pieces: int
    off: float  # largest distance in millimeters between a point in the file and its place in the pattern
    warnings: list[str]

    def __str__(self) -> str:
        what = f"{counted(self.pieces, 'piece')} on {counted(self.sheets, 'sheet')}"
        return f"{what}, read again: {self.off:.2f} mm off"


@dataclass(frozen=True)
class PatternData:
    """The data of a pattern. Stitching lines are exactly the flattened outlines; cutting lines are made from them."""

    title: str
    pieces: list[PatternPiece]
    units: UnitSystem
    warnings: list[str] = field(default_factory=list)
    date: str = ""  # text with the date on the pieces
    walks: list[SeamWalk] = field(default_factory=list)  # sides and lengths of each seam, by the index of the seam
    steps: list[SewingStep] = field(default_factory=list)  # in an order in which the seams can be sewn
    measures: list[tuple[str, float]] = field(default_factory=list)  # names and finished lengths in millimeters
    marker: Marker | None = None  # the marker that is drawn; with a marker, `pieces` has each copy of a piece

    @property
    def allowance_text(self) -> str:
        """Return the widths of the allowances as a text, such as "10 mm", "10 mm to 30 mm" or "none"."""
        return self.units.range_of([width for piece in self.pieces for width in piece.allowances])

    @property
    def heading(self) -> str:
        """Return the text with title and date, which is written on every piece."""
        return ", ".join(filter(None, [self.title.strip(), self.date.strip()]))

    @property
    def bounds(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the lowest and the highest corner (2,) of all pieces in their places."""
        boxes = np.array([piece.bounds for piece in self.pieces])
        return boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)

    @property
    def size(self) -> np.ndarray:
        """Return width and height (2,) of all pieces together, in their places."""
        return self.bounds[1] - self.bounds[0]

    def arranged(self, width: float = math.inf) -> Self:
        """Return the pattern with its pieces in rows on a sheet of this width, with the lower left corner at 0, 0.

        Without a width, the sheet is about square.
        """
        return self.with_corners(in_rows(np.array([piece.size for piece in self.pieces]), width))

    def at_origin(self) -> Self:
        """Return the pattern, moved so that its lower left corner is at 0, 0."""
        return self.placed(Motion(-self.bounds[0]))

    def with_corners(self, corners: np.ndarray) -> Self:
        """Return the pattern with each piece moved. corners (p,2): new lower left corner of each piece."""
        moved = [piece.moved(to - piece.bounds[0]) for piece, to in zip(self.pieces, corners, strict=True)]
        return replace(self, pieces=moved)

    def placed(self, motion: Motion) -> Self:
        return replace(self, pieces=[piece.placed(motion) for piece in self.pieces])

    def with_only(self, kinds: Iterable[str]) -> Self:
        """Return the pattern with cutting lines, folds, and only these kinds of other lines, marks and texts.

        kinds: some of "sew", "wires", "grain", "notches", "texts", "line names". Raises FlattenError for other kinds.
        """
        wanted = set(kinds)
        if not wanted <= set(KINDS):
            raise problem(f"kinds has {min(wanted - set(KINDS))!r}: give {', '.join(map(repr, KINDS))}.")
        kept = {"cut", "inner_cut", "fold", *(role for kind in wanted for role in KINDS[kind])}
        return replace(self, pieces=[piece.with_only(kept) for piece in self.pieces])


def in_rows(sizes: np.ndarray, width: float = math.inf) -> np.ndarray:
    """Return the lower left corners (p,2) of boxes of these sizes (p,2), in rows from 0, 0.

    width: width of the sheet; if infinite, the sheet is about square. A box wider than the sheet has its own row.
    """
    if math.isinf(width):
        width = max(math.sqrt(float(np.prod(sizes + GAP, axis=1).sum())) * 1.1, float(sizes[:, 0].max()))
    order = sorted(range(len(sizes)), key=lambda row: (-sizes[row, 1], -sizes[row, 0], row))
    corners = np.zeros_like(sizes)
    x = y = height = 0.0
    for row in order:
        if x > 0 and x + sizes[row, 0] > width + 1e-9:
            x, y, height = 0.0, y + height + GAP, 0.0
        corners[row] = x, y
        x, height = x + sizes[row, 0] + GAP, max(height, sizes[row, 1])
    return corners
