# SPDX-License-Identifier: GPL-3.0-or-later
"""Seam allowances of one side of an edge alone, as they are marked on flat pieces.

Both sides of an edge share the width in wirewarp_allowance, but for the side whose face has the number that is on the
edge (wirewarp_side): its width is in wirewarp_side_width FLOAT. See sides.
"""

from collections.abc import Sequence

import bmesh
import bpy
import numpy as np

from ..blender.attributes import check_attribute
from ..blender.mesh import corner_edges, face_sizes
from ..names import ALLOWANCE, SIDE, SIDE_ALLOWANCE, SIDE_WIDTH
from .sides import SideNames, check_sides_told, is_set, number_faces, read_values, values_at_edges, write_values

_NAMES = SideNames(SIDE_WIDTH, SIDE, SIDE_ALLOWANCE)
_KINDS = _NAMES.kinds | {ALLOWANCE: ("FLOAT", "EDGE")}


def check_allowances(mesh: bpy.types.Mesh) -> None:
    """Raises ObjectError if an attribute of our name has another type or domain."""
    for name, (data_type, domain) in _KINDS.items():
        check_attribute(mesh, name, data_type, domain)


def mark_sides(mesh: bpy.types.Mesh, edges: Sequence[int], faces: Sequence[int], width: float) -> int:
    """These edges get this width on the side of these faces, one for each; see model.allowances. In Object Mode.

    Returns how many did: where more than two faces meet, their sides have one width. Raises ObjectError.
    """
    check_allowances(mesh)
    loop_edges, loop_faces = corner_edges(mesh), np.repeat(np.arange(len(mesh.polygons)), face_sizes(mesh))
    numbers = number_faces(mesh, loop_faces[np.isin(loop_edges, edges)])
    both, side_widths = _where_set(_values(mesh, ALLOWANCE)), _values(mesh, SIDE_WIDTH)
    sides, corners = _values(mesh, SIDE), _values(mesh, SIDE_ALLOWANCE)
    widths = _where_set(side_widths_of(mesh))
    order = np.argsort(loop_edges, kind="stable")
    starts = np.searchsorted(loop_edges[order], np.arange(len(mesh.edges) + 1))
    count = 0
    for edge, face in zip(edges, faces, strict=True):
        loops = order[starts[edge] : starts[edge + 1]]
        if len(loops) > 2:
            continue
        other = next((loop for loop in loops if loop_faces[loop] != face), None)
        opposite, beyond = (face, width) if other is None else (loop_faces[other], widths[other] or both[edge])
        # The default, which is 0, can only be what both share.
        marked, shared, alone = (face, beyond, width) if width else (opposite, width, beyond)
        is_one_sided = alone != shared
        both[edge], side_widths[edge], sides[edge] = shared, alone, numbers[marked] if is_one_sided else 0
        corners[loops] = 0
        widths[loops] = (
            np.where(loop_faces[loops] == marked, alone, 0) if is_one_sided else 0
        )  # the other side may follow
        count += 1
    for name, values in (
        (ALLOWANCE, both),
        (SIDE_WIDTH, side_widths),
        (SIDE, sides),
        (SIDE_ALLOWANCE, corners),
    ):
        _write(mesh, name, values)
    return count


def check_allowance_sides(mesh: bpy.types.Mesh) -> None:
    """Raises ObjectError as check_allowances does, and where it cannot be told which side an allowance is of."""
    check_allowances(mesh)
    check_sides_told(mesh, _NAMES, "allowance")


def side_widths_of(mesh: bpy.types.Mesh) -> np.ndarray:
    """(l,) of the edge that begins at each corner, on the side of its face; 0 where nothing is marked for it alone.

    Of a mesh that is not in Edit Mode.
    """
    corners = _values(mesh, SIDE_ALLOWANCE).astype(np.float64)
    marked = values_at_edges(mesh, _NAMES)
    return np.where(is_set(corners) | (marked == 0), corners, marked)


def clear_sides(edit: bmesh.types.BMesh, edges: Sequence[bmesh.types.BMEdge]) -> None:
    """All sides of these edges have one width again. Of a mesh in Edit Mode."""
    side, corner = edit.edges.layers.int.get(SIDE), edit.loops.layers.float.get(SIDE_ALLOWANCE)
    for edge in edges:
        if side:
            edge[side] = 0
        if corner:
            for loop in edge.link_loops:
                loop[corner] = 0.0


def _where_set(widths: np.ndarray) -> np.ndarray:
    """0 where they are none."""
    return np.where(is_set(widths), widths, 0).astype(widths.dtype)


def _values(mesh: bpy.types.Mesh, name: str) -> np.ndarray:
    """Zeros where there is no such attribute."""
    return read_values(mesh, name, *_KINDS[name])


def _write(mesh: bpy.types.Mesh, name: str, values: np.ndarray) -> None:
    write_values(mesh, name, values, *_KINDS[name])
