# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the flat pieces of a model are still true: neither it nor they have changed since."""

import bpy
import numpy as np

from ..blender.attributes import find_values, has_attributes
from ..issues import changed_error, object_error
from ..names import PIECE_INDEX, SOURCE_VERTEX
from ..solve.report import ObjectReport
from .changes import has_changed, shows_modified
from .flat_pieces import has_kept_shape
from .memory import read_anew
from .owners import check_not_edited, find_flat_object, has_flat_object
from .reports import pieces_report


def current_pieces(source: bpy.types.Object) -> tuple[ObjectReport, bpy.types.Object]:
    """The report and the flat object of a model in Object Mode. Raises ObjectError where they are not true any more."""
    report, flat = pieces_report(source), find_flat_object(source)
    if report is None or not has_flat_object(source) or report.flat_object is None:
        raise object_error("no_flat_pieces", f'"{source.name}" has no flat pieces: flatten it first.')
    check_not_edited(source)
    bpy.context.view_layer.update()
    if _has_changed(source, report):
        raise changed_error(source.name)
    if _is_edited(flat.data, report):
        raise object_error(
            "edited_pieces",
            f'The pieces in "{flat.name}" were edited by hand, so their lengths are no longer those of the model. '
            f'Flatten "{source.name}" again. Moving and turning whole pieces is fine.',
        )
    if not is_true_size(flat):
        raise object_error(
            "scaled_pieces",
            f'"{flat.name}" or its parent is scaled or mirrored, so it is not actual size. Clear the scale (Alt+S), or '
            f'scale "{source.name}" and flatten again.',
        )
    return report, flat


def _has_changed(source: bpy.types.Object, report: ObjectReport) -> bool:
    """Blender makes nothing of the modifiers of hidden objects, and less in Edit Mode."""
    if report.with_modifiers and not shows_modified(source):
        raise object_error(
            "not_visible",
            f'Show "{source.name}" in Object Mode first, so its modifiers can be checked.',
        )
    return has_changed(source, report.model_state, read_anew)


def _is_edited(mesh: bpy.types.Mesh, report: ObjectReport) -> bool:
    """Whether anything but the place of whole pieces is other than it was laid out."""
    if not has_attributes(mesh, PIECE_INDEX, SOURCE_VERTEX):
        return True
    pieces = find_values(mesh, PIECE_INDEX)
    faces = [piece.faces if piece.has_layout else 0 for piece in report.pieces]
    if np.any((pieces < 0) | (pieces >= len(faces))) or np.bincount(pieces, minlength=len(faces)).tolist() != faces:
        return True
    return not has_kept_shape(mesh)


def is_true_size(flat: bpy.types.Object) -> bool:
    """Whether the object is shown as its mesh is, neither scaled nor mirrored."""
    return np.allclose(flat.matrix_world.to_scale(), 1, rtol=0, atol=1e-5)
