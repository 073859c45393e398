# SPDX-License-Identifier: GPL-3.0-or-later
"""The helper wires of a flattening as points and edges, on the model and on the flat pieces. No Blender in here."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from .pieces.motion import Motion


@dataclass(frozen=True)
class HelperLines:
    """Point k on the model is point k on the pieces. Helper wires number through all pieces, as in the report."""

    on_model: np.ndarray  # (n,3) float64, Blender units, the object's rotation, scale and shear applied
    on_pieces: np.ndarray  # (n,2) float64, where the pieces lie
    as_packed: np.ndarray  # (n,2) float64, where the library has laid them, as in the UV layer
    edges: np.ndarray  # (k,2) int32
    helper: np.ndarray  # (k,) int32, helper wire of each edge


def helper_lines(result: Any, motions: Sequence[Motion]) -> HelperLines:  # noqa: ANN401
    """Of all pieces of a FlattenResult that have a layout; motions: one per piece, to where it lies."""
    wires = [
        (wire.points_3d, motion(wire.points_2d), wire.points_2d)
        for piece, motion in zip(result.pieces, motions, strict=True)
        for wire in piece.helper_wires
        if np.isfinite(wire.points_2d).all()
    ]
    sizes = np.array([len(points) for points, *_ in wires], dtype=np.int32)
    on_model, on_pieces, as_packed = (
        np.concatenate([np.empty((0, columns)), *(wire[part] for wire in wires)])
        for part, columns in enumerate((3, 2, 2))
    )
    last = np.cumsum(sizes) - 1
    first = np.delete(np.arange(sizes.sum(), dtype=np.int32), last)  # every point but the last of each wire
    return HelperLines(
        on_model=on_model,
        on_pieces=on_pieces,
        as_packed=as_packed,
        edges=np.column_stack([first, first + 1]).astype(np.int32),
        helper=np.repeat(np.arange(len(wires), dtype=np.int32), sizes - 1),
    )
