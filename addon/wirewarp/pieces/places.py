# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces stay where the user has put them when they are flattened again. No Blender in here."""

from dataclasses import dataclass

import numpy as np

from ..flat_mesh import FlatMesh
from ..pattern.outlines import outline_edges
from ..polygons import Segments, overlap
from .motion import STAY, Motion, fit_motion

LIKE = 0.7  # correlation of a piece with the earlier one; below it their vertices are not the same ones any more


@dataclass(frozen=True)
class LaidOut:
    """Pieces as they lie."""

    vertices: np.ndarray  # (n,2) float64
    source_vertex: np.ndarray  # (n,) int32
    loop_vertices: np.ndarray  # (l,) int32
    face_sizes: np.ndarray  # (f,) int32
    piece_id: np.ndarray  # (f,) int32


@dataclass(frozen=True)
class Places:
    motions: dict[int, Motion]  # by piece id, from where the piece was laid out to where it goes
    crowded: list[int]  # ids of pieces that could not stay, for they would lie over another


@dataclass(frozen=True)
class _Piece:
    points: np.ndarray  # (k,2)
    sources: np.ndarray  # (k,) the vertex of the model of each
    outline: Segments

    @property
    def area(self) -> float:
        (ax, ay), (bx, by) = self.outline.a.T, self.outline.b.T
        return abs(float((ax * by - ay * bx).sum())) / 2

    def moved(self, motion: Motion) -> "_Piece":
        return _Piece(motion(self.points), self.sources, Segments(motion(self.outline.a), motion(self.outline.b)))


def laid_out(flat: FlatMesh) -> LaidOut:
    return LaidOut(flat.vertices, flat.source_vertex, flat.loop_vertices, flat.polygon_sizes, flat.piece_id)


def find_places(pieces: LaidOut, earlier: LaidOut, gap: float) -> Places:
    """Of the pieces, where those that were there earlier lie; others go to the free room right of them.

    gap: between pieces in the free room, as a fraction of the side of a square with the area of all.
    """
    now, then = _split(pieces), _split(earlier)
    motions = {piece_id: _fit(now[piece_id], then[piece_id]) for piece_id in now if piece_id in then}
    kept = {piece_id: now[piece_id].moved(motion) for piece_id, motion in motions.items() if motion}
    if not kept:
        return Places(dict.fromkeys(now, STAY), [])
    crowded = _crowded(kept, then)
    for piece_id in crowded:
        del kept[piece_id]
    room = gap * np.sqrt(sum(piece.area for piece in now.values()))
    homeless = {piece_id: piece for piece_id, piece in now.items() if piece_id not in kept}
    placed = {piece_id: motions[piece_id] for piece_id in kept} | _beside(kept, homeless, room)
    return Places(placed, crowded)


def _split(pieces: LaidOut) -> dict[int, _Piece]:
    outline = outline_edges(pieces.vertices, pieces.loop_vertices, pieces.face_sizes, pieces.piece_id)
    corner_piece = np.repeat(pieces.piece_id, pieces.face_sizes)
    split = {}
    for piece_id in np.unique(pieces.piece_id).tolist():
        vertices = np.unique(pieces.loop_vertices[corner_piece == piece_id])
        a, b = outline.edges[outline.piece == piece_id].T
        segments = Segments(pieces.vertices[a], pieces.vertices[b])
        split[piece_id] = _Piece(pieces.vertices[vertices], pieces.source_vertex[vertices], segments)
    return split


def _fit(now: _Piece, then: _Piece) -> Motion | None:
    """By the vertices that are in both pieces, once in each; None where these do not tell."""
    rows = [_only_once(piece.sources) for piece in (now, then)]
    _, first, second = np.intersect1d(now.sources[rows[0]], then.sources[rows[1]], return_indices=True)
    if len(first) < 2:
        return None
    points, places = now.points[rows[0][first]], then.points[rows[1][second]]
    motion = fit_motion(points, places)
    moved, goal = (each - each.mean(axis=0) for each in (motion(points), places))
    return motion if (moved * goal).sum() > LIKE * np.linalg.norm(moved) * np.linalg.norm(goal) else None


def _only_once(sources: np.ndarray) -> np.ndarray:
    """Rows of vertices that no cut has doubled within the piece."""
    _, first, count = np.unique(sources, return_index=True, return_counts=True)
    return first[count == 1]


def _crowded(kept: dict[int, _Piece], then: dict[int, _Piece]) -> list[int]:
    """Pieces that lie over another and did not before; of two, the one that has grown more."""
    growth = {piece_id: piece.area / max(then[piece_id].area, 1e-300) for piece_id, piece in kept.items()}
    staying: list[int] = []
    crowded = []
    for piece_id in sorted(kept, key=growth.__getitem__):
        hit = any(
            overlap(kept[piece_id].outline, kept[other].outline)
            and not overlap(then[piece_id].outline, then[other].outline)
            for other in staying
        )
        (crowded if hit else staying).append(piece_id)
    return crowded


def _beside(kept: dict[int, _Piece], homeless: dict[int, _Piece], room: float) -> dict[int, Motion]:
    """Right of the kept pieces, in columns as high as these, the highest pieces first."""
    boxes = np.array([np.concatenate(piece.outline.box) for piece in kept.values()])
    corner, top = np.array([boxes[:, 2].max() + room, boxes[:, 1].min()]), boxes[:, 3].max()
    motions = {}
    place, width = corner.copy(), 0.0
    for piece_id in sorted(homeless, key=lambda each: -np.ptp(homeless[each].points[:, 1])):
        low, high = homeless[piece_id].outline.box
        size = high - low
        if place[1] > corner[1] and place[1] + size[1] > top:
            place, width = np.array([place[0] + width + room, corner[1]]), 0.0
        motions[piece_id] = STAY.shifted(place - low)
        place = place + (0, size[1] + room)
        width = max(width, float(size[0]))
    return motions
