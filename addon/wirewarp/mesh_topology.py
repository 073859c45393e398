# SPDX-License-Identifier: GPL-3.0-or-later
"""Which elements of a mesh belong together, and its seams: the fast way to ask Blender.

Blender copies whole arrays only where the type is its own, and goes element by element otherwise. Its indices are
unsigned; from 4.0 on what it keeps for corners and seams is found among the attributes, but not in Edit Mode.
"""

import bpy
import numpy as np

from .foreach import read, read_attribute

SEAM = "uv_seam" if bpy.app.version >= (5, 0, 0) else ".uv_seam"


def edge_vertices(mesh: bpy.types.Mesh) -> np.ndarray:
    """(e,2) int32"""
    return _indices(mesh.edges, "vertices", 2)


def corner_vertices(mesh: bpy.types.Mesh) -> np.ndarray:
    """(l,) int32"""
    return _of_corners(mesh, ".corner_vert", "vertex_index")


def corner_edges(mesh: bpy.types.Mesh) -> np.ndarray:
    """(l,) int32, the edge from each corner to the next of its face."""
    return _of_corners(mesh, ".corner_edge", "edge_index")


def face_starts(mesh: bpy.types.Mesh) -> np.ndarray:
    """(f,) int32, the first corner of each face."""
    return _indices(mesh.polygons, "loop_start")


def face_sizes(mesh: bpy.types.Mesh) -> np.ndarray:
    """(f,) int32"""
    return _indices(mesh.polygons, "loop_total")


def triangle_corners(mesh: bpy.types.Mesh) -> np.ndarray:
    """(m,3) int32; as the next two, of a mesh whose triangles were calculated."""
    return _indices(mesh.loop_triangles, "loops", 3)


def triangle_vertices(mesh: bpy.types.Mesh) -> np.ndarray:
    """(m,3) int32"""
    return _indices(mesh.loop_triangles, "vertices", 3)


def triangle_faces(mesh: bpy.types.Mesh) -> np.ndarray:
    """(m,) int32"""
    return _indices(mesh.loop_triangles, "polygon_index")


def read_seams(mesh: bpy.types.Mesh) -> np.ndarray:
    """(e,) bool"""
    if not _has_attributes(mesh):
        return read(mesh.edges, "use_seam", bool)
    seams = read_attribute(mesh, SEAM, "BOOLEAN", "EDGE")
    return np.zeros(len(mesh.edges), dtype=bool) if seams is None else seams


def _indices(collection: bpy.types.bpy_prop_collection, name: str, columns: int = 1) -> np.ndarray:
    return read(collection, name, np.uint32, columns).view(np.int32)


def _of_corners(mesh: bpy.types.Mesh, attribute: str, name: str) -> np.ndarray:
    found = read_attribute(mesh, attribute, "INT", "CORNER") if _has_attributes(mesh) else None
    return _indices(mesh.loops, name) if found is None else found


def _has_attributes(mesh: bpy.types.Mesh) -> bool:
    return bpy.app.version >= (4, 0, 0) and not mesh.is_editmode
