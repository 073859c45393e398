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
    edges = _face_edges(loop_vertices, face_sizes)
    _, first, uses = np.unique(edge_keys(edges, len(vertices)), return_index=True, return_counts=True)
    lonely = np.sort(first[uses == 1])
    edges, piece = edges[lonely], np.repeat(face_piece, face_sizes)[lonely]
    return OutlineEdges(edges, piece, _inward(vertices, edges, piece))


def signed_areas(
    vertices: np.ndarray, loop_vertices: np.ndarray, face_sizes: np.ndarray, face_piece: np.ndarray
) -> np.ndarray:
    """(p,) of the pieces 0, 1, ...; below 0 of one that runs clockwise."""
    return _areas(vertices, _face_edges(loop_vertices, face_sizes), np.repeat(face_piece, face_sizes))


def _face_edges(loop_vertices: np.ndarray, face_sizes: np.ndarray) -> np.ndarray:
    """(l,2) each side of each face."""
    starts = np.cumsum(face_sizes) - face_sizes
    following = np.arange(1, len(loop_vertices) + 1)
    following[starts + face_sizes - 1] = starts
    return np.column_stack([loop_vertices, loop_vertices[following]]).astype(np.int64)


def _areas(vertices: np.ndarray, edges: np.ndarray, piece: np.ndarray) -> np.ndarray:
    """(p,) the signed area of the pieces 0, 1, ... by their edges (b,2), of which piece (b,) says whose they are."""
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    # The shoelace formula; relative to one point of each piece, which may lie far from the origin.
    origins = np.zeros((piece.max(initial=-1) + 1, 2))
    origins[piece] = a
    (ax, ay), (bx, by) = (a - origins[piece]).T, (b - origins[piece]).T
    return np.bincount(piece, ax * by - ay * bx) / 2


def _inward(vertices: np.ndarray, edges: np.ndarray, piece: np.ndarray) -> np.ndarray:
    """Left of each edge; right in pieces that run clockwise: those seen from inside."""
    along = vertices[edges[:, 1]] - vertices[edges[:, 0]]
    _, row = np.unique(piece, return_inverse=True)
    side = np.sign(_areas(vertices, edges, row))[row]
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
