# SPDX-License-Identifier: GPL-3.0-or-later
"""The borders of the islands of a UV map."""

import numpy as np

from .arrays import MeshArrays

TOGETHER = 1e-4  # of the UV square's side: corners nearer than this are one, as in Blender's own islands


def new_seams(arrays: MeshArrays) -> np.ndarray:
    """(k,) the edges between islands of the model's own UV map that are not seams yet; none without such a map."""
    if not arrays.own_map:
        return np.empty(0, dtype=np.int32)
    following = np.arange(1, len(arrays.loop_edges) + 1)
    following[arrays.polygon_starts + arrays.polygon_sizes - 1] = arrays.polygon_starts
    uv = arrays.uv_maps[arrays.own_map]
    borders = island_borders(arrays.loop_edges, arrays.loop_vertices, following, uv, len(arrays.edges))
    return np.setdiff1d(np.flatnonzero(borders), arrays.seam_edges).astype(np.int32)


def island_borders(
    loop_edges: np.ndarray, loop_vertices: np.ndarray, next_loops: np.ndarray, uv: np.ndarray, edge_count: int
) -> np.ndarray:
    """A mask (e,) of the edges whose faces do not lie side by side in the map; edges of one face are none.

    For each corner (loop): its edge, vertex, the next corner of its face, and its place uv (l,2) in the map.
    """
    turned = loop_vertices > loop_vertices[next_loops]
    ends = np.column_stack([uv, uv[next_loops]])  # (l,4): the edge's side of this face in the map
    ends[turned] = ends[turned][:, [2, 3, 0, 1]]  # from the lower vertex to the higher one
    lowest, highest = np.full((edge_count, 4), np.inf), np.full((edge_count, 4), -np.inf)
    np.minimum.at(lowest, loop_edges, ends)
    np.maximum.at(highest, loop_edges, ends)
    return (highest - lowest > TOGETHER).any(axis=1)
