# SPDX-License-Identifier: GPL-3.0-or-later
"""The pattern of a model's flat pieces, as they lie in their object; only of pieces that may be cut."""

import bpy
import numpy as np

from ..blender.cache import read_anew
from ..blender.units import length_text, meters_per_blender_unit
from ..issues import changed_error, object_error
from ..model.owners import check_not_edited, find_flat_object, has_flat_object
from ..model.state import has_changed, shows_modified
from ..model.wire_names import names_of
from ..names import PIECE_INDEX, SOURCE_VERTEX
from ..pattern.make import PieceLabel, make_pattern
from ..pattern.pattern import IMPERIAL, METRIC, Pattern
from .object import is_true_size
from .read import has_flat_attributes, has_kept_shape, read_flat_attribute, read_flat_pieces
from .reports import pieces_report


def read_pattern(scene: bpy.types.Scene, source: bpy.types.Object, spacing: float, failed_too: bool) -> Pattern:
    """Of a model, in Object Mode. spacing: of notches along seams, in millimeters; failed_too: pieces with errors too.

    Raises ObjectError where there are no pieces, or none that are true.
    """
    report, flat = _current_pieces(source)
    failed = [piece["name"] for piece in report["pieces"] if not piece["ok"]]
    if failed and not failed_too:
        raise object_error(
            "failed_pieces",
            f"Failed: {', '.join(failed)}. See the report for what is wrong, or choose Failed Pieces to export them "
            "anyway.",
        )
    text, millimeters = length_text(scene), 1000 * meters_per_blender_unit(scene)
    labels = {
        piece["index"]: PieceLabel(piece["name"], (piece["name"], text.area(piece["area_2d"])))
        for piece in report["pieces"]
        if piece["has_layout"]
    }
    seams = [seam["edges"] for seam in report["seams"]]
    pieces = read_flat_pieces(flat.data, millimeters)
    wire_ids = np.unique(pieces.marks.wire_ids[pieces.marks.rows]).tolist()
    names = names_of(source.data, wire_ids) | {wire["wire_id"]: wire["name"] for wire in report["wires"]}
    ruler = IMPERIAL if scene.unit_settings.system == "IMPERIAL" else METRIC
    return make_pattern(source.name, pieces, labels, names, seams, spacing, ruler)


def _current_pieces(source: bpy.types.Object) -> tuple[dict, bpy.types.Object]:
    report, flat = pieces_report(source), find_flat_object(source)
    if report is None or not has_flat_object(source) or "flat_object" not in report:
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
            f'"{flat.name}" or its parent is scaled or mirrored, so it is not true size. Clear the scale (Alt+S), or '
            f'scale "{source.name}" and flatten again.',
        )
    return report, flat


def _has_changed(source: bpy.types.Object, report: dict) -> bool:
    """Blender makes nothing of the modifiers of hidden objects, and less in Edit Mode."""
    if report.get("with_modifiers") and not shows_modified(source):
        raise object_error(
            "not_visible",
            f'Show "{source.name}" in Object Mode first, so its modifiers can be checked.',
        )
    return has_changed(source, report, read_anew)


def _is_edited(mesh: bpy.types.Mesh, report: dict) -> bool:
    """Whether anything but the place of whole pieces is other than it was laid out."""
    if not has_flat_attributes(mesh, PIECE_INDEX, SOURCE_VERTEX):
        return True
    pieces = read_flat_attribute(mesh, PIECE_INDEX)
    faces = [piece["faces"] if piece["has_layout"] else 0 for piece in report["pieces"]]
    if np.any((pieces < 0) | (pieces >= len(faces))) or np.bincount(pieces, minlength=len(faces)).tolist() != faces:
        return True
    return not has_kept_shape(mesh)
