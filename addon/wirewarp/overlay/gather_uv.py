# SPDX-License-Identifier: GPL-3.0-or-later
"""What the overlay shows of an object in the UV editor, as arrays in the plane of its map."""

import bmesh
import bpy
import numpy as np

from ..foreach import read
from ..mesh_to_arrays import faces_at_edges, next_loops
from ..mesh_topology import corner_edges, corner_vertices, face_sizes, read_seams
from ..pieces.attribute import PIECE, read_piece_ids
from ..wire_attributes import TOLERANCE, WIRE, read_marks
from ..write_uv import UV_LAYER
from .line_marks import LineMarks


def shows_our_map(mesh: bpy.types.Mesh) -> bool:
    """Whether the UV editor shows the layer that flattening writes."""
    return mesh.uv_layers.active is not None and mesh.uv_layers.active.name == UV_LAYER


def gather_uv_lines(mesh: bpy.types.Mesh) -> LineMarks:
    """Marked edges as each of their faces has them in the map. Raises ObjectError if an attribute is not ours."""
    return _lines_in_edit_mode(mesh) if mesh.is_editmode else _lines(mesh)


def uv_places(mesh: bpy.types.Mesh) -> np.ndarray:
    """(l,3) float32, the place of each corner. Of a mesh in Object Mode."""
    places = np.zeros((len(mesh.loops), 3), dtype=np.float32)
    places[:, :2] = read(mesh.uv_layers[UV_LAYER].data, "uv", np.float32, 2)
    return places


def _lines(mesh: bpy.types.Mesh) -> LineMarks:
    marks, seams, outlines = read_marks(mesh), read_seams(mesh), faces_at_edges(mesh) == 1
    edge_of_loop, following, places = corner_edges(mesh), next_loops(mesh), uv_places(mesh)
    sizes = face_sizes(mesh)
    loops = np.flatnonzero((seams | outlines | (marks.wire_ids != 0))[edge_of_loop])
    rows = edge_of_loop[loops]
    corners = np.column_stack([loops, following[loops]])
    return LineMarks(
        ends=places[corners],
        normals=np.tile(np.array([0, 0, 1], dtype=np.float32), (len(loops), 1)),
        vertices=corner_vertices(mesh)[corners],
        pieces=np.repeat(read_piece_ids(mesh), sizes)[loops],
        seams=seams[rows],
        outlines=outlines[rows],
        wire_ids=marks.wire_ids[rows],
        tolerances=marks.tolerances[rows],
        selected=np.zeros(len(rows), dtype=bool),
    )


def _lines_in_edit_mode(mesh: bpy.types.Mesh) -> LineMarks:
    edit = bmesh.from_edit_mesh(mesh)
    edit.verts.index_update()
    wire, tolerance = edit.edges.layers.int.get(WIRE), edit.edges.layers.float.get(TOLERANCE)
    piece, uv = edit.faces.layers.int.get(PIECE), edit.loops.layers.uv[UV_LAYER]
    marked = [
        (edge, loop)
        for edge in edit.edges
        if edge.seam or edge.is_boundary or (wire and edge[wire])
        for loop in edge.link_loops
        if not loop.face.hide
    ]
    sides = [(loop, loop.link_loop_next) for _, loop in marked]
    return LineMarks(
        ends=np.array([[(*loop[uv].uv, 0.0) for loop in side] for side in sides], np.float32).reshape(-1, 2, 3),
        normals=np.tile(np.array([0, 0, 1], dtype=np.float32), (len(marked), 1)),
        vertices=np.array([[loop.vert.index for loop in side] for side in sides], np.int32).reshape(-1, 2),
        pieces=np.array([loop.face[piece] if piece else 0 for _, loop in marked], dtype=np.int32),
        seams=np.array([edge.seam for edge, _ in marked], dtype=bool),
        outlines=np.array([edge.is_boundary for edge, _ in marked], dtype=bool),
        wire_ids=np.array([edge[wire] if wire else 0 for edge, _ in marked], dtype=np.int32),
        tolerances=np.array([edge[tolerance] if tolerance else 0 for edge, _ in marked], dtype=np.float32),
        selected=np.zeros(len(marked), dtype=bool),  # the map has a selection of its own
    )
