# SPDX-License-Identifier: GPL-3.0-or-later
"""What is said of a side that is longer than what it is sewn to."""

from ..words import LengthText
from .rows import EasedSide

GATHERED = 0.15  # more than this no cloth is eased in without pleats: it is gathered


def longer_text(side: EasedSide, units: LengthText) -> str:
    """ "Sleeve 12 mm longer, ease between notches"; of a shorter side "Cuff 12 mm shorter, stretch between notches"."""
    if side.ease < 0:
        what, how = "shorter", "stretch"
    else:
        what, how = "longer", "ease" if side.ease <= GATHERED else "gather"
    return f"{side.label} {units.rough(abs(side.length))} {what}, {how} between notches"
