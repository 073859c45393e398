# SPDX-License-Identifier: GPL-3.0-or-later
"""A marker on pages as wide as the cloth."""

from dataclasses import dataclass

import numpy as np

from .checks import problem
from .marker import SHEETS_APART, Marker
from .papers import LONGEST, MARGIN, OVERLAP
from .scale_block import SIZE
from .units import UnitSystem


@dataclass(frozen=True)
class Part:
    """Of the cloth, on a page of its own."""

    low: np.ndarray  # (2,) lower left corner, where the marker has it
    size: np.ndarray  # (2,) width and height
    is_first: bool  # it begins a sheet or the roll
    is_last: bool  # it ends one


def parts_of(marker: Marker) -> list[Part]:
    """None longer than readers show; where the cloth is longer, parts overlap."""
    length = marker.length if marker.sheet_length is None else marker.sheet_length
    most = LONGEST - 2 * MARGIN - SIZE[1]
    count = max(1, int(np.ceil((length - OVERLAP) / (most - OVERLAP) - 1e-9)))
    parts = []
    for sheet in range(marker.sheets):
        begin = sheet * (length + SHEETS_APART)
        for number in range(count):
            low = number * (most - OVERLAP)
            size = np.array([marker.width, min(length - low, most)])
            parts.append(Part(np.array([0.0, begin + low]), size, number == 0, number == count - 1))
    return parts


def page_width(marker: Marker, roll: float | None, units: UnitSystem) -> float:
    """roll: the width of the paper; None for one as wide as it takes. Raises FlattenError for a narrower one."""
    needed = max(marker.width, float(SIZE[0])) + 2 * MARGIN
    if roll is not None and roll < needed - 1e-6:
        raise problem(
            f"The marker is {units.text(marker.width)} wide and needs a roll of {units.text(needed)}, "
            f"not {units.text(roll)}: choose a wider roll, or sheets."
        )
    if needed > LONGEST:
        raise problem(
            f"The marker is {units.text(marker.width)} wide, and readers show no page of that: choose sheets."
        )
    return needed if roll is None else roll
