# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixes meshes that cannot be flattened as they are, as Blender's own Clean Up does, in Object Mode."""

from collections.abc import Callable

import bmesh
import bpy
import numpy as np

CLOSE = 1e-5  # of the model's size; files write coordinates to five or six digits
ROUNDED = 5e-7  # of the largest coordinate: two roundings to single precision on either side


def dissolve_faces_without_area(mesh: bpy.types.Mesh) -> int:
    """Returns by how many vertices and faces there are less, as the next does."""
    return _mend(mesh, lambda edit, close: bmesh.ops.dissolve_degenerate(edit, dist=close, edges=edit.edges))


def merge_close_vertices(mesh: bpy.types.Mesh) -> int:
    return _mend(mesh, lambda edit, close: bmesh.ops.remove_doubles(edit, verts=edit.verts, dist=close))


def recalculate_normals(mesh: bpy.types.Mesh) -> int:
    """Turns faces so that all look to one side, outward if they enclose something. Returns how many were turned."""
    edit = bmesh.new()
    try:
        edit.from_mesh(mesh)
        before = [face.normal.copy() for face in edit.faces]
        bmesh.ops.recalc_face_normals(edit, faces=edit.faces)
        edit.to_mesh(mesh)
        mesh.update()
        return sum(face.normal.dot(normal) < 0 for face, normal in zip(edit.faces, before, strict=True))
    finally:
        edit.free()


def _mend(mesh: bpy.types.Mesh, act: Callable[[bmesh.types.BMesh, float], object]) -> int:
    edit = bmesh.new()
    try:
        edit.from_mesh(mesh)
        before = len(edit.verts) + len(edit.faces)
        act(edit, _close_distance(edit))
        edit.to_mesh(mesh)
        mesh.update()
        return before - len(edit.verts) - len(edit.faces)
    finally:
        edit.free()


def _close_distance(edit: bmesh.types.BMesh) -> float:
    """By the size of the model, wherever it lies, but no less than the rounding of coordinates so large."""
    places = np.array([vertex.co for vertex in edit.verts]).reshape(-1, 3)
    if not len(places):
        return 0.0
    return max(CLOSE * float(np.ptp(places, axis=0).max()), ROUNDED * float(np.abs(places).max()))
