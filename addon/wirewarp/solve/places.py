# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the places of pieces that are flattened again: where the user has moved them, if they have room there."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..core import pattern
from .flat_mesh import FlatMesh
from .outlines import FlatPieces, OutlineEdges, outline_edges, piece_of_vertices

# maximum number of points by which the place of a piece is stored; a correlation of 0.7 then has an error of 0.05
SAMPLE = 100
# Points of pieces that have a place but no flat shape at present are rows (k,4): piece id, source vertex, place (2).
# This array has no rows.
NONE_AWAY = np.empty((0, 4))
# A piece keeps its place if the correlation between its points and those of its earlier shape is above this number.
# The earlier shape then explains half of the variance (0.7²).
LIKE = 0.7


@dataclass(frozen=True)
class Motion:
    """A rotation about the origin, followed by a translation. Points of the plane are treated as complex numbers."""

    turn: complex = 1.0  # rotation, as a complex number of length 1
    shift: complex = 0.0

    def __call__(self, points: np.ndarray) -> np.ndarray:
        moved = (points[:, 0] + 1j * points[:, 1]) * self.turn + self.shift
        return np.column_stack([moved.real, moved.imag])

    def shifted(self, by: np.ndarray) -> "Motion":
        return Motion(self.turn, self.shift + complex(*by))


STAY = Motion()


def fit_motion(points: np.ndarray, places: np.ndarray) -> Motion:
    """Return the least-squares motion from points (k,2) to their places (k,2)."""
    start, goal = points.mean(axis=0), places.mean(axis=0)
    (x, y), (u, v) = (points - start).T, (places - goal).T
    spin = complex(x @ u + y @ v, x @ v - y @ u)  # the sum of conj(x + iy) (u + iv)
    turn = spin / abs(spin) if abs(spin) > 0 else 1.0
    return Motion(turn, complex(*goal) - turn * complex(*start))


@dataclass(frozen=True)
class Places:
    motions: dict[int, Motion]  # motion of each piece from the layout to its place, by id
    crowded: list[int]  # ids of pieces that had to move, because they would overlap another piece


class _Pieces:
    """Data of single pieces, by id. Outlines are computed only if they are needed, because computing them is slow."""

    def __init__(self, pieces: FlatMesh | FlatPieces, away: np.ndarray = NONE_AWAY) -> None:
        self._pieces = pieces
        ids = piece_of_vertices(len(pieces.vertices), pieces.loop_vertices, pieces.face_sizes, pieces.piece_id)
        order = np.argsort(ids, kind="stable")
        present, first = np.unique(ids[order], return_index=True)
        self._vertices = dict(zip(present.tolist(), np.split(order, first[1:]), strict=True))
        self._vertices.pop(0, None)  # vertices without a piece
        away_ids = away[:, 0].astype(np.int64)
        self._away = {piece_id: away[away_ids == piece_id] for piece_id in np.unique(away_ids).tolist()}

    def __iter__(self) -> Iterator[int]:
        return iter(self._vertices)

    def __contains__(self, piece_id: int) -> bool:
        return piece_id in self._vertices or piece_id in self._away

    def is_away(self, piece_id: int) -> bool:
        """Return whether the piece has a place but no flat shape at present."""
        return piece_id not in self._vertices

    def points(self, piece_id: int) -> np.ndarray:
        if self.is_away(piece_id):
            return self._away[piece_id][:, 2:]
        return self._pieces.vertices[self._vertices[piece_id]]

    def sources(self, piece_id: int) -> np.ndarray:
        """Return, for each point, its vertex on the model, (k,)."""
        if self.is_away(piece_id):
            return self._away[piece_id][:, 1].astype(np.int64)
        return self._pieces.source_vertex[self._vertices[piece_id]]

    def box(self, piece_id: int, motion: Motion = STAY) -> np.ndarray:
        """Return the lowest and the highest corner (2,2) of the moved piece's box."""
        points = motion(self.points(piece_id))
        return np.array([points.min(axis=0), points.max(axis=0)])

    def outlines(self, piece_id: int, motion: Motion = STAY) -> list[np.ndarray]:
        own = self._outlines.edges[self._outlines.piece == piece_id]
        return [motion(line) for line in pattern.closed_lines(self._pieces.vertices, own)]

    def area(self, piece_id: int) -> float:
        return abs(sum(map(pattern.geometry.signed_area, self.outlines(piece_id))))

    @cached_property
    def _outlines(self) -> OutlineEdges:
        pieces = self._pieces
        return outline_edges(
            pieces.vertices, pieces.loop_vertices, pieces.loop_edges, pieces.face_sizes, pieces.piece_id
        )


