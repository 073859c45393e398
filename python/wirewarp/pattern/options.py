# SPDX-License-Identifier: GPL-3.0-or-later
"""Defines the options of a pattern."""

from collections.abc import Sequence
from typing import TypedDict

import numpy.typing as npt

from .units import Units


class PatternOptions(TypedDict, total=False):
    """Options of a pattern. Lengths are in millimeters, and widths at most 1000 mm. Defaults are in parentheses."""

    title: str
    allowance: float  # width of the allowance at every seam (10)
    hem: float | None  # width of the allowance at every outline that is not sewn (None: the same as allowance)
    allowances: npt.ArrayLike | None  # (k,3) both vertices of an edge of the model, and the width on all its sides
    # Each row (k,3) has both vertices of an edge, and the width on one side. On this side, the triangle runs from the
    # first vertex to the second.
    side_allowances: npt.ArrayLike | None
    folds: npt.ArrayLike | None  # (k,2) edges of the outline at which the fabric is folded instead of cut
    pairs: bool  # draw equal pieces once ("Cut 4"), and a piece and its mirror image once ("Cut 1 pair") (False)
    on_fold: bool  # draw one half of each symmetric piece ("Cut 1 on the fold") (False)
    measures: Sequence[tuple[str, float]]  # names and finished lengths on the proof sheet (rigid wires)
    notch_spacing: float  # distance between notches along seams; 0 for none (100)
    # All corners have this type: "mitre", "right angle", "fold-back", "extend", "step" or "round". The type "auto"
    # chooses by the sewing order ("auto").
    corner: str
    # "close" keeps the fabric in darts and shapes their mouths, so that folded darts continue the outline. "cut" cuts
    # darts out with an allowance on the legs, and "slit" cuts along the legs ("close").
    darts: str
    material: str  # text about the material on the pieces
    date: str  # text with the date on the pieces
    units: Units  # units of texts and of the test square ("metric")
