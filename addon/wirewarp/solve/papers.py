# SPDX-License-Identifier: GPL-3.0-or-later
"""Papers, by the names of makers and of the library."""

PAPERS = {
    "A4": ("a4", "A4"),
    "LETTER": ("letter", "Letter"),
    "A4_LETTER": ("a4-letter", "A4 or Letter"),
    "A3": ("a3", "A3"),
    "TABLOID": ("tabloid", "Tabloid"),
    "A0": ("a0", "A0"),
    "ROLL_36": ("36in", "Roll of 36 in"),
    "ROLL_24": ("24in", "Roll of 24 in"),
    "ROLL": ("", "Roll of another width"),
    "PROJECTOR": ("projector", "Projector"),
}
ONE_PAGE = "PROJECTOR"


def library_paper(paper: str, roll_width: float) -> str | float:
    """paper: a key of PAPERS; roll_width: of "ROLL", in millimeters."""
    return roll_width if paper == "ROLL" else PAPERS[paper][0]


def is_roll(paper: str) -> bool:
    return paper.startswith("ROLL")
