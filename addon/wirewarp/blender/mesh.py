# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads and writes Blender's meshes as numpy arrays.

The arrays have a row for each of n vertices, e edges, f faces, l corners or m triangles. Places are float32, and
indices are int32.
"""

from collections.abc import Iterator
from contextlib import contextmanager

import bmesh
import bpy
import numpy as np

from ..solve.chains import next_corners

HAS_UV_ATTRIBUTES = bpy.app.version >= (3, 5, 0)
HAS_ATTRIBUTES = bpy.app.version >= (4, 0, 0)
# The attribute of seams is absent if no edge is a seam.
SEAM = "uv_seam" if bpy.app.version >= (4, 5, 0) else ".uv_seam"
IN_GROUP = 0.5  # least weight at which a vertex belongs to a vertex group, half of the full strength


def read(collection: bpy.types.bpy_prop_collection, name: str, dtype: type, columns: int = 1) -> np.ndarray:
    """Return one property of all elements, (k,) or (k, columns). Reading is fast only with the property's own dtype."""
    values: np.ndarray = np.empty(len(collection) * columns, dtype=dtype)
    collection.foreach_get(name, values)
    return values.reshape(-1, columns) if columns > 1 else values


_VALUES = {
    "BOOLEAN": ("value", bool, 1),
    "INT": ("value", np.int32, 1),
    "INT8": ("value", np.int8, 1),
    "FLOAT": ("value", np.float32, 1),
    "FLOAT_VECTOR": ("vector", np.float32, 3),
    "FLOAT_COLOR": ("color", np.float32, 4),
}


def read_attribute(mesh: bpy.types.Mesh, name: str, data_type: str, domain: str) -> np.ndarray | None:
    """Return the values (k,), (k,3) or (k,4) of an attribute; None if no attribute has this name, type and domain. The
    mesh must not be in Edit Mode."""
    attribute = mesh.attributes.get(name)
    if attribute is None or (attribute.data_type, attribute.domain) != (data_type, domain):
        return None
    return read(attribute.data, *_VALUES[data_type])


def groups_of(vertex: bpy.types.MeshVertex) -> set[int]:
    """Return the numbers of the vertex groups to which the vertex belongs."""
    return {element.group for element in vertex.groups if element.weight >= IN_GROUP}


def vertex_places(mesh: bpy.types.Mesh) -> np.ndarray:
    if not HAS_ATTRIBUTES or not len(mesh.vertices):
        return read(mesh.vertices, "co", np.float32, 3)
    return read(mesh.attributes["position"].data, "vector", np.float32, 3)


def edge_vertices(mesh: bpy.types.Mesh) -> np.ndarray:
    return _indices(mesh.edges, "vertices", 2)


def corner_vertices(mesh: bpy.types.Mesh) -> np.ndarray:
    return _of_corners(mesh, ".corner_vert", "vertex_index")


def corner_edges(mesh: bpy.types.Mesh) -> np.ndarray:
    """Return the edge from each corner to the next corner of its face, (l,) int32."""
    return _of_corners(mesh, ".corner_edge", "edge_index")


def face_starts(mesh: bpy.types.Mesh) -> np.ndarray:
    """Return the first corner of each face, (f,) int32."""
    return _indices(mesh.polygons, "loop_start")


def face_sizes(mesh: bpy.types.Mesh) -> np.ndarray:
    """Return the number of corners of each face, (f,) int32."""
    if not HAS_ATTRIBUTES:
        return _indices(mesh.polygons, "loop_total")
    return np.diff(face_starts(mesh), append=np.int32(len(mesh.loops)))


def triangle_corners(mesh: bpy.types.Mesh) -> np.ndarray:
    """Return the corners of each triangle, (m,3) int32. Call mesh.calc_loop_triangles() before triangle functions."""
    return _indices(mesh.loop_triangles, "loops", 3)


def triangle_vertices(mesh: bpy.types.Mesh) -> np.ndarray:
    return _indices(mesh.loop_triangles, "vertices", 3)


