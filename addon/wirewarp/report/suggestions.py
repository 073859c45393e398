# SPDX-License-Identifier: GPL-3.0-or-later
"""Suggested cuts in words."""

from ..solve.suggest import Cut
from ..words import LengthText, counted
from .cloth import percent_text

WORDS = {"DARTS": ("dart", "darts"), "SEAMS": ("seam", "seams")}


def kind_words(kind: str, count: int) -> str:
    """ "1 dart", "3 seams"."""
    return counted(count, *WORDS[kind])


def cut_text(cut: Cut, text: LengthText) -> str:
    """ "stretch 12 → 6.0%, 140 mm", of mirror images "2×140 mm": it fits a button in a narrow sidebar."""
    times = f"{len(cut.lengths)}×" if len(cut.lengths) > 1 else ""
    strain = f"{percent_text(cut.strain_before).removesuffix('%')} → {percent_text(cut.strain)}"
    return f"stretch {strain}, {times}{text.rough(cut.lengths[0])}"
