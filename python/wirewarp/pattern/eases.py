# SPDX-License-Identifier: GPL-3.0-or-later
"""What is told of a side of a seam that is longer than what it is sewn to."""

from collections.abc import Callable, Sequence

from .units import UnitSystem

LEAST = 0.5  # millimeters; nobody eases in less, and flat pieces in single precision are off by far less
GATHERED = 0.15  # of the shorter side: more than this no cloth is eased in without pleats, it is gathered


def longer_text(length: float, shortest: float, length_text: Callable[[float], str]) -> str:
    """ "12 mm longer, ease between notches" of a side of this length; empty of the shortest ones.

    length_text: writes a length. All lengths are in millimeters.
    """
    more = length - shortest
    if more < LEAST:
        return ""
    how = "ease" if more <= GATHERED * shortest else "gather"
    return f"{length_text(more)} longer, {how} between notches"


def longer_texts(lengths: Sequence[float], units: UnitSystem) -> list[str]:
    """Of all sides of a seam."""
    return [longer_text(length, min(lengths), units.text) for length in lengths]
