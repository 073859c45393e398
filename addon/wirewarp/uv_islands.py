# SPDX-License-Identifier: GPL-3.0-or-later
"""Edges along which a UV map is cut. No Blender in here."""

import numpy as np

TOGETHER = 1e-4  # of the UV square's side: corners nearer than this are one, as in Blender's own islands


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
