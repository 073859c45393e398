# SPDX-License-Identifier: GPL-3.0-or-later
"""What is said of a side that is longer than what it is sewn to."""

from collections.abc import Sequence

from ..core import pattern
from ..words import LengthText
from .rows import Side


def longer_texts(sides: Sequence[Side], units: LengthText, meters: float) -> list[str]:
    """ "Sleeve 12 mm longer, ease between notches", as it stands on the paper; of the sides of a seam.

    meters: in a Blender unit.
    """
    asked = {side.label: side.length_asked for side in sides if side.length_2d is not None and side.length_asked}
    millimeters = 1000 * meters
    texts = {
        label: pattern.longer_text(
            length * millimeters, min(asked.values()) * millimeters, lambda more: units.rough(more / millimeters)
        )
        for label, length in asked.items()
    }
    return [f"{label} {text}" for label, text in texts.items() if text]
