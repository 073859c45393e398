# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat pieces as arrays, and their outlines: the edges with one face."""

from dataclasses import dataclass

import numpy as np

from .chains import EdgeMarks, next_corners


@dataclass(frozen=True)
class FlatPieces:
    """A flat mesh, as WireWarp made it or as the user has changed it."""

    vertices: np.ndarray  # (n,2) float64, places of the vertices
    source_vertex: np.ndarray  # (n,) int32, vertex of the model
    loop_vertices: np.ndarray  # (l,) int32, the vertex of each corner, face by face
    loop_edges: np.ndarray  # (l,) int32, the edge from each corner to the next corner of its face
    face_sizes: np.ndarray  # (f,) int32, number of corners of each face
    face_piece: np.ndarray  # (f,) int32, index of the piece in the report
    piece_id: np.ndarray  # (f,) int32, the piece's id for the next run
    source_face: np.ndarray  # (f,) int32, face of the model
    edges: np.ndarray  # (e,2) int32
    marks: EdgeMarks  # (e,)


def piece_of_vertices(
    count: int, loop_vertices: np.ndarray, face_sizes: np.ndarray, face_piece: np.ndarray
) -> np.ndarray:
    """Return the piece of each vertex (count,) from the pieces of its faces; 0 for vertices without a face."""
    piece_of_vertex = np.zeros(count, dtype=np.int64)
    piece_of_vertex[loop_vertices] = np.repeat(face_piece, face_sizes)
    return piece_of_vertex


@dataclass(frozen=True)
class OutlineEdges:
    """Outline edges, in the direction in which they run around their face."""

    edges: np.ndarray  # (b,2) int64, vertices of each edge
    piece: np.ndarray  # (b,) int32, piece of each edge
    inward: np.ndarray  # (b,2) unit vectors into the piece, even if the piece is mirrored


def outline_edges(
    vertices: np.ndarray,
    loop_vertices: np.ndarray,
    loop_edges: np.ndarray,
    face_sizes: np.ndarray,
    face_piece: np.ndarray,
) -> OutlineEdges:
    """Return the outline edges of flat pieces.

    vertices (n,2): places
    loop_vertices, loop_edges (l,): for each corner, its vertex and the edge to the next corner
    face_sizes, face_piece (f,): for each face, its number of corners and its piece
    """
    lonely = np.flatnonzero(np.bincount(loop_edges)[loop_edges] == 1)
    corners = np.column_stack([lonely, next_corners(face_sizes)[lonely]])
    edges, piece = loop_vertices[corners].astype(np.int64), np.repeat(face_piece, face_sizes)[lonely]
    return OutlineEdges(edges, piece, _inward(vertices, edges, piece))


def outline_of(flat: FlatPieces) -> OutlineEdges:
    return outline_edges(flat.vertices, flat.loop_vertices, flat.loop_edges, flat.face_sizes, flat.face_piece)


def signed_areas(vertices: np.ndarray, outline: OutlineEdges) -> np.ndarray:
    """Return the areas (p,) of the pieces by index; below 0 if the outline runs clockwise."""
    return _areas(vertices, outline.edges[:, 0], outline.edges[:, 1], outline.piece)


def _areas(vertices: np.ndarray, a: np.ndarray, b: np.ndarray, piece: np.ndarray) -> np.ndarray:
    """Return the signed areas (p,) of the pieces by index. a, b (k,): ends of the outline edges; piece (k,): the piece
    of each edge."""
    origin = np.zeros(piece.max(initial=-1) + 1, dtype=np.int64)
    origin[piece] = a
    # The shoelace formula uses places relative to a point of each piece, because pieces may be far from the origin.
    sides = []
    for column in map(np.ascontiguousarray, vertices.T):
        origins = column[origin][piece]
        sides.append((column[a] - origins, column[b] - origins))
    (ax, bx), (ay, by) = sides
    return np.bincount(piece, ax * by - ay * bx) / 2


def _inward(vertices: np.ndarray, edges: np.ndarray, piece: np.ndarray) -> np.ndarray:
    """Return unit vectors (b,2) to the left of each edge, or to the right in pieces whose outline runs clockwise."""
    along = vertices[edges[:, 1]] - vertices[edges[:, 0]]
    _, row = np.unique(piece, return_inverse=True)
    side = np.sign(_areas(vertices, edges[:, 0], edges[:, 1], row))[row]
    left = np.column_stack([-along[:, 1], along[:, 0]])
    return left * (side / np.maximum(np.linalg.norm(along, axis=1), np.finfo(float).tiny))[:, None]
