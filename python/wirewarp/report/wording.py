# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the sentences of the verdict, and the words for stretch in hints and lists."""

import math
from collections.abc import Sequence

from .model import Threads
from .strain import percent_text
from .words import counted

# If the smaller of stretch and compression is below this share of the larger, only the larger is mentioned.
LESSER = 0.5
NOT_FLATTENED = "Not flattened"
BEYOND_REMEDY = "Add a dart or seam, or choose another fabric."  # written once, after all sentences
EXACT, TOLERATED = "every length kept", "every length kept or within its tolerance"


def uncut(names: str, count: int, are_closed: bool) -> str:
    """Return the sentence about pieces that cannot be flattened without a seam. names: list of their names, or "" if
    the model is one piece."""
    needs = ("is closed", "are closed") if are_closed else ("needs a seam", "need seams")
    is_several = count > 1
    return f"{names or 'This model'} {needs[is_several]}: choose where to cut {('it', 'them')[is_several]}"


def failed(count: int, of: int) -> str:
    return f"Do not cut: {count} of {counted(of, 'piece')} failed" if of > 1 else "Do not cut: the piece failed"


def failed_models(names: str) -> str:
    return f"Do not cut: {names} failed"


def no_fabric(names: str) -> str:
    return f"{names}: no fabric stretches far enough. Add seams."


def beyond_fabric(names: str, threads: Threads) -> str:
    """Return a sentence such as "Front must stretch 7.6% along, but this denim stretches only 3.0%". It names only
    directions in which the fabric does not stretch far enough."""
    over = [way for way in ("across", "along") if threads.is_over(way) and getattr(threads.gives, way) is not None]
    figures = [_apart(getattr(threads, way), getattr(threads.gives, way)) for way in over]
    needed = " and ".join(f"{needs} {way}" for (needs, _), way in zip(figures, over, strict=True))
    known = [gives for _, gives in figures]
    ways = [f"{text} {way}" for text, way in zip(known, over, strict=True)]
    stretches = known[0] if len(set(known)) == 1 else " and ".join(ways)
    return f"{names} must stretch {needed}, but this {threads.cloth} stretches only {stretches}"


def _apart(needs: float, gives: float) -> tuple[str, str]:
    """Return both fractions as texts, with enough digits to differ."""
    texts = percent_text(needs), percent_text(gives)
    for digits in (1, 2, 3):
        if texts[0] != texts[1] or needs >= 1:
            break
        texts = f"{100 * needs:.{digits}f}%", f"{100 * gives:.{digits}f}%"
    return texts


def set_beyond_fabric(threads: Threads) -> str:
    """Return the sentence about a set of seams. threads: strain in the piece that exceeds the fabric's stretch most."""
    return f"A piece must stretch {by_way(threads.across, threads.along)}, more than this {threads.cloth} can."


def needs_stretch(names: str, is_exact: bool, stretch: str) -> str:
    """Return the sentence about pieces that need stretch fabric.

    - names: list of the names of the pieces, "" for all
    - is_exact: whether lengths are exact, not only within tolerances
    - stretch: text of the needed stretch
    """
    which = f"Lengths of {names}" if names else "Lengths"
    kept = "exact" if is_exact else "exact or within their tolerance"
    return f"{which} are {kept}. Cut from fabric that stretches at least {stretch}."


def by_way(across: float, along: float) -> str:
    """Return a text such as "12% across and 5.0% along"."""
    return f"{percent_text(across)} across and {percent_text(along)} along"


def ready(which: str) -> str:
    return f"Ready to cut: {which}"


def ready_for_stretch(which: str, stretch: float) -> str:
    """Return the sentence for a fabric with unknown maximum stretch. stretch: largest stretch that the pieces need."""
    return f"Ready to cut from fabric that stretches at least {percent_text(stretch)}: {which}"


def ready_for_any(which: str) -> str:
    return f"Ready to cut from any fabric: {which}"


def ignored(makers: Sequence[str]) -> str:
    """Return the sentence about ignored parts of the model. makers: "modifiers", "shape keys" or both."""
    return f"{' and '.join(makers).capitalize()} were ignored, so sizes differ from what you see"


def too_narrow(names: str, is_one: bool) -> str:
    have = "has" if is_one else "have"
    return f"{names} {have} no room for two allowances in one place, and may be too narrow to sew."


def needs_text(threads: Threads) -> str:
    """Return a text such as "4.0% across and 2.0% along (shear 18°)"."""
    return f"{by_way(threads.across, threads.along)} (shear {math.degrees(threads.shear):.0f}°)"


def strain_text(stretch: float, compression: float) -> str:
    """Return "stretched" or "compressed", or "stretched and compressed" if both fractions are similar.

    The text has no figure, because a second figure beside the figure of the piece would confuse readers.
    """
    strains = {"stretched": stretch, "compressed": compression}
    return " and ".join(word for word, share in strains.items() if share >= LESSER * max(strains.values()))
