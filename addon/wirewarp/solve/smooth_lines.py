# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth lines beside paths of edges, as what is to be cut into the mesh. No Blender in here."""

from dataclasses import dataclass
from itertools import pairwise
from types import ModuleType

import numpy as np
from numpy.typing import ArrayLike

from ..issues import ObjectError
from .arrays import MeshArrays
from .chains import edge_keys
from .flatten import issue_of_error, polygons_across
from .suggest import NoSeam, Pairs, diagonals, painted_at_edges

Point = tuple[int, int, float]  # at the first vertex + the number × (second - first); a vertex: twice, and 0


@dataclass(frozen=True)
class SmoothLine:
    points: list[Point]
    diagonals: dict[int, Pairs]  # of the polygons that it crosses: what makes triangles of them


def smooth_line(library: ModuleType, arrays: MeshArrays, path: list[int], kept: Pairs, no_seam: NoSeam) -> SmoothLine:
    """Return a smooth line beside a path of vertices inside a piece, with the same ends and crossings of kept edges.

    It enters only painted faces that the path enters. Edges of the path must not be seams. Raises ObjectError.
    """
    painted = (painted_at_edges(arrays, no_seam) > 0) | no_seam.vertices[arrays.edges].all(axis=1)
    painted &= ~np.isin(_keys(arrays.edges, arrays), _keys(list(pairwise(path)), arrays))
    seams = np.concatenate([arrays.seams, np.array(kept, dtype=np.int32).reshape(-1, 2), arrays.edges[painted]])
    try:
        wires = [library.Wire(wire.chain.vertices, wire.chain.tolerance) for wire in arrays.wires]
        ends, t = library.straighten_path(arrays.vertices, arrays.triangles, path, seams=seams, wires=wires)
    except library.FlattenError as error:
        raise ObjectError(issue_of_error(error, arrays)) from error
    return SmoothLine(list(zip(*ends.T.tolist(), t.tolist(), strict=True)), _crossed(ends, arrays))


def _crossed(ends: np.ndarray, arrays: MeshArrays) -> dict[int, Pairs]:
    """Of a line from point to point, ends (k,2): each stretch lies in the triangle of all its vertices."""
    stretches = [{*first, *second} for first, second in pairwise(ends.tolist())]
    near = np.flatnonzero(np.isin(arrays.triangles, ends).all(axis=1))
    polygon_of = {frozenset(arrays.triangles[row].tolist()): int(arrays.triangle_polygons[row]) for row in near}
    crossed = [polygon_of[frozenset(each)] for each in stretches if len(each) == 3]
    across = diagonals(arrays)
    followed = _keys([sorted(each) for each in stretches if len(each) == 2], arrays)
    polygons = polygons_across(across, arrays)
    crossed += polygons[np.isin(_keys(across, arrays), followed)].tolist()
    return {polygon: [tuple(pair) for pair in across[polygons == polygon].tolist()] for polygon in crossed}


def _keys(pairs: ArrayLike, arrays: MeshArrays) -> np.ndarray:
    return edge_keys(pairs, len(arrays.vertices))
