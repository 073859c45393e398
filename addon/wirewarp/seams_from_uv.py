# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams along the borders of UV islands. Of meshes in Object Mode."""

from collections.abc import Sequence

import bpy
import numpy as np

from .foreach import read
from .issues import object_error
from .mesh_to_arrays import next_loops
from .mesh_topology import corner_edges, corner_vertices, read_seams
from .uv_islands import island_borders


def seams_from_uv(targets: Sequence[bpy.types.Object]) -> int:
    """Marks the borders of the active UV maps' islands; seams that are there stay. Returns the number of new ones.

    Raises ObjectError, with nothing marked, if one has no UV map.
    """
    for target in targets:
        if target.data.uv_layers.active is None:
            raise object_error("no_uv_map", f'"{target.name}" has no UV map: unwrap it first (UV > Unwrap).')
    return sum(_mark_borders(target.data) for target in targets)


def _mark_borders(mesh: bpy.types.Mesh) -> int:
    before = read_seams(mesh)
    borders = island_borders(
        corner_edges(mesh),
        corner_vertices(mesh),
        next_loops(mesh),
        read(mesh.uv_layers.active.data, "uv", np.float32, 2),
        len(mesh.edges),
    )
    mesh.edges.foreach_set("use_seam", before | borders)
    mesh.update()
    return int(np.count_nonzero(borders & ~before))
