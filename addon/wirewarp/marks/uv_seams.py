# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams from the islands of a UV map."""

from collections.abc import Sequence

import bpy
import numpy as np

from ..blender.mesh import add_seams, corner_edges, corner_vertices, next_loops, read, read_seams
from ..issues import object_error
from ..names import UV_LAYER

TOGETHER = 1e-4  # of the UV square's side: corners nearer than this are one, as in Blender's own islands


def seams_from_uv(targets: Sequence[bpy.types.Object]) -> tuple[int, list[str]]:
    """Marks the borders of the islands of each object's map; seams that are there stay.

    Returns the number of new ones, and the names of the maps. Raises ObjectError, with nothing marked, if one has no UV
    map.
    """
    maps = [_find_map(target) for target in targets]
    count = sum(_mark_borders(target.data, layer) for target, layer in zip(targets, maps, strict=True))
    return count, list(dict.fromkeys(layer.name for layer in maps))


def _find_map(target: bpy.types.Object) -> bpy.types.MeshUVLoopLayer:
    """The active map, which after Flatten is that of the flat pieces: then the user's own, if there is one.

    Of several own ones, the one to render with.
    """
    active, others = target.data.uv_layers.active, [each for each in target.data.uv_layers if each.name != UV_LAYER]
    if active is None:
        raise object_error("no_uv_map", f'"{target.name}" has no UV map: unwrap it first (UV > Unwrap).')
    if active.name != UV_LAYER or not others:
        return active
    return next((each for each in others if each.active_render), others[0])


def _mark_borders(mesh: bpy.types.Mesh, layer: bpy.types.MeshUVLoopLayer) -> int:
    before = read_seams(mesh)
    borders = island_borders(
        corner_edges(mesh),
        corner_vertices(mesh),
        next_loops(mesh),
        read(layer.data, "uv", np.float32, 2),
        len(mesh.edges),
    )
    add_seams(mesh, np.flatnonzero(borders))
    mesh.update()
    return int(np.count_nonzero(borders & ~before))


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
