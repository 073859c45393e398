# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a flat mesh, finds elements of the model on it, and checks whether it is still valid."""

import bpy
import numpy as np

from ..blender.attributes import find_values, has_attributes
from ..blender.mesh import corner_edges, corner_vertices, edge_vertices, face_sizes, vertex_places
from ..core import Elements
from ..issues import changed_error, object_error
from ..names import FLAT_LENGTH, PIECE, PIECE_INDEX, SOURCE_CORNER, SOURCE_FACE, SOURCE_VERTEX
from ..solve.arrays import edge_lengths
from ..solve.chains import are_among
from ..solve.outlines import FlatPieces, outline_of, signed_areas
from ..solve.report import ObjectReport
from .changes import has_changed, shows_modified
from .marked_mesh import read_marks
from .memory import read_anew
from .owners import check_not_edited, find_flat_object, has_flat_object
from .record import read_record
from .reports import pieces_report


def on_flat(elements: Elements, flat: FlatPieces) -> Elements:
    """Return the elements of the flat pieces that were made from these elements of the model. For an edge on
    a seam, return the edges on both sides."""
    in_piece = np.full(len(flat.face_piece), True) if elements.piece is None else flat.face_piece == elements.piece
    if elements.whole_piece:
        return Elements(faces=np.flatnonzero(in_piece))
    sources = flat.source_vertex
    reached = np.zeros(len(sources), dtype=bool)
    reached[flat.loop_vertices[np.repeat(in_piece, flat.face_sizes)]] = True
    wanted = are_among(sources[flat.edges], elements.edges)
    return Elements(
        vertices=np.flatnonzero(np.isin(sources, elements.vertices) & reached),
        edges=flat.edges[wanted & reached[flat.edges].all(axis=1)],
        faces=np.flatnonzero(np.isin(flat.source_face, elements.faces) & in_piece),
    )


OF_ELEMENTS = (SOURCE_VERTEX, SOURCE_CORNER, SOURCE_FACE, PIECE_INDEX, PIECE)  # attributes that a flat mesh always has
# These are tolerances of lengths, relative to the length and to the largest coordinate. The second is needed because
# single precision rounds the coordinates of pieces that were moved.
LENGTH_ERROR, PLACE_ERROR = 1e-5, 1e-6


def is_flat_mesh(mesh: bpy.types.Mesh) -> bool:
    """Return whether the mesh contains flat pieces in a plane, even if their model has changed. The mesh must not be in
    Edit Mode."""
    if not len(mesh.polygons) or not has_attributes(mesh, *OF_ELEMENTS):
        return False
    return not vertex_places(mesh)[:, 2].any()


def read_flat_pieces(mesh: bpy.types.Mesh, scale: float = 1.0) -> FlatPieces:
    """Return the pieces, with None for missing attributes. The mesh must not be in Edit Mode.

    scale: factor for lengths, which are in Blender units
    Raises ObjectError like read_marks.
    """
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
    return f'"{source.name}" has no flat pieces. Flatten it again.'  # its pieces were deleted, or the model is a copy


def pieces_of_report(source: bpy.types.Object, report: ObjectReport) -> tuple[bpy.types.Object, FlatPieces]:
    """Return the flat object of a model in Object Mode, and its pieces. Raises ObjectError if the report's pieces do
    not exist."""
    flat = find_flat_object(source)
    if (
        not has_flat_object(source)
        or report.flat_object is None
        or not has_attributes(flat.data, PIECE_INDEX, SOURCE_VERTEX, SOURCE_FACE)
    ):
        raise object_error("no_flat_pieces", no_pieces_sentence(source))
    return flat, read_flat_pieces(flat.data)


def has_kept_shape(mesh: bpy.types.Mesh) -> bool:
    """Return whether all elements of the flat mesh still exist, no edge has changed its length, and no piece is
    flipped."""
    laid_out, record = find_values(mesh, FLAT_LENGTH), read_record(mesh)
    counts = [len(mesh.vertices), len(mesh.edges), len(mesh.polygons)]
    if laid_out is None or record is None or record.counts != counts:
        return False
    pieces = read_flat_pieces(mesh)
    now, then = signed_areas(pieces.vertices, outline_of(pieces)), np.array(record.areas)
    size = float(np.abs(pieces.vertices).max(initial=0))
    if len(now) != len(then) or np.any(np.abs(now - then) > np.abs(then) + PLACE_ERROR * size**2):
        return False  # the signed area of a flipped piece differs by twice the area
    difference = np.abs(edge_lengths(pieces.vertices, pieces.edges) - laid_out)
    return bool(np.all(difference <= LENGTH_ERROR * laid_out + PLACE_ERROR * size))


def current_pieces(source: bpy.types.Object) -> tuple[ObjectReport, bpy.types.Object]:
    """Return the report and the flat object of a model in Object Mode. Raises ObjectError if the pieces are missing,
    outdated, edited by hand, or not in actual size."""
    report, flat = pieces_report(source), find_flat_object(source)
    if report is None or not has_flat_object(source) or report.flat_object is None:
        raise object_error("no_flat_pieces", f'"{source.name}" has no flat pieces. Flatten it first.')
    check_not_edited(source)
    bpy.context.view_layer.update()
    if report.with_modifiers and not shows_modified(source):
        sentence = f'Show "{source.name}" in Object Mode first, so its modifiers can be checked.'
        raise object_error("not_visible", sentence)
    if has_changed(source, report.model_state, read_anew):
        raise changed_error(source.name)
    if _is_edited(flat.data, report):
        raise object_error(
            "edited_pieces",
            f'The pieces in "{flat.name}" were edited by hand, so their lengths differ from the model. '
            f'Flatten "{source.name}" again. You may move and rotate only whole pieces.',
        )
    if not is_true_size(flat):
        raise object_error(
            "scaled_pieces",
            f'"{flat.name}" or its parent is scaled or mirrored, so it is not actual size. Clear the scale (Alt+S), or '
            f'scale "{source.name}" and flatten again.',
        )
    return report, flat


def _is_edited(mesh: bpy.types.Mesh, report: ObjectReport) -> bool:
    """Return whether the pieces differ, except in their places, from the pieces that Flatten wrote."""
    if not has_attributes(mesh, PIECE_INDEX, SOURCE_VERTEX):
        return True
    pieces = find_values(mesh, PIECE_INDEX)
    faces = [piece.faces if piece.has_layout else 0 for piece in report.pieces]
    if np.any((pieces < 0) | (pieces >= len(faces))) or np.bincount(pieces, minlength=len(faces)).tolist() != faces:
        return True
    return not has_kept_shape(mesh)


def is_true_size(flat: bpy.types.Object) -> bool:
    return np.allclose(flat.matrix_world.to_scale(), 1, rtol=0, atol=1e-5)
