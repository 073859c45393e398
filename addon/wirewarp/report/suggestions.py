# SPDX-License-Identifier: GPL-3.0-or-later
"""Suggested cuts in words."""

from ..solve.suggest import Cut
from ..words import LengthText, counted
from .cloth import percent_text

WORDS = {"DARTS": ("dart", "darts"), "SEAMS": ("seam", "seams")}


def found_words(kind: str, cuts: list[Cut]) -> str:
    """ "1 dart", "3 seams", "2 sets of seams"."""
    if cuts[0].is_first:
        return counted(len(cuts), "set of seams", "sets of seams")
    return counted(sum(len(cut.lengths) for cut in cuts), *WORDS[kind])


def cut_text(cut: Cut, text: LengthText) -> str:
    """ "stretch 12 → 6.0%, 140 mm", of mirror images "2×140 mm": it fits a button in a narrow sidebar.

    Of first cuts "stretch 6.0%, 1.40 m".
    """
    times = f"{len(cut.lengths)}×" if len(cut.lengths) > 1 else ""
    before = "" if cut.is_first else f"{percent_text(cut.strain_before).removesuffix('%')} → "
    return f"stretch {before}{percent_text(cut.strain)}, {times}{text.rough(cut.lengths[0])}"
