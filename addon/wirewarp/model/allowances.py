# SPDX-License-Identifier: GPL-3.0-or-later
"""Seam allowances that were marked on edges of the model.

wirewarp_allowance FLOAT, on edges, in Blender units: above 0 the width on all sides of the edge; below 0 nothing is
added, for the cloth lies double there (a fold) or stays raw. 0 is what Blender gives to edges that are new or come from
another mesh: as NaN and where there is no attribute, the pattern's default. Of a single side: see side_allowances.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import bmesh
import bpy
import numpy as np

from ..blender.mesh import corner_edges, corner_vertices, edge_vertices, read_attribute
from ..names import ALLOWANCE, SIDE_ALLOWANCE, SIDE_WIDTH
from .side_allowances import check_allowance_sides, check_allowances, clear_sides, side_widths_of

NONE = -1.0  # what stands on edges without allowance


@dataclass(frozen=True)
class MarkedAllowances:
    """Widths by vertex pairs, in Blender units; below 0 for none."""

    edges: np.ndarray  # (e,2)
    widths: np.ndarray  # (e,)
    sides: np.ndarray  # (s,2) directed as in their face
    side_widths: np.ndarray  # (s,)


def mark_selected(targets: Sequence[bpy.types.Object], width: float) -> tuple[int, int]:
    """The selected edges of seams and outlines get this width: NONE for none, 0 for the default.

    Of meshes in Edit Mode. Returns the numbers of edges that got it and of those that lie on no seam or outline. Raises
    ObjectError as check_allowances does.
    """
    for target in targets:
        check_allowances(target.data)
    counts = [_mark(target.data, width) for target in targets]
    return sum(marked for marked, _ in counts), sum(left_out for _, left_out in counts)


def _mark(mesh: bpy.types.Mesh, width: float) -> tuple[int, int]:
    edit = bmesh.from_edit_mesh(mesh)
    if ALLOWANCE not in edit.edges.layers.float:
        edit.edges.layers.float.new(ALLOWANCE)  # which makes references to edges invalid: they are taken afterwards
    layer = edit.edges.layers.float[ALLOWANCE]
    selected = [edge for edge in edit.edges if edge.select and not edge.hide]
    marked = [edge for edge in selected if edge.link_faces and (edge.seam or len(edge.link_faces) != 2)]
    for edge in marked:
        edge[layer] = width
    clear_sides(edit, marked)
    if marked:
        bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)
    return len(marked), len(selected) - len(marked)


def scale_allowances(mesh: bpy.types.Mesh, factor: float) -> None:
    """The marked widths become so many times as wide; none and the default stay. Of a mesh in Object Mode."""
    for name, domain in ((ALLOWANCE, "EDGE"), (SIDE_WIDTH, "EDGE"), (SIDE_ALLOWANCE, "CORNER")):
        widths = read_attribute(mesh, name, "FLOAT", domain)
        if widths is not None:
            scaled = np.where(widths > 0, widths * factor, widths)
            mesh.attributes[name].data.foreach_set("value", scaled.astype(np.float32))


def read_allowances(mesh: bpy.types.Mesh) -> MarkedAllowances:
    """Of a mesh that is not in Edit Mode. Raises ObjectError as check_allowance_sides does."""
    check_allowance_sides(mesh)
    edges, starts = edge_vertices(mesh), corner_vertices(mesh)
    sides = np.column_stack([starts, edges[corner_edges(mesh)].sum(axis=1) - starts])
    widths = read_attribute(mesh, ALLOWANCE, "FLOAT", "EDGE")
    side_widths = side_widths_of(mesh)
    return MarkedAllowances(*_set_ones(edges, widths), *_set_ones(sides, side_widths))


def widest_allowance(mesh: bpy.types.Mesh) -> float:
    """Of those marked, in Blender units; 0 where none is. Of a mesh that is not in Edit Mode."""
    places = (ALLOWANCE, "EDGE"), (SIDE_WIDTH, "EDGE"), (SIDE_ALLOWANCE, "CORNER")
    marked = [read_attribute(mesh, name, "FLOAT", domain) for name, domain in places]
    return max((float(each[np.isfinite(each)].max(initial=0.0)) for each in marked if each is not None), default=0.0)


def _set_ones(pairs: np.ndarray, widths: np.ndarray | None) -> tuple[np.ndarray, np.ndarray]:
    if widths is None:
        return np.empty((0, 2), dtype=np.int64), np.empty(0)
    is_set = np.isfinite(widths) & (widths != 0)
    return pairs[is_set].astype(np.int64), widths[is_set].astype(np.float64)
