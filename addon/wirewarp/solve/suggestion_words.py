# SPDX-License-Identifier: GPL-3.0-or-later
"""Suggested cuts in words."""

from ..core import percent_text
from ..words import LengthText, counted
from .suggest import Cut, Target

WORDS = {"DARTS": ("dart", "darts"), "SEAMS": ("seam", "seams")}


def found_words(kind: str, cuts: list[Cut]) -> str:
    """ "1 dart", "3 seams", "2 sets of seams"."""
    if cuts[0].is_first:
        return counted(len(cuts), "set of seams", "sets of seams")
    return counted(sum(len(cut.lengths) for cut in cuts), *WORDS[kind])


def taken_words(kind: str, cut: Cut) -> str:
    """Of cuts that are taken together, "2 darts", "first seams", "first seams and 1 seam"."""
    if not cut.is_first:
        return counted(len(cut.lengths), *WORDS[kind])
    more = len(cut.lengths) - 1
    return f"first seams and {counted(more, *WORDS[kind])}" if more else "first seams"


def step_text(kind: str, cut: Cut, text: LengthText) -> str:
    """Of cuts that are taken together, "2 darts: 12 → 5.0%, 270 mm": it fits a button in a narrow sidebar."""
    return f"{taken_words(kind, cut)}: {_shares(cut)}, {text.rough(sum(cut.lengths))}"


def row_text(kind: str, cut: Cut, target: Target | None, text: LengthText) -> str:
    """In the list."""
    if target is None:
        return cut_text(cut, text)
    step = step_text(kind, cut, text)
    return step[0].upper() + step[1:]


def shortfall(kind: str, cuts: list[Cut], target: Target) -> str:
    """Why the target is not reached; empty where it is."""
    last = cuts[-1]
    if last.strain <= target.strain:
        return ""
    if len(last.lengths) >= target.most:
        remedy = "Allow more cuts"
    elif target.length is not None:
        remedy = "Allow more length, if any other cut helps"
    else:
        remedy = f"No other {WORDS[kind][0]} helps"
    return f"{percent_text(last.strain)} is left, more than your target of {percent_text(target.strain)}. {remedy}."


def cut_text(cut: Cut, text: LengthText) -> str:
    """ "stretch 12 → 6.0%, 140 mm", of mirror images "2×140 mm": it fits a button in a narrow sidebar.

    Of first cuts "3 pieces, stretch 6.0%, seams 1.40 m".
    """
    if cut.is_first:
        return f"{counted(cut.num_pieces, 'piece')}, stretch {_shares(cut)}, seams {text.rough(cut.lengths[0])}"
    times = f"{len(cut.lengths)}×" if len(cut.lengths) > 1 else ""
    return f"stretch {_shares(cut)}, {times}{text.rough(cut.lengths[0])}"


def _shares(cut: Cut) -> str:
    before = "" if cut.is_first else f"{percent_text(cut.strain_before).removesuffix('%')} → "
    return f"{before}{percent_text(cut.strain)}"
