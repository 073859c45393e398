# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams from the islands of a UV map."""

from collections.abc import Sequence

import bpy
import numpy as np

from .foreach import read
from .issues import object_error
from .mesh_to_arrays import next_loops
from .mesh_topology import corner_edges, corner_vertices, read_seams
from .uv_islands import island_borders
from .write_uv import UV_LAYER


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
    mesh.edges.foreach_set("use_seam", before | borders)
    mesh.update()
    return int(np.count_nonzero(borders & ~before))
