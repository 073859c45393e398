# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams from the islands of a UV map."""

from collections.abc import Sequence

import bpy
import numpy as np

from ..blender.mesh import add_seams, corner_edges, corner_vertices, next_loops, read_seams, read_uv
from ..issues import object_error
from ..solve.uv_islands import island_borders
from ..state.read_model import own_uv_map


def seams_from_uv(targets: Sequence[bpy.types.Object]) -> tuple[int, list[str]]:
    """Marks the borders of the islands of each object's map; seams that are there stay.

    Returns the number of new ones, and the names of the maps. Raises ObjectError, with nothing marked, if one has no UV
    map.
    """
    maps = [_find_map(target) for target in targets]
    count = sum(_mark_borders(target.data, layer) for target, layer in zip(targets, maps, strict=True))
    return count, list(dict.fromkeys(layer.name for layer in maps))


def _find_map(target: bpy.types.Object) -> bpy.types.MeshUVLoopLayer:
    """The user's own map, or that of the flat pieces if there is no other."""
    found = own_uv_map(target.data) or target.data.uv_layers.active
    if found is None:
        raise object_error("no_uv_map", f'"{target.name}" has no UV map: unwrap it first (UV > Unwrap).')
    return found


def _mark_borders(mesh: bpy.types.Mesh, layer: bpy.types.MeshUVLoopLayer) -> int:
    before = read_seams(mesh)
    borders = island_borders(
        corner_edges(mesh),
        corner_vertices(mesh),
        next_loops(mesh),
        read_uv(layer),
        len(mesh.edges),
    )
    add_seams(mesh, np.flatnonzero(borders))
    mesh.update()
    return int(np.count_nonzero(borders & ~before))
