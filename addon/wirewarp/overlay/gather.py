# SPDX-License-Identifier: GPL-3.0-or-later
"""What the overlay shows of an object, as arrays: read from its mesh as it is seen, or in the plane of its map."""

from collections.abc import Iterator
from contextlib import contextmanager

import bmesh
import bpy
import numpy as np

from ..blender.mesh import (
    corner_edges,
    corner_vertices,
    edge_vertices,
    evaluated_mesh,
    face_sizes,
    faces_at_edges,
    next_loops,
    read,
    read_attribute,
    read_seams,
    triangle_corners,
    triangle_faces,
    triangle_vertices,
)
from ..flat.read import has_flat_attributes, read_flat_attribute
from ..model.attributes import read_edit_marks, read_marks, read_piece_ids
from ..names import PIECE, PIECE_INDEX, SEAM, SOURCE_VERTEX, UV_LAYER, WIRE
from .lines import LineEdges
from .surfaces import Triangles


def gather_lines(target: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> LineEdges:
    """Raises ObjectError if an attribute of our name is not ours."""
    if target.data.is_editmode:  # by another object of the same mesh, too
        return _lines_in_edit_mode(target.data)
    with shown_mesh(target, depsgraph) as mesh:
        return _lines(mesh)


@contextmanager
def shown_mesh(target: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> Iterator[bpy.types.Mesh]:
    """The mesh as modifiers and shape keys leave it. Of an object in Object Mode."""
    if target.modifiers or target.data.shape_keys:
        with evaluated_mesh(target, depsgraph) as mesh:
            yield mesh
    else:
        yield target.data


def _lines(mesh: bpy.types.Mesh) -> LineEdges:
    marks, seams = read_marks(mesh), read_seams(mesh)
    outlines = faces_at_edges(mesh) == 1
    rows = np.flatnonzero(seams | outlines | marks.are_wires)
    vertices = edge_vertices(mesh)[rows]
    source, pieces = vertices, np.zeros(len(rows), dtype=np.int32)
    if has_flat_attributes(mesh, SOURCE_VERTEX, PIECE_INDEX):
        source = read_flat_attribute(mesh, SOURCE_VERTEX)[vertices]
        pieces = _piece_of_edge(mesh)[rows]
    return LineEdges(
        ends=read(mesh.vertices, "co", np.float32, 3)[vertices],
        normals=read(mesh.vertices, "normal", np.float32, 3)[vertices[:, 0]],
        vertices=source,
        pieces=pieces,
        seams=seams[rows],
        seam_ids=_seam_ids(mesh)[rows],
        outlines=outlines[rows],
        marks=marks.take(rows),
        selected=np.zeros(len(rows), dtype=bool),
    )


def _seam_ids(mesh: bpy.types.Mesh) -> np.ndarray:
    """(e,) int32"""
    ids = read_attribute(mesh, SEAM, "INT", "EDGE")
    return np.zeros(len(mesh.edges), dtype=np.int32) if ids is None else ids


def _lines_in_edit_mode(mesh: bpy.types.Mesh) -> LineEdges:
    """In Edit Mode attributes can be read edge by edge only."""
    edit = bmesh.from_edit_mesh(mesh)
    edit.verts.index_update()
    wire, seam = edit.edges.layers.int.get(WIRE), edit.edges.layers.int.get(SEAM)
    source, piece = edit.verts.layers.int.get(SOURCE_VERTEX), edit.faces.layers.int.get(PIECE_INDEX)
    marked = [edge for edge in edit.edges if not edge.hide and (edge.seam or edge.is_boundary or (wire and edge[wire]))]
    vertices = [[vertex[source] if source else vertex.index for vertex in edge.verts] for edge in marked]
    return LineEdges(
        ends=np.array([[vertex.co[:] for vertex in edge.verts] for edge in marked], np.float32).reshape(-1, 2, 3),
        normals=np.array([edge.verts[0].normal[:] for edge in marked], np.float32).reshape(-1, 3),
        vertices=np.array(vertices, dtype=np.int32).reshape(-1, 2),
        pieces=np.array([_piece_in_edit_mode(edge, piece) for edge in marked], dtype=np.int32),
        seams=np.array([edge.seam for edge in marked], dtype=bool),
        seam_ids=np.array([edge[seam] if seam else 0 for edge in marked], dtype=np.int32),
        outlines=np.array([edge.is_boundary for edge in marked], dtype=bool),
        marks=read_edit_marks(edit, marked),
        selected=np.array([edge.select for edge in marked], dtype=bool),
    )


def _piece_in_edit_mode(edge: bmesh.types.BMEdge, layer: bmesh.types.BMLayerItem | None) -> int:
    return edge.link_faces[0][layer] if layer and edge.link_faces else 0


def _piece_of_edge(mesh: bpy.types.Mesh) -> np.ndarray:
    sizes = face_sizes(mesh)
    piece_of_edge = np.zeros(len(mesh.edges), dtype=np.int32)
    piece_of_edge[corner_edges(mesh)] = np.repeat(read_flat_attribute(mesh, PIECE_INDEX), sizes)
    return piece_of_edge


def gather_triangles(mesh: bpy.types.Mesh) -> Triangles:
    """Of a mesh that is not in Edit Mode."""
    mesh.calc_loop_triangles()
    return Triangles(
        positions=read(mesh.vertices, "co", np.float32, 3),
        vertices=triangle_vertices(mesh),
        corners=triangle_corners(mesh),
        polygons=triangle_faces(mesh),
    )


def shows_our_map(mesh: bpy.types.Mesh) -> bool:
    """Whether the UV editor shows the layer that flattening writes."""
    return mesh.uv_layers.active is not None and mesh.uv_layers.active.name == UV_LAYER


def gather_uv_lines(mesh: bpy.types.Mesh) -> LineEdges:
    """Marked edges as each of their faces has them in the map. Raises ObjectError if an attribute is not ours."""
    return _uv_lines_in_edit_mode(mesh) if mesh.is_editmode else _uv_lines(mesh)


def uv_places(mesh: bpy.types.Mesh) -> np.ndarray:
    """(l,3) float32, the place of each corner. Of a mesh in Object Mode."""
    places = np.zeros((len(mesh.loops), 3), dtype=np.float32)
    places[:, :2] = read(mesh.uv_layers[UV_LAYER].data, "uv", np.float32, 2)
    return places


def _uv_lines(mesh: bpy.types.Mesh) -> LineEdges:
    marks, seams, outlines = read_marks(mesh), read_seams(mesh), faces_at_edges(mesh) == 1
    edge_of_loop, following, places = corner_edges(mesh), next_loops(mesh), uv_places(mesh)
    sizes = face_sizes(mesh)
    loops = np.flatnonzero((seams | outlines | marks.are_wires)[edge_of_loop])
    rows = edge_of_loop[loops]
    corners = np.column_stack([loops, following[loops]])
    return LineEdges(
        ends=places[corners],
        normals=np.tile(np.array([0, 0, 1], dtype=np.float32), (len(loops), 1)),
        vertices=corner_vertices(mesh)[corners],
        pieces=np.repeat(read_piece_ids(mesh), sizes)[loops],
        seams=seams[rows],
        seam_ids=_seam_ids(mesh)[rows],
        outlines=outlines[rows],
        marks=marks.take(rows),
        selected=np.zeros(len(rows), dtype=bool),
    )


def _uv_lines_in_edit_mode(mesh: bpy.types.Mesh) -> LineEdges:
    edit = bmesh.from_edit_mesh(mesh)
    edit.verts.index_update()
    wire, seam = edit.edges.layers.int.get(WIRE), edit.edges.layers.int.get(SEAM)
    piece, uv = edit.faces.layers.int.get(PIECE), edit.loops.layers.uv[UV_LAYER]
    marked = [
        (edge, loop)
        for edge in edit.edges
        if edge.seam or edge.is_boundary or (wire and edge[wire])
        for loop in edge.link_loops
        if not loop.face.hide
    ]
    sides = [(loop, loop.link_loop_next) for _, loop in marked]
    return LineEdges(
        ends=np.array([[(*loop[uv].uv, 0.0) for loop in side] for side in sides], np.float32).reshape(-1, 2, 3),
        normals=np.tile(np.array([0, 0, 1], dtype=np.float32), (len(marked), 1)),
        vertices=np.array([[loop.vert.index for loop in side] for side in sides], np.int32).reshape(-1, 2),
        pieces=np.array([loop.face[piece] if piece else 0 for _, loop in marked], dtype=np.int32),
        seams=np.array([edge.seam for edge, _ in marked], dtype=bool),
        seam_ids=np.array([edge[seam] if seam else 0 for edge, _ in marked], dtype=np.int32),
        outlines=np.array([edge.is_boundary for edge, _ in marked], dtype=bool),
        marks=read_edit_marks(edit, [edge for edge, _ in marked]),
        selected=np.zeros(len(marked), dtype=bool),  # the map has a selection of its own
    )
