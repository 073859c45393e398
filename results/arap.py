# SPDX-License-Identifier: GPL-3.0-or-later
"""The as-rigid-as-possible map of one piece by libigl, which does not keep lengths (the paper's [6])."""

from __future__ import annotations

import igl
import numpy as np

ITERATIONS = 300  # local/global steps


def arap_map(vertices: np.ndarray, faces: np.ndarray, start: np.ndarray) -> np.ndarray:
    """Return positions (p, 2) of a piece with vertices (p, 3), by local/global steps from start (p, 2), in its actual
    size.
    """
    held = np.zeros(1, dtype=np.int32)  # one fixed vertex, which prevents drifting
    data = igl.ARAPData()
    data.max_iter = ITERATIONS
    igl.arap_precomputation(vertices, faces.astype(np.int64), 2, held, data)
    return igl.arap_solve(start[held], data, start)
