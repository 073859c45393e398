# SPDX-License-Identifier: GPL-3.0-or-later
"""The outlines of flat pieces: the edges that only one face has, and the loops they form."""

from dataclasses import dataclass

import numpy as np

from ..edge_keys import edge_keys


@dataclass(frozen=True)
class OutlineEdges:
    """Directed as in their face. Of mirrored pieces too, the piece is on the side of `inward`."""

    edges: np.ndarray  # (b,2) int64, vertices
    piece: np.ndarray  # (b,) int32
    inward: np.ndarray  # (b,2) unit vectors


def outline_edges(
    vertices: np.ndarray, loop_vertices: np.ndarray, face_sizes: np.ndarray, face_piece: np.ndarray
) -> OutlineEdges:
    """vertices (n,2); loop_vertices (l,): the corners of one face after those of the other; by face: size and piece."""
    starts = np.cumsum(face_sizes) - face_sizes
    following = np.arange(1, len(loop_vertices) + 1)
    following[starts + face_sizes - 1] = starts
    edges = np.column_stack([loop_vertices, loop_vertices[following]]).astype(np.int64)
    _, first, uses = np.unique(edge_keys(edges, len(vertices)), return_index=True, return_counts=True)
    lonely = np.sort(first[uses == 1])
    edges, piece = edges[lonely], np.repeat(face_piece, face_sizes)[lonely]
    return OutlineEdges(edges, piece, _inward(vertices, edges, piece))


def _inward(vertices: np.ndarray, edges: np.ndarray, piece: np.ndarray) -> np.ndarray:
    """Left of each edge; right in pieces that run clockwise: those seen from inside."""
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    along = b - a
    # Twice the area by the shoelace formula; relative to one point of each piece, which may lie far from the origin.
    _, first, row = np.unique(piece, return_index=True, return_inverse=True)
    origin = a[first[row]]
    cross = (a - origin)[:, 0] * (b - origin)[:, 1] - (a - origin)[:, 1] * (b - origin)[:, 0]
    side = np.sign(np.bincount(row, cross))[row]
    left = np.column_stack([-along[:, 1], along[:, 0]])
    return left * (side / np.maximum(np.linalg.norm(along, axis=1), np.finfo(float).tiny))[:, None]


def outline_loops(outline: OutlineEdges, piece: int) -> list[np.ndarray]:
    """The vertices (k,) of each closed run of one piece's outline, in order."""
    following: dict[int, list[int]] = {}
    for a, b in outline.edges[outline.piece == piece].tolist():
        following.setdefault(a, []).append(b)
    loops = []
    while following:
        loop = [next(iter(following))]
        while loop[-1] in following:
            ends = following[loop[-1]]
            loop.append(ends.pop())
            if not ends:
                del following[loop[-2]]
            if loop[-1] == loop[0]:
                break
        loops.append(np.array(loop[:-1]))
    return loops
