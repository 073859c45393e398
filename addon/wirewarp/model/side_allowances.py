# SPDX-License-Identifier: GPL-3.0-or-later
"""Seam allowances of one side of an edge alone, as they are marked on flat pieces.

A value on the face's corner, as scripts may write it (wirewarp_side_allowance), is blended when the edge is split, and
comes to lie on another edge when the face is turned over or mirrored. What is on edges and faces goes with them whole.
So both sides of an edge share the width in wirewarp_allowance, but for the side whose face has the number that is on
the edge (wirewarp_side and wirewarp_face INT, random, 0 none): its width is in wirewarp_side_width FLOAT.
"""

from collections.abc import Sequence

import bmesh
import bpy
import numpy as np

from ..blender.attributes import check_attribute
from ..blender.mesh import corner_edges, face_sizes, read_attribute
from ..names import ALLOWANCE, FACE, SIDE, SIDE_ALLOWANCE, SIDE_WIDTH
from ..solve.identity import new_id

_KINDS = {
    ALLOWANCE: ("FLOAT", "EDGE"),
    SIDE_WIDTH: ("FLOAT", "EDGE"),
    SIDE: ("INT", "EDGE"),
    FACE: ("INT", "FACE"),
    SIDE_ALLOWANCE: ("FLOAT", "CORNER"),
}


def check_allowances(mesh: bpy.types.Mesh) -> None:
    """Raises ObjectError if an attribute of our name has another type or domain."""
    for name, (data_type, domain) in _KINDS.items():
        check_attribute(mesh, name, data_type, domain)


def mark_sides(mesh: bpy.types.Mesh, edges: Sequence[int], faces: Sequence[int], width: float) -> int:
    """These edges get this width on the side of these faces, one for each; see model.allowances. In Object Mode.

    Returns how many did: where more than two faces meet, their sides have one width. Raises ObjectError.
    """
    check_allowances(mesh)
    both, side_widths = _where_set(_values(mesh, ALLOWANCE)), _values(mesh, SIDE_WIDTH)
    sides, numbers, corners = _values(mesh, SIDE), _values(mesh, FACE), _values(mesh, SIDE_ALLOWANCE)
    widths = _where_set(side_widths_of(mesh))
    loop_edges, loop_faces = corner_edges(mesh), np.repeat(np.arange(len(mesh.polygons)), face_sizes(mesh))
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
        if is_one_sided and not numbers[marked]:
            numbers[marked] = new_id()
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
        (FACE, numbers),
        (SIDE_ALLOWANCE, corners),
    ):
        _write(mesh, name, values)
    return count


def side_widths_of(mesh: bpy.types.Mesh) -> np.ndarray:
    """(l,) of the edge that begins at each corner, on the side of its face; 0 where nothing is marked for it alone.

    Of a mesh that is not in Edit Mode.
    """
    corners = _values(mesh, SIDE_ALLOWANCE).astype(np.float64)
    loop_edges = corner_edges(mesh)
    sides = _values(mesh, SIDE)[loop_edges]
    is_marked = (sides != 0) & (sides == np.repeat(_values(mesh, FACE), face_sizes(mesh)))
    return np.where(_is_set(corners) | ~is_marked, corners, _values(mesh, SIDE_WIDTH)[loop_edges])


def clear_sides(edit: bmesh.types.BMesh, edges: Sequence[bmesh.types.BMEdge]) -> None:
    """All sides of these edges have one width again. Of a mesh in Edit Mode."""
    side, corner = edit.edges.layers.int.get(SIDE), edit.loops.layers.float.get(SIDE_ALLOWANCE)
    for edge in edges:
        if side:
            edge[side] = 0
        if corner:
            for loop in edge.link_loops:
                loop[corner] = 0.0


def _is_set(widths: np.ndarray) -> np.ndarray:
    return np.isfinite(widths) & (widths != 0)


def _where_set(widths: np.ndarray) -> np.ndarray:
    """0 where they are none."""
    return np.where(_is_set(widths), widths, 0).astype(widths.dtype)


def _values(mesh: bpy.types.Mesh, name: str) -> np.ndarray:
    """Zeros where there is no such attribute."""
    data_type, domain = _KINDS[name]
    found = read_attribute(mesh, name, data_type, domain)
    if found is not None:
        return found
    count = {"EDGE": len(mesh.edges), "FACE": len(mesh.polygons), "CORNER": len(mesh.loops)}[domain]
    return np.zeros(count, dtype=np.int32 if data_type == "INT" else np.float32)


def _write(mesh: bpy.types.Mesh, name: str, values: np.ndarray) -> None:
    data_type, domain = _KINDS[name]
    if name not in mesh.attributes and values.any():
        mesh.attributes.new(name, data_type, domain)
    if name in mesh.attributes:
        mesh.attributes[name].data.foreach_set("value", values)
