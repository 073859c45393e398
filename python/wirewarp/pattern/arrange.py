# SPDX-License-Identifier: GPL-3.0-or-later
"""Where pieces lie on a sheet: in rows, the highest first, none turned."""

import math
from collections.abc import Sequence

import numpy as np

GAP = 10.0  # millimeters between pieces


def in_rows(sizes: np.ndarray, width: float = math.inf) -> np.ndarray:
    """(p,2) lower left corners of boxes of these sizes (p,2), in rows at most this wide; the sheet begins at 0, 0.

    Without a width the sheet is about square. A box that is wider than the sheet has a row of its own.
    """
    if math.isinf(width):
        width = max(math.sqrt(float(np.prod(sizes + GAP, axis=1).sum())) * 1.1, float(sizes[:, 0].max()))
    order = sorted(range(len(sizes)), key=lambda row: (-sizes[row, 1], -sizes[row, 0], row))
    corners = np.zeros_like(sizes)
    x = y = height = 0.0
    for row in order:
        if x > 0 and x + sizes[row, 0] > width + 1e-9:
            x, y, height = 0.0, y + height + GAP, 0.0
        corners[row] = x, y
        x, height = x + sizes[row, 0] + GAP, max(height, sizes[row, 1])
    return corners


def offsets(lows: Sequence[np.ndarray], sizes: np.ndarray, width: float = math.inf) -> np.ndarray:
    """(p,2) by which pieces with these lowest corners are moved to lie in rows."""
    return in_rows(sizes, width) - np.array(lows)
