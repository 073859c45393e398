# SPDX-License-Identifier: GPL-3.0-or-later
"""A flat mesh read back: of which elements of the model it is, as arrays, and whether its shape is kept."""

import bpy
import numpy as np

from ..blender.attributes import find_values, has_attributes
from ..blender.mesh import corner_edges, corner_vertices, edge_vertices, face_sizes, vertex_places
from ..issues import object_error
from ..names import FLAT_LENGTH, PIECE, PIECE_INDEX, SOURCE_CORNER, SOURCE_FACE, SOURCE_VERTEX
from ..solve.arrays import edge_lengths
from ..solve.outlines import FlatPieces, outline_of, signed_areas
from ..solve.report import ObjectReport
from .marked_mesh import read_marks
from .owners import find_flat_object, has_flat_object
from .record import read_record

OF_ELEMENTS = (SOURCE_VERTEX, SOURCE_CORNER, SOURCE_FACE, PIECE_INDEX, PIECE)  # what a flat mesh always has
# Of lengths in single precision, relative to the length and to the largest coordinate: pieces may have been moved.
LENGTH_ERROR, PLACE_ERROR = 1e-5, 1e-6


def is_flat_mesh(mesh: bpy.types.Mesh) -> bool:
    """Whether it holds flat pieces and nothing else, whatever became of their model. Of one not in Edit Mode."""
    if not len(mesh.polygons) or not has_attributes(mesh, *OF_ELEMENTS):
        return False
    return not vertex_places(mesh)[:, 2].any()


def read_flat_pieces(mesh: bpy.types.Mesh, scale: float = 1.0) -> FlatPieces:
    """In Blender units times `scale`. Of a mesh in Object Mode; what is gone is None. Raises ObjectError."""
    return FlatPieces(
        vertices=vertex_places(mesh)[:, :2].astype(np.float64) * scale,
        source_vertex=find_values(mesh, SOURCE_VERTEX),
        loop_vertices=corner_vertices(mesh),
        loop_edges=corner_edges(mesh),
        face_sizes=face_sizes(mesh),
        face_piece=find_values(mesh, PIECE_INDEX),
        piece_id=find_values(mesh, PIECE),
        source_face=find_values(mesh, SOURCE_FACE),
        edges=edge_vertices(mesh),
        marks=read_marks(mesh),
    )


def no_pieces_sentence(source: bpy.types.Object) -> str:
    return f'The flat pieces of this report are gone. Flatten "{source.name}" again.'


def pieces_of_report(source: bpy.types.Object, report: ObjectReport) -> tuple[bpy.types.Object, FlatPieces]:
    """The flat object of the model, in Object Mode. Raises ObjectError if there is none to this report."""
    flat = find_flat_object(source)
    if (
        not has_flat_object(source)
        or report.flat_object is None
        or not has_attributes(flat.data, PIECE_INDEX, SOURCE_VERTEX, SOURCE_FACE)
    ):
        raise object_error("no_flat_pieces", no_pieces_sentence(source))
    return flat, read_flat_pieces(flat.data)


def has_kept_shape(mesh: bpy.types.Mesh) -> bool:
    """Whether no vertex, edge or face is gone or new, no edge longer or shorter, and no piece flipped.

    Of a mesh with the attributes of flat pieces.
    """
    laid_out, record = find_values(mesh, FLAT_LENGTH), read_record(mesh)
    counts = [len(mesh.vertices), len(mesh.edges), len(mesh.polygons)]
    if laid_out is None or record is None or record.counts != counts:
        return False
    pieces = read_flat_pieces(mesh)
    now, then = signed_areas(pieces.vertices, outline_of(pieces)), np.array(record.areas)
    size = float(np.abs(pieces.vertices).max(initial=0))
    if len(now) != len(then) or np.any(np.abs(now - then) > np.abs(then) + PLACE_ERROR * size**2):
        return False  # mirrored, the difference is twice the area
    difference = np.abs(edge_lengths(pieces.vertices, pieces.edges) - laid_out)
    return bool(np.all(difference <= LENGTH_ERROR * laid_out + PLACE_ERROR * size))
