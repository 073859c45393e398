# SPDX-License-Identifier: GPL-3.0-or-later
"""The outlines of a flat piece as chains between junctions, in millimeters: what is sewn, and what is not."""

from dataclasses import dataclass

import numpy as np

from .checks import problem
from .flat_piece import FlatPiece
from .geometry import lengths_along, signed_area

FARTHEST = 1e8  # millimeters from the origin: any fabric is smaller, and Clipper's integers hold 1000 times as much


@dataclass(frozen=True)
class Side:
    """One chain of an outline between junctions. The piece lies on the left."""

    piece: int
    sources: np.ndarray  # (k,) input vertices; a closed chain repeats its first
    points: np.ndarray  # (k,2)
    seam: int | None  # index into the result's seams; None where nothing is sewn to it
    is_turned: bool  # runs against the input's triangles: the piece is mirrored

    @property
    def is_closed(self) -> bool:
        """Whether it is a whole outline."""
        return bool(self.sources[0] == self.sources[-1] and np.array_equal(self.points[0], self.points[-1]))

    @property
    def along(self) -> np.ndarray:
        """(k,) length from the start to each point."""
        return lengths_along(self.points)


def outlines_of(index: int, piece: FlatPiece) -> list[list[Side]]:
    """The closed outlines of a piece, each as its chains in order; the outer one has positive area.

    index: of the piece. Raises FlattenError for a chain that is not on the outline, and for points that are no numbers.
    """
    points, ends = piece.vertices, _outline_edges(piece)
    if not np.isfinite(points[piece.outline]).all():
        raise problem(f'"{piece.name}" has NaN or infinite coordinates.')
    farthest = float(np.abs(points[piece.outline]).max())
    if farthest > FARTHEST:
        raise problem(
            f'"{piece.name}" reaches {farthest / 1e6:.4g} km far, and a pattern at most {FARTHEST / 1e6:g} km: see '
            "whether the unit of the model is right."
        )
    chains = []
    for chain in piece.chains:
        sources = chain.sources
        pairs = list(zip(sources[:-1].tolist(), sources[1:].tolist(), strict=True))
        if not all(pair in ends for pair in pairs):
            raise problem(f'The outline of "{piece.name}" does not run along the edges that it should.')
        vertices = [ends[pairs[0]][0], *(ends[pair][1] for pair in pairs)]
        if vertices[0] == vertices[-1]:  # all sides of a closed seam begin at one vertex
            first = int(np.argmin(sources[:-1]))
            sources, vertices = _rotated(sources, first), _rotated(np.array(vertices), first).tolist()
        chains.append((vertices, Side(index, sources, points[vertices], chain.seam, False)))
    loops = _joined(chains)
    areas = [signed_area(np.concatenate([side.points[:-1] for side in loop])) for loop in loops]
    return loops if sum(areas) > 0 else [[_turned(side) for side in reversed(loop)] for loop in loops]


def _rotated(closed: np.ndarray, first: int) -> np.ndarray:
    """A closed chain, its first repeated at the end, begun elsewhere."""
    return np.concatenate([closed[first:-1], closed[: first + 1]])


def _outline_edges(piece: FlatPiece) -> dict[tuple[int, int], tuple[int, int]]:
    """The piece's vertices at both ends of each outline edge, by the model's."""
    sources = piece.source_vertex[piece.outline]
    return {(a, b): (c, d) for (a, b), (c, d) in zip(sources.tolist(), piece.outline.tolist(), strict=True)}


def _joined(chains: list[tuple[list[int], Side]]) -> list[list[Side]]:
    """The chains, each after the one at whose last vertex it begins."""
    waiting: dict[int, list[tuple[list[int], Side]]] = {}
    for chain in chains:
        waiting.setdefault(chain[0][0], []).append(chain)
    loops = []
    while waiting:
        start = next(iter(waiting))
        at, loop = start, []
        while at in waiting:
            vertices, side = waiting[at].pop()
            if not waiting[at]:
                del waiting[at]
            loop.append(side)
            at = vertices[-1]
            if at == start:
                break
        loops.append(loop)
    return loops


def _turned(side: Side) -> Side:
    return Side(side.piece, side.sources[::-1], side.points[::-1], side.seam, True)
