# SPDX-License-Identifier: GPL-3.0-or-later
"""Seam allowances marked on flat pieces, where the sides of a seam lie apart: they are kept on the model."""

import bpy
import numpy as np

from ..blender.mesh import corner_edges, edge_vertices, face_sizes, faces_at_edges, read
from ..blender.objects import check_local
from ..issues import object_error
from ..model.owners import earlier_sentence, is_earlier, model_of
from ..model.side_allowances import mark_sides
from ..names import SOURCE_FACE, SOURCE_VERTEX
from ..pattern.chains import edge_keys
from .pattern import current_pieces
from .read import has_flat_attributes, read_flat_attribute

WITH_MODIFIERS = (
    'The pieces of "{}" were made with Modifiers, and their sides are no sides of the model: mark both sides there, or '
    "flatten it without Modifiers, mark one side on the pieces and flatten it with them again."
)


def mark_selected_sides(flat: bpy.types.Object, width: float) -> tuple[int, int]:
    """The selected outline edges of flat pieces in Object Mode get this width; see model.allowances.mark_selected."""
    source = model_of(flat)
    if is_earlier(flat):
        raise object_error("earlier_pieces", earlier_sentence(flat))
    report, _ = current_pieces(source)
    if report.get("with_modifiers"):
        raise object_error("with_modifiers", WITH_MODIFIERS.format(source.name))
    if not has_flat_attributes(flat.data, SOURCE_FACE):
        raise object_error("edited_pieces", f'"{flat.name}" was edited by hand. Flatten "{source.name}" again.')
    check_local(source, source.data)
    mesh, model = flat.data, source.data
    selected = read(mesh.edges, "select", bool) & ~read(mesh.edges, "hide", bool)
    rows = np.flatnonzero(selected & (faces_at_edges(mesh) == 1))
    face_of_edge = np.zeros(len(mesh.edges), dtype=np.int64)
    face_of_edge[corner_edges(mesh)] = np.repeat(read_flat_attribute(mesh, SOURCE_FACE), face_sizes(mesh))
    ends = read_flat_attribute(mesh, SOURCE_VERTEX)[edge_vertices(mesh)[rows]]
    keys = edge_keys(edge_vertices(model), len(model.vertices))
    order = np.argsort(keys)
    edges = order[np.searchsorted(keys[order], edge_keys(ends, len(model.vertices)))]
    marked = mark_sides(model, edges.tolist(), face_of_edge[rows].tolist(), width)
    model.update()
    return marked, int(selected.sum()) - marked
