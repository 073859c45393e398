# SPDX-License-Identifier: GPL-3.0-or-later
"""Edges as numbers that can be sorted and searched. No Blender in here."""

import numpy as np
from numpy.typing import ArrayLike


def edge_keys(pairs: ArrayLike, count: int) -> np.ndarray:
    """One number for each pair of vertices, whichever comes first; count: of all vertices."""
    return np.sort(np.asarray(pairs, dtype=np.int64).reshape(-1, 2), axis=1) @ np.array([count, 1])