def triangle_faces(mesh: bpy.types.Mesh) -> np.ndarray:
    return _indices(mesh.loop_triangles, "polygon_index")


def read_seams(mesh: bpy.types.Mesh) -> np.ndarray:
    return _edge_flags(mesh, SEAM, "use_seam")


def read_selected_edges(mesh: bpy.types.Mesh) -> np.ndarray:
    return _edge_flags(mesh, ".select_edge", "select")


def read_hidden_edges(mesh: bpy.types.Mesh) -> np.ndarray:
    return _edge_flags(mesh, ".hide_edge", "hide")


def selected_edges(mesh: bpy.types.Mesh) -> np.ndarray:
    """Return the selected and visible edges (k,) of a mesh that is not in Edit Mode."""
    return np.flatnonzero(read_selected_edges(mesh) & ~read_hidden_edges(mesh))


def _edge_flags(mesh: bpy.types.Mesh, attribute: str, name: str) -> np.ndarray:
    """Return a mask (e,) of the edges with this flag. attribute: name of the attribute, which is absent if no edge has
    the flag; name: the property for Blender versions without such attributes."""
    if not HAS_ATTRIBUTES:
        return read(mesh.edges, name, bool)
    flags = read_attribute(mesh, attribute, "BOOLEAN", "EDGE")
    return np.zeros(len(mesh.edges), dtype=bool) if flags is None else flags


def read_uv(layer: bpy.types.MeshUVLoopLayer) -> np.ndarray:
    """Return the place of each corner in the map, (l,2) float32."""
    return read(layer.uv, "vector", np.float32, 2) if HAS_UV_ATTRIBUTES else read(layer.data, "uv", np.float32, 2)


def write_edited_uv(mesh: bpy.types.Mesh, name: str, places: np.ndarray) -> None:
    """Write (l,2) float32 to this UV map of a mesh in Edit Mode, and create the map if it is missing."""
    edit = bmesh.from_edit_mesh(mesh)
    layer = edit.loops.layers.uv.get(name) or edit.loops.layers.uv.new(name)
    corners = (corner for face in edit.faces for corner in face.loops)
    for corner, place in zip(corners, places.tolist(), strict=True):
        corner[layer].uv = place
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


def write_uv(layer: bpy.types.MeshUVLoopLayer, places: np.ndarray) -> None:
    """Write the place of each corner, (l,2) float32, in Object Mode."""
    if HAS_UV_ATTRIBUTES:
        layer.uv.foreach_set("vector", places.ravel())
    else:
        layer.data.foreach_set("uv", places.ravel())


def write_edges(mesh: bpy.types.Mesh, vertices: np.ndarray) -> None:
    """Write the vertices of each edge, (e,2) int32, in Object Mode."""
    mesh.edges.foreach_set("vertices", vertices.ravel().view(np.uint32))


def write_corners(mesh: bpy.types.Mesh, vertices: np.ndarray, edges: np.ndarray) -> None:
    """Write the vertex of each corner, and the edge to the next corner of its face, both (l,) int32, in Object Mode."""
    if HAS_ATTRIBUTES:
        mesh.attributes[".corner_vert"].data.foreach_set("value", vertices)
        found = mesh.attributes.get(".corner_edge") or mesh.attributes.new(".corner_edge", "INT", "CORNER")
        found.data.foreach_set("value", edges)
    else:
        mesh.loops.foreach_set("vertex_index", vertices.view(np.uint32))
        mesh.loops.foreach_set("edge_index", edges.view(np.uint32))


def write_faces(mesh: bpy.types.Mesh, starts: np.ndarray, sizes: np.ndarray) -> None:
    """Write the first corner and the number of corners of each face, (f,) int32, in Object Mode."""
    mesh.polygons.foreach_set("loop_start", starts.view(np.uint32))
    if not HAS_ATTRIBUTES:  # later versions of Blender derive the sizes from the starts
        mesh.polygons.foreach_set("loop_total", sizes.view(np.uint32))


def add_seams(mesh: bpy.types.Mesh, edges: np.ndarray) -> None:
    """Mark these edges (k,) as seams, in Object Mode. Other edges do not change."""
    _set_edge_flags(mesh, SEAM, "use_seam", edges, flag=True)


