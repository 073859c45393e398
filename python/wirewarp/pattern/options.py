# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be chosen when a pattern is made."""

from collections.abc import Sequence
from typing import TypedDict

import numpy.typing as npt

from .units import Units


class PatternOptions(TypedDict, total=False):
    """Lengths are in millimeters, widths from 0 to 1000."""

    title: str
    allowance: float  # outside of every seam (10)
    hem: float | None  # outside of every outline that is not sewn; None: as allowance
    allowances: npt.ArrayLike | None  # (k,3) vertex, vertex of an edge of the model, and the width on all its sides
    side_allowances: npt.ArrayLike | None  # (k,3) the width on one side: of the triangle that has the edge this way
    folds: npt.ArrayLike | None  # (k,2) edges that are not sewn, but at which the fabric lies double: not cut
    pairs: bool  # draw one piece of each mirrored pair, "Cut 1 pair" (False)
    on_fold: bool  # draw one half of each symmetric piece, "Cut 1 on the fold" (False)
    measures: Sequence[tuple[str, float]]  # names and finished lengths, for the proof sheet (the rigid wires)
    notch_spacing: float  # along seams, 0 for none (100)
    corner: str  # "auto" (default) chooses by what is sewn first; "mitre", "right angle", "fold-back", "extend", "step"
    # or "round" for all corners
    darts: str  # "close" (default) cuts straight over their mouths; "cut" cuts them out, with allowance on the legs;
    # "slit" cuts along the legs
    material: str  # as it stands on the pieces
    date: str
    units: Units  # of texts and of the square to measure ("metric")
