# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes the as-rigid-as-possible map of a piece ([6] in the paper) by libigl. This map does not keep lengths."""

from __future__ import annotations

import igl
import numpy as np

ITERATIONS = 300  # number of local/global steps


def arap_map(vertices: np.ndarray, faces: np.ndarray, start: np.ndarray) -> np.ndarray:
    """Return positions (p, 2) of a piece with vertices (p, 3), by local/global steps from start (p, 2).

    The start must have the piece's actual size.
    """
    held = np.zeros(1, dtype=np.int32)  # index of a fixed vertex, without which the map would drift
    data = igl.ARAPData()
    data.max_iter = ITERATIONS
    igl.arap_precomputation(vertices, faces.astype(np.int64), 2, held, data)
    return igl.arap_solve(start[held], data, start)