def remove_seams(mesh: bpy.types.Mesh, edges: np.ndarray) -> None:
    """Remove the seam marks of these edges (k,), in Object Mode. Other edges do not change."""
    _set_edge_flags(mesh, SEAM, "use_seam", edges, flag=False)


def add_sharp_edges(mesh: bpy.types.Mesh, edges: np.ndarray) -> None:
    """Mark these edges (k,) as sharp, in Object Mode. Other edges do not change."""
    _set_edge_flags(mesh, "sharp_edge", "use_edge_sharp", edges, flag=True)


def _set_edge_flags(mesh: bpy.types.Mesh, attribute: str, name: str, edges: np.ndarray, *, flag: bool) -> None:
    if HAS_ATTRIBUTES:
        flags = _edge_flags(mesh, attribute, name)
        flags[edges] = flag
        found = mesh.attributes.get(attribute) or mesh.attributes.new(attribute, "BOOLEAN", "EDGE")
        found.data.foreach_set("value", flags)
    else:
        for edge in edges.tolist():  # faster than writing the flags of all edges if few edges change
            setattr(mesh.edges[edge], name, flag)


def _indices(collection: bpy.types.bpy_prop_collection, name: str, columns: int = 1) -> np.ndarray:
    return read(collection, name, np.uint32, columns).view(np.int32)


def _of_corners(mesh: bpy.types.Mesh, attribute: str, name: str) -> np.ndarray:
    if not HAS_ATTRIBUTES or not len(mesh.loops):
        return _indices(mesh.loops, name)
    return read(mesh.attributes[attribute].data, "value", np.int32)


def faces_of_corners(mesh: bpy.types.Mesh) -> np.ndarray:
    """Return the face of each corner, (l,) int64."""
    return np.repeat(np.arange(len(mesh.polygons)), face_sizes(mesh))


def faces_at_edges(mesh: bpy.types.Mesh) -> np.ndarray:
    """Return the number of faces at each edge, (e,)."""
    return np.bincount(corner_edges(mesh), minlength=len(mesh.edges))


def next_loops(mesh: bpy.types.Mesh) -> np.ndarray:
    return next_corners(face_sizes(mesh))


def element_counts(mesh: bpy.types.Mesh) -> dict[str, int]:
    return {"vertices": len(mesh.vertices), "edges": len(mesh.edges), "faces": len(mesh.polygons)}


_copies: dict[int, bpy.types.Mesh] = {}  # copies in use, by the memory addresses of their objects


@contextmanager
def current_mesh(target: bpy.types.Object) -> Iterator[bpy.types.Mesh]:
    """Yield the object's mesh for reading; in Edit Mode a copy, because attributes cannot be read in Edit Mode.

    Nested calls for one object share one copy.
    """
    mesh, address = target.data, target.as_pointer()
    if not mesh.is_editmode:
        yield mesh
        return
    if address in _copies:
        yield _copies[address]
        return
    try:
        _copies[address] = copy = target.to_mesh()  # updates shape keys, as Blender does before each undo step
        bmesh.from_edit_mesh(mesh).to_mesh(copy)
        yield copy
    finally:
        _copies.pop(address, None)
        target.to_mesh_clear()


@contextmanager
def as_bmesh(mesh: bpy.types.Mesh) -> Iterator[bmesh.types.BMesh]:
    """Yield a bmesh with a copy of a mesh that is not in Edit Mode."""
    copied = bmesh.new()
    try:
        copied.from_mesh(mesh)
        yield copied
    finally:
        copied.free()


@contextmanager
def evaluated_mesh(source: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> Iterator[bpy.types.Mesh]:
    """Yield the object's mesh with its modifiers applied. Do not nest calls for one object, because the end of the
    inner call frees the mesh of both calls."""
    evaluated = source.evaluated_get(depsgraph)
    try:
        yield evaluated.to_mesh(preserve_all_data_layers=True, depsgraph=depsgraph)
    finally:
        evaluated.to_mesh_clear()
