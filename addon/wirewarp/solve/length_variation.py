# SPDX-License-Identifier: GPL-3.0-or-later
"""By how much the edges of flat pieces miss the lengths asked for: E_L of Eq. (5)."""

import numpy as np
from numpy.typing import ArrayLike

from ..core import FlattenResult
from .arrays import MeshArrays, edge_lengths
from .chains import edge_keys
from .flatten import FlattenChoices


def edge_length_variation(
    result: FlattenResult, arrays: MeshArrays, choices: FlattenChoices, flat: np.ndarray, places: np.ndarray
) -> np.ndarray:
    """(e,) float32 of flat edges; flat (e,2): as vectors, places (e,2): the piece and the edge of the model of each.

    On lines what the library says. Inside of pieces the model's length is asked for, stretched as the cloth when worn.
    """
    worn = (choices.cloth.worn_across, choices.cloth.worn_along) if choices.cloth else (0.0, 0.0)
    spatial = _model_lengths(result, arrays, choices)[places[:, 1]]
    variation = np.abs(np.linalg.norm(flat * np.add(worn, 1), axis=1) - spatial) / spatial
    keys, on_lines = _on_lines(result, arrays)
    own = places @ (len(arrays.edges), 1)
    place = np.searchsorted(keys, own).clip(max=len(keys) - 1)
    return np.where(keys[place] == own, on_lines[place], variation).astype(np.float32)


def _on_lines(result: FlattenResult, arrays: MeshArrays) -> tuple[np.ndarray, np.ndarray]:
    """Of each piece and edge of the model on a wire or outline a number, ascending, and E_L; the worse of two sides."""
    pieces = np.repeat(np.arange(len(result.pieces)), [len(piece.metrics.wire_edges) for piece in result.pieces])
    pairs = [np.reshape(piece.metrics.wire_edges, (-1, 2)) for piece in result.pieces]
    keys = pieces * len(arrays.edges) + _edges_at(np.concatenate(pairs), arrays)
    found, number = np.unique(keys, return_inverse=True)
    worst = np.zeros(len(found))
    np.maximum.at(worst, number, np.concatenate([piece.metrics.edge_length_variation for piece in result.pieces]))
    return found, worst


def _model_lengths(result: FlattenResult, arrays: MeshArrays, choices: FlattenChoices) -> np.ndarray:
    """(k,) of the model's edges; of a thick material in the middle of its thickness.

    These are as long as the flat ones are worn: dx f_u + dy f_v, where |f_u|, |f_v| and the angle between them are what
    is measured of threads.
    """
    lengths = edge_lengths(arrays.vertices, arrays.edges)
    if choices.thickness == 0 or choices.surface == "middle":
        return lengths
    weft, warp, shear = (
        _of_triangles(result, f"face_{name}", len(arrays.triangles))[:, None]
        for name in ("weft_strain", "warp_strain", "shear_angle")
    )
    towards = -1 if choices.mirror else 1  # shear is measured as seen from outside
    dx, dy = (np.roll(result.corner_uv, -1, axis=1) - result.corner_uv).transpose(2, 0, 1)  # (m,3), the sides
    with np.errstate(invalid="ignore"):  # of triangles without a layout, or without an area
        across, along = (1 + weft) * dx, (1 + warp) * dy
        worn = np.sqrt(across**2 + along**2 + 2 * towards * np.sin(shear) * across * along).ravel()
    rows = _edges_at(np.stack([arrays.triangles, np.roll(arrays.triangles, -1, axis=1)], axis=-1), arrays)
    known = (rows >= 0) & np.isfinite(worn)
    lengths[rows[known]] = worn[known]
    return lengths


def _of_triangles(result: FlattenResult, name: str, count: int) -> np.ndarray:
    """(m,) a measure of all pieces."""
    values = np.full(count, np.nan)
    for piece in result.pieces:
        values[piece.source_face] = getattr(piece.metrics, name)
    return values


def _edges_at(pairs: ArrayLike, arrays: MeshArrays) -> np.ndarray:
    """(k,) the edges between these vertices (...,2); -1 for what runs across a face."""
    count = len(arrays.vertices)
    keys, wanted = edge_keys(arrays.edges, count), edge_keys(pairs, count)
    order = np.argsort(keys)
    found = order[np.searchsorted(keys, wanted, sorter=order).clip(max=len(keys) - 1)]
    return np.where(keys[found] == wanted, found, -1)
