# SPDX-License-Identifier: GPL-3.0-or-later
"""Scales maps to the area of the model, because some methods make pieces of an arbitrary size."""

import numpy as np
import wirewarp


def at_true_size(corner_uv: np.ndarray, measured: wirewarp.FlattenResult) -> np.ndarray:
    """Return the map (m, 3, 2) with every piece scaled to its area on the model. measured: measure() of the map."""
    scaled = corner_uv.copy()
    for piece in measured.pieces:
        scaled[piece.source_face] *= np.sqrt(piece.metrics.area_3d / abs(piece.metrics.area_2d))
    return scaled
