# SPDX-License-Identifier: GPL-3.0-or-later
"""Both sides of a seam on the flat pieces, walked in the same direction on the model."""

from dataclasses import dataclass

import numpy as np

from ..issues import object_error
from .chains import split_into_chains
from .outlines import FlatPieces, OutlineEdges

EDITED = "The flat pieces were edited by hand, and a seam of the model is missing on them. Flatten the model again."


@dataclass(frozen=True)
class SeamSide:
    """The sides of one seam start at the same vertex of the model."""

    piece: int
    vertices: list[int]  # of the flat pieces, in order
    edges: list[int]  # rows of the outline's edges between them

    def lengths(self, flat: FlatPieces) -> np.ndarray:
        """(k,) the length along the side from its start to each vertex."""
        points = flat.vertices[self.vertices]
        return np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])


def seam_sides(flat: FlatPieces, outline: OutlineEdges, seams: list[list]) -> list[list[list[SeamSide]]]:
    """Of each seam, given by its edges as vertex pairs of the model, its runs, and of each run the sides.

    Raises ObjectError where the outline does not go on as the seam does.
    """
    finder = _SeamFinder(flat, outline)
    return [finder.sides(seam) for seam in seams]


class _SeamFinder:
    """Finds the sides of seams given by edges of the model."""

    def __init__(self, flat: FlatPieces, outline: OutlineEdges) -> None:
        self._flat, self._outline = flat, outline
        self._by_source: dict[tuple[int, int], list[int]] = {}
        sources = np.sort(flat.source_vertex[outline.edges], axis=1)
        for row, pair in enumerate(map(tuple, sources.tolist())):
            self._by_source.setdefault(pair, []).append(row)

    def sides(self, seam_edges: list) -> list[list[SeamSide]]:
        """For each run of the seam's edges (vertex pairs of the model) its sides; of failed pieces there are none."""
        edges = np.array(seam_edges).reshape(-1, 2)
        runs = split_into_chains(edges, np.zeros((edges.max(initial=0) + 1, 3)))
        return [[self._walk(run.vertices, first) for first in self._rows(*run.vertices[:2])] for run in runs]

    def _rows(self, a: int, b: int) -> list[int]:
        return self._by_source.get((min(a, b), max(a, b)), [])

    def _walk(self, sources: list[int], first: int) -> SeamSide:
        """Along the model's vertices `sources`, in the piece that has the outline's edge `first`.

        Raises ObjectError where the outline does not go on as the seam does.
        """
        rows, vertices = [first], self._ends(first, sources[0])
        for a, b in zip(sources[1:-1], sources[2:], strict=True):
            row = next((row for row in self._rows(a, b) if self._ends(row, a)[0] == vertices[-1]), None)
            if row is None:
                raise object_error("edited_pieces", EDITED)
            rows.append(row)
            vertices.append(self._ends(row, a)[1])
        return SeamSide(int(self._outline.piece[first]), vertices, rows)

    def _ends(self, row: int, source: int) -> list[int]:
        """The two vertices of an edge, first the one that stands for this vertex of the model."""
        a, b = self._outline.edges[row].tolist()
        return [a, b] if self._flat.source_vertex[a] == source else [b, a]
