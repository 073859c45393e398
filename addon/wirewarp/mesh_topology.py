# SPDX-License-Identifier: GPL-3.0-or-later
"""Which elements of a mesh belong together, read and written fast.

Blender copies whole arrays only where the type is its own, and goes element by element otherwise. Its indices are
unsigned. From 4.0 on, what it keeps at corners and edges is found among the attributes, but not in Edit Mode.
"""

import bpy
import numpy as np

from .foreach import read, read_attribute

HAS_ATTRIBUTES = bpy.app.version >= (4, 0, 0)
SEAM = "uv_seam" if bpy.app.version >= (4, 5, 0) else ".uv_seam"  # absent where there is no seam


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
    if mesh.is_editmode or not HAS_ATTRIBUTES:
        return read(mesh.edges, "use_seam", bool)
    seams = read_attribute(mesh, SEAM, "BOOLEAN", "EDGE")
    return np.zeros(len(mesh.edges), dtype=bool) if seams is None else seams


def write_corner_vertices(mesh: bpy.types.Mesh, vertices: np.ndarray) -> None:
    """(l,) int32; as all that follow, of a mesh in Object Mode."""
    if HAS_ATTRIBUTES:
        mesh.attributes[".corner_vert"].data.foreach_set("value", vertices)
    else:
        mesh.loops.foreach_set("vertex_index", vertices.view(np.uint32))


def write_faces(mesh: bpy.types.Mesh, starts: np.ndarray, sizes: np.ndarray) -> None:
    """(f,) int32"""
    mesh.polygons.foreach_set("loop_start", starts.view(np.uint32))
    if not HAS_ATTRIBUTES:  # later versions know the sizes from the starts
        mesh.polygons.foreach_set("loop_total", sizes.view(np.uint32))


def write_sharp_edges(mesh: bpy.types.Mesh, sharp: np.ndarray) -> None:
    """(e,) bool"""
    if HAS_ATTRIBUTES:
        found = mesh.attributes.get("sharp_edge") or mesh.attributes.new("sharp_edge", "BOOLEAN", "EDGE")
        found.data.foreach_set("value", sharp)
    else:
        mesh.edges.foreach_set("use_edge_sharp", sharp)


def _indices(collection: bpy.types.bpy_prop_collection, name: str, columns: int = 1) -> np.ndarray:
    return read(collection, name, np.uint32, columns).view(np.int32)


def _of_corners(mesh: bpy.types.Mesh, attribute: str, name: str) -> np.ndarray:
    if mesh.is_editmode or not HAS_ATTRIBUTES or not len(mesh.loops):
        return _indices(mesh.loops, name)
    return read(mesh.attributes[attribute].data, "value", np.int32)
