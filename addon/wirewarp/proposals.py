# SPDX-License-Identifier: GPL-3.0-or-later
"""The seams and tolerances that the library proposes, as edges of the model. No Blender in here."""

import math
from collections.abc import Iterable
from itertools import pairwise

import numpy as np

from .edge_keys import edge_keys
from .issues import LooserWire
from .mesh_arrays import MeshArrays


def seams_on_edges(proposed: Iterable[tuple[int, int]], arrays: MeshArrays) -> list[tuple[int, int]]:
    """The proposed vertex pairs as edges of the mesh, each once.

    The library sees triangles: a pair that is the diagonal of a face goes round the face instead, the shorter way.
    """
    pairs = np.asarray(list(proposed), dtype=np.int64).reshape(-1, 2)
    count = len(arrays.vertices)
    is_edge = np.isin(edge_keys(pairs, count), edge_keys(arrays.edges, count))
    edges = pairs[is_edge].tolist()
    for diagonal, polygon in zip(pairs[~is_edge], _polygons_of(pairs[~is_edge], arrays), strict=True):
        edges += pairwise(_way_round(diagonal, polygon, arrays))
    return list(dict.fromkeys((min(pair), max(pair)) for pair in edges))


def _polygons_of(diagonals: np.ndarray, arrays: MeshArrays) -> np.ndarray:
    """The polygon that each pair of vertices (k,2) is a diagonal of."""
    count = len(arrays.vertices)
    sides = edge_keys(arrays.triangles[:, [0, 1, 1, 2, 2, 0]], count)
    order = np.argsort(sides)
    found = order[np.searchsorted(sides[order], edge_keys(diagonals, count))]
    return arrays.triangle_polygons[found // 3]


def _way_round(diagonal: np.ndarray, polygon: int, arrays: MeshArrays) -> list[int]:
    """The vertices of a polygon from one end of its diagonal to the other."""
    start = arrays.polygon_starts[polygon]
    corners = arrays.loop_vertices[start : start + arrays.polygon_sizes[polygon]].tolist()
    first, last = sorted(corners.index(vertex) for vertex in diagonal)
    ways = corners[first : last + 1], corners[last:] + corners[: first + 1]
    return min(ways, key=lambda way: np.linalg.norm(np.diff(arrays.vertices[way], axis=0), axis=1).sum())


def looser_wires(proposed: Iterable[tuple[int, float]], arrays: MeshArrays) -> list[LooserWire]:
    """The proposed pairs of a wire's index and its tolerance."""
    return [
        LooserWire(wire.name, round_up(tolerance), list(pairwise(wire.chain.vertices)))
        for wire, tolerance in ((arrays.wires[index], tolerance) for index, tolerance in proposed)
    ]


def round_up(tolerance: float) -> float:
    """To three digits, as the panel shows tolerances: never less than what is needed. inf (free) stays."""
    if math.isinf(tolerance):
        return tolerance
    step = 10.0 ** (math.floor(math.log10(tolerance)) - 2)
    return float(f"{math.ceil(tolerance / step - 1e-9) * step:.3g}")
