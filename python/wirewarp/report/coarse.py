# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds corners of outlines that would be curves if the model were finer."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from .. import Piece
from .model import Hint

COARSE = "coarse"
COARSE_ADVICE = (
    "The model is coarse here, so curves are cut with corners. A Subdivision Surface modifier makes them smooth, with "
    "equal lengths on both sides of seams"
)
LEAST_TURN = np.radians(15.0)  # radians at one vertex; a line with smaller turns looks round on fabric
LEAST_ERROR = 1e-3  # meters between a curve and the middle of an edge; scissors cannot follow a line more closely
# A larger turn, in radians, counts as an intended corner, because a curve with such turns could not be recognized.
CORNER = np.radians(60.0)
# On a curve, one of the neighbors of a vertex turns in the same direction, by at least this share of the vertex's turn.
# Beside a corner, the line is straight.
ALIKE = 0.5


def coarse_hints(pieces: Sequence[Piece], meters: float) -> list[Hint]:
    """Return one hint about all corners, or no hint. pieces: pieces with a layout. meters: meters in a unit of the
    model."""
    turns: dict[int, float] = {}
    for piece in pieces:
        for sources, points in _outlines(piece):
            for row, turn in _curved(meters * points):
                vertex = int(sources[row])
                turns[vertex] = max(turns.get(vertex, 0.0), turn)
    if not turns:
        return []
    largest = np.degrees(max(turns.values()))
    short = f"{len(turns)} {'corner' if len(turns) == 1 else 'corners'} of up to {largest:.0f}°"
    return [Hint(COARSE, f"{COARSE_ADVICE}.", short=short, vertices=sorted(turns))]


def _outlines(piece: Piece) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield the vertices of the model (k,) and their places (k,2) for each section of the outline.

    A closed outline has one more point at each end, so that each vertex has two neighbors.
    """
    faces = np.asarray(piece.faces, dtype=np.int64)
    sides = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    # Both sides of a slit of one edge have the same vertices, so places are found by the sides of triangles.
    ends = dict(zip(map(tuple, piece.source_vertex[sides].tolist()), sides.tolist(), strict=True))
    for chain in piece.boundaries:
        steps = [ends[step] for step in pairwise(chain.vertices.tolist())]
        rows = [steps[0][0], *(end for _, end in steps)]
        if rows[0] == rows[-1]:  # true for a whole outline, which is closed
            rows = [rows[-2], *rows, rows[1]]
        yield piece.source_vertex[rows], piece.vertices[rows]


def _curved(points: np.ndarray) -> Iterator[tuple[int, float]]:
    """Yield the rows of points (k,2) at which a curve has a visible corner, and the turns there in radians. points: in
    meters."""
    along = np.diff(points, axis=0)
    lengths = np.linalg.norm(along, axis=1)
    crossed = along[:-1, 0] * along[1:, 1] - along[:-1, 1] * along[1:, 0]
    turns = np.arctan2(crossed, (along[:-1] * along[1:]).sum(axis=1))
    beside = np.pad(turns, 1)
    for row, turn in enumerate(turns):
        neighbors = np.array([beside[row], beside[row + 2]]) * np.sign(turn)
        is_curved = (neighbors >= ALIKE * abs(turn)) & (neighbors <= CORNER)
        # This is the distance between the middle of an edge and the arc through its ends. The arc turns by `turn`.
        error = max(lengths[row], lengths[row + 1]) * np.tan(abs(turn) / 4) / 2
        if LEAST_TURN < abs(turn) <= CORNER and error > LEAST_ERROR and is_curved.any():
            yield row + 1, float(abs(turn))