def points_of(earlier: FlatPieces, away: np.ndarray, piece_ids: Sequence[int]) -> np.ndarray:
    """Return some points (k,4) of each of these pieces, even of pieces without a flat shape; see NONE_AWAY."""
    pieces = _Pieces(earlier, away)
    rows = [NONE_AWAY]
    for piece_id in piece_ids:
        if piece_id in pieces:
            sources, points = pieces.sources(piece_id), pieces.points(piece_id)
            some = slice(None, None, -(-len(sources) // SAMPLE))
            ids = np.full(len(sources[some]), piece_id)
            rows.append(np.column_stack([ids, sources[some], points[some]]))
    return np.concatenate(rows)


def find_places(pieces: FlatMesh, earlier: FlatPieces, away: np.ndarray, spacing: float) -> Places:
    """Return the places of all pieces. Earlier pieces keep their places if they have room, and other pieces are placed
    to the right of them. away: see NONE_AWAY; spacing: space between these other pieces."""
    now, then = _Pieces(pieces), _Pieces(earlier, away)
    fits = {piece_id: _fit(now, then, piece_id) for piece_id in now if piece_id in then}
    kept = {piece_id: motion for piece_id, motion in fits.items() if motion}
    if not kept:
        return Places(dict.fromkeys(now, STAY), [])
    crowded = _crowded(kept, now, then)
    for piece_id in crowded:
        del kept[piece_id]
    homeless = [piece_id for piece_id in now if piece_id not in kept]
    if homeless:
        kept |= _beside(kept, homeless, now, spacing)
    return Places(kept, crowded)


def _fit(now: _Pieces, then: _Pieces, piece_id: int) -> Motion | None:
    """Return the motion of the piece to its earlier place; None without a good fit to at least two points.

    The points are the vertices that occur exactly once in each of the two shapes.
    """
    rows = [_only_once(pieces.sources(piece_id)) for pieces in (now, then)]
    here, there = (pieces.sources(piece_id)[own] for pieces, own in zip((now, then), rows, strict=True))
    _, first, second = np.intersect1d(here, there, assume_unique=True, return_indices=True)
    if len(first) < 2:
        return None
    points, places = now.points(piece_id)[rows[0][first]], then.points(piece_id)[rows[1][second]]
    motion = fit_motion(points, places)
    moved, goal = (each - each.mean(axis=0) for each in (motion(points), places))
    return motion if (moved * goal).sum() > LIKE * np.linalg.norm(moved) * np.linalg.norm(goal) else None


def _only_once(sources: np.ndarray) -> np.ndarray:
    """Return the rows of vertices that occur only once in the piece. Cuts double the other vertices."""
    _, first, count = np.unique(sources, return_index=True, return_counts=True)
    return first[count == 1]


def _crowded(kept: dict[int, Motion], now: _Pieces, then: _Pieces) -> list[int]:
    """Return the pieces that overlap another piece now, but did not before. Of two such pieces, only the piece that has
    grown more is returned."""
    overlap = pattern.geometry.overlap
    close = _close(kept, now)
    growth = {piece_id: now.area(piece_id) / max(then.area(piece_id), 1e-300) for piece_id in close}
    staying: list[int] = []
    crowded: list[int] = []
    for piece_id in sorted(close, key=growth.__getitem__):
        hit = any(
            overlap(now.outlines(piece_id, kept[piece_id]), now.outlines(other, kept[other]))
            and (
                then.is_away(piece_id)
                or then.is_away(other)
                or not overlap(then.outlines(piece_id), then.outlines(other))
            )
            for other in staying
            if other in close[piece_id]
        )
        (crowded if hit else staying).append(piece_id)
    return crowded


def _close(kept: dict[int, Motion], now: _Pieces) -> dict[int, set[int]]:
    """Return, for each piece with a box that overlaps other boxes, the pieces of these other boxes."""
    ids = list(kept)
    low, high = np.array([now.box(piece_id, motion) for piece_id, motion in kept.items()]).transpose(1, 0, 2)
    meet = np.all((low[:, None] < high) & (low < high[:, None]), axis=2) & ~np.eye(len(ids), dtype=bool)
    return {ids[row]: {ids[other] for other in np.flatnonzero(meet[row])} for row in np.flatnonzero(meet.any(axis=1))}


def _beside(kept: dict[int, Motion], homeless: list[int], now: _Pieces, room: float) -> dict[int, Motion]:
    """Return motions of the homeless pieces to the right of the kept pieces, the tallest piece first. Columns are as
    high as all kept pieces together. room: space between pieces."""
    boxes = np.array([now.box(piece_id, motion) for piece_id, motion in kept.items()])
    corner, top = np.array([boxes[:, 1, 0].max() + room, boxes[:, 0, 1].min()]), boxes[:, 1, 1].max()
    motions = {}
    place, width = corner.copy(), 0.0
    for piece_id in sorted(homeless, key=lambda each: -np.ptp(now.box(each)[:, 1])):
        low, high = now.box(piece_id)
        size = high - low
        if place[1] > corner[1] and place[1] + size[1] > top:
            place, width = np.array([place[0] + width + room, corner[1]]), 0.0
        motions[piece_id] = STAY.shifted(place - low)
        place = place + (0, size[1] + room)
        width = max(width, float(size[0]))
    return motions
