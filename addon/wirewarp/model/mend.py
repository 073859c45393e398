# SPDX-License-Identifier: GPL-3.0-or-later
"""Mending meshes that cannot be flattened as they are, as Blender's own Clean Up does. Of meshes in Object Mode."""

from collections.abc import Callable

import bmesh
import bpy

CLOSE = 1e-5  # of the model's size; files write coordinates to five or six digits


def dissolve_faces_without_area(mesh: bpy.types.Mesh) -> int:
    """Returns by how many vertices and faces there are less, as the next does."""
    return _mend(mesh, lambda edit, close: bmesh.ops.dissolve_degenerate(edit, dist=close, edges=edit.edges))


def merge_close_vertices(mesh: bpy.types.Mesh) -> int:
    return _mend(mesh, lambda edit, close: bmesh.ops.remove_doubles(edit, verts=edit.verts, dist=close))


def _mend(mesh: bpy.types.Mesh, act: Callable[[bmesh.types.BMesh, float], object]) -> int:
    edit = bmesh.new()
    try:
        edit.from_mesh(mesh)
        before = len(edit.verts) + len(edit.faces)
        act(edit, CLOSE * max((max(abs(x) for x in vertex.co) for vertex in edit.verts), default=0.0))
        edit.to_mesh(mesh)
        mesh.update()
        return before - len(edit.verts) - len(edit.faces)
    finally:
        edit.free()
