# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists papers for patterns by their usual names."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..checks import checked_length, problem
from ..units import INCH


class Paper(NamedTuple):
    """A kind of paper. Lengths are in millimeters."""

    label: str
    width: float | None = None  # width of an upright sheet or a roll; None: as wide as the pattern
    height: float | None = None  # height of an upright sheet; None for rolls and projectors


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
LONGEST = 5000.0  # millimeters: longest page; PDF viewers support pages up to 5.08 m
MARGIN = 10.0  # millimeters; almost every printer can print this near to the edge of a sheet


@dataclass(frozen=True)
class Page:
    """A page of a file to print, and the part of the pattern that it shows. Lengths are in millimeters."""

    name: str  # a name such as "A1" for sheets to tape together, otherwise the number of the page
    low: np.ndarray  # (2,) lower left corner of the shown part, in the pattern
    size: np.ndarray  # (2,) width and height of the shown part; sheets have margins around it


def sheet_name(row: int, column: int) -> str:
    """Return the name of a sheet, such as "A1" for the first sheet of the top row. Row AA follows row Z."""
    letters = ""
    row += 1
    while row:
        row, letter = divmod(row - 1, 26)
        letters = chr(ord("A") + letter) + letters
    return f"{letters}{column + 1}"


def roll_width(paper: str | float) -> float | None:
    """Return the width of a roll in millimeters; None for other papers. Raises FlattenError for an unknown paper."""
    if isinstance(paper, str):
        if paper not in PAPERS:
            known = ", ".join(PAPERS)
            raise problem(f"paper is {paper!r}: give one of {known}, or the width of a roll in millimeters.")
        return None if paper in SHEETS else PAPERS[paper].width
    return checked_length("paper, the width of a roll,", paper, 100.0, LONGEST)
