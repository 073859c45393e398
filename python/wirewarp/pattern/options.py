# SPDX-License-Identifier: GPL-3.0-or-later
"""Options of a pattern."""

from collections.abc import Sequence
from typing import TypedDict

import numpy.typing as npt

from .units import Units


class PatternOptions(TypedDict, total=False):
    """Options of a pattern. Lengths are in millimeters, widths from 0 to 1000."""

    title: str
    allowance: float  # outside every seam (10)
    hem: float | None  # outside every outline that is not sewn; None: same as allowance
    allowances: npt.ArrayLike | None  # (k,3) vertex, vertex of an edge of the model, and the width on all its sides
    # (k,3) width on one side of an edge: the side of the triangle in which it runs from the first vertex to the second
    side_allowances: npt.ArrayLike | None
    folds: npt.ArrayLike | None  # (k,2) open edges at which the fabric is folded and not cut
    pairs: bool  # draw pieces of one shape once, "Cut 4", and mirror images, "Cut 1 pair" (False)
    on_fold: bool  # draw one half of each symmetric piece, "Cut 1 on the fold" (False)
    measures: Sequence[tuple[str, float]]  # names and finished lengths, for the proof sheet (default: the rigid wires)
    notch_spacing: float  # along seams, 0 for none (100)
    # "auto" (default) chooses by the sewing order; "mitre", "right angle", "fold-back", "extend", "step" or "round" for
    # all corners
    corner: str
    darts: str  # "close" (default) cuts straight over their mouths; "cut" cuts them out, with allowance on the legs;
    # "slit" cuts along the legs
    material: str  # text on the pieces
    date: str
    units: Units  # units of texts and of the square to measure ("metric")
