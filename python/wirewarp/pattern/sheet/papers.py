# SPDX-License-Identifier: GPL-3.0-or-later
"""Papers for patterns, by their usual names."""

from dataclasses import dataclass

import numpy as np

from ..checks import checked_length, problem
from ..units import INCH

SHEETS = {
    "a4": (210.0, 297.0),
    "letter": (8.5 * INCH, 11 * INCH),
    "a4-letter": (210.0, 11 * INCH),  # fits on both
    "a3": (297.0, 420.0),
    "tabloid": (11 * INCH, 17 * INCH),
    "a0": (841.0, 1189.0),
}
ROLLS = {"36in": 36 * INCH, "24in": 24 * INCH}
PROJECTOR = "projector"
LONGEST = 5000.0  # millimeters: PDF viewers support pages up to 5.08 m
MARGIN = 10.0  # few printers print nearer to the edge of a sheet


@dataclass(frozen=True)
class Page:
    """A page of a file to print, and its part of the pattern. Lengths are in millimeters."""

    name: str  # "A1" for sheets to tape together, otherwise its number
    low: np.ndarray  # (2,) lower left corner
    size: np.ndarray  # (2,) width and height; for sheets without their margins


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
        if paper in ROLLS:
            return ROLLS[paper]
        if paper in SHEETS or paper == PROJECTOR:
            return None
        known = ", ".join([*SHEETS, *ROLLS, PROJECTOR])
        raise problem(f"paper is {paper!r}: give one of {known}, or the width of a roll in millimeters.")
    return checked_length("paper, the width of a roll,", paper, 100.0, LONGEST)
