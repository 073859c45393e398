# SPDX-License-Identifier: GPL-3.0-or-later
"""Papers for patterns, by their usual names."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..checks import checked_length, problem
from ..units import INCH


class Paper(NamedTuple):
    """A kind of paper. Lengths are in millimeters."""

    label: str
    width: float | None = None  # width of an upright sheet, or of a roll; None: as wide as the pattern
    height: float | None = None  # height of an upright sheet


PROJECTOR = "projector"
PAPERS = {
    "a4": Paper("A4", 210.0, 297.0),
    "letter": Paper("Letter", 8.5 * INCH, 11 * INCH),
    "a4-letter": Paper("A4 or Letter", 210.0, 11 * INCH),  # fits on both papers
    "a3": Paper("A3", 297.0, 420.0),
    "tabloid": Paper("Tabloid", 11 * INCH, 17 * INCH),
    "a0": Paper("A0", 841.0, 1189.0),
    "36in": Paper("Roll of 36 in", 36 * INCH),
    "24in": Paper("Roll of 24 in", 24 * INCH),
    PROJECTOR: Paper("Projector"),
}
SHEETS = {name: (paper.width, paper.height) for name, paper in PAPERS.items() if paper.width and paper.height}
LONGEST = 5000.0  # millimeters; PDF viewers support pages up to 5.08 m
MARGIN = 10.0  # few printers print nearer to the edge of a sheet


@dataclass(frozen=True)
class Page:
    """A page of a file to print, and its part of the pattern. Lengths are in millimeters."""

    name: str  # "A1" for sheets to tape together, otherwise its number
    low: np.ndarray  # (2,) lower left corner
    size: np.ndarray  # (2,) width and height; of sheets, without the margins


def sheet_name(row: int, column: int) -> str:
    """Return the name of a sheet: "A1" is the first one of the top row; row AA follows row Z."""
    letters = ""
    row += 1
    while row:
        row, letter = divmod(row - 1, 26)
        letters = chr(ord("A") + letter) + letters
    return f"{letters}{column + 1}"


def roll_width(paper: str | float) -> float | None:
    """Return millimeters, or None if the paper is not a roll. Raises FlattenError for an unknown paper."""
    if isinstance(paper, str):
        if paper not in PAPERS:
            known = ", ".join(PAPERS)
            raise problem(f"paper is {paper!r}: give one of {known}, or the width of a roll in millimeters.")
        return None if paper in SHEETS else PAPERS[paper].width
    return checked_length("paper, the width of a roll,", paper, 100.0, LONGEST)
