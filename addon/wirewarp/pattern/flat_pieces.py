# SPDX-License-Identifier: GPL-3.0-or-later
"""The flat pieces as they lie, as plain arrays: what a pattern is made from."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class FlatPieces:
    vertices: np.ndarray  # (n,2) float64
    source_vertex: np.ndarray  # (n,) int32, vertex of the model
    loop_vertices: np.ndarray  # (l,) int32, the corners of one face after those of the other
    loop_edges: np.ndarray  # (l,) int32, the edge from each corner to the next of its face
    face_sizes: np.ndarray  # (f,) int32
    face_piece: np.ndarray  # (f,) int32, index of the piece in the report
    edges: np.ndarray  # (e,2) int32
    wire_ids: np.ndarray  # (e,) int32, 0 none
    tolerances: np.ndarray  # (e,) float32


def piece_of_vertices(
    count: int, loop_vertices: np.ndarray, face_sizes: np.ndarray, face_piece: np.ndarray
) -> np.ndarray:
    """(count,) the piece of each vertex, by those of the faces; 0 for vertices without a face."""
    piece_of_vertex = np.zeros(count, dtype=np.int64)
    piece_of_vertex[loop_vertices] = np.repeat(face_piece, face_sizes)
    return piece_of_vertex
