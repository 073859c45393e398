# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks of one side of a seam, made on flat pieces, where its sides lie apart: they are kept on the model."""

from dataclasses import dataclass

import bpy
import numpy as np

from ..blender.attributes import find_values, has_attributes
from ..blender.mesh import corner_edges, edge_vertices, face_sizes, faces_at_edges, faces_of_corners, read
from ..blender.objects import check_local
from ..issues import object_error
from ..names import SOURCE_FACE, SOURCE_VERTEX
from ..solve.chains import edge_keys
from ..state.current_pieces import current_pieces
from ..state.owners import earlier_sentence, is_earlier, model_of

WITH_MODIFIERS = (
    'The pieces of "{}" were made with Modifiers, and their sides are not on the model: mark both sides there, or '
    "flatten it without Modifiers, mark one side on the pieces and flatten it with them again."
)


@dataclass(frozen=True)
class SelectedSides:
    """Of the model: edges and the face on the selected side of each."""

    model: bpy.types.Object
    edges: np.ndarray  # (k,)
    faces: np.ndarray  # (k,)
    left_out: int  # selected edges inside of pieces

    @property
    def corners(self) -> np.ndarray:
        """(k,) of these faces, at which these edges begin, in the order of the mesh."""
        mesh = self.model.data
        count, loop_edges = len(mesh.polygons), corner_edges(mesh).astype(np.int64)
        return np.flatnonzero(np.isin(loop_edges * count + faces_of_corners(mesh), self.edges * count + self.faces))


def selected_sides(flat: bpy.types.Object) -> SelectedSides:
    """Of the selected outline edges of flat pieces in Object Mode. Raises ObjectError if these are not true."""
    source = model_of(flat)
    if is_earlier(flat):
        raise object_error("earlier_pieces", earlier_sentence(flat))
    report, _ = current_pieces(source)
    if report.with_modifiers:
        raise object_error("with_modifiers", WITH_MODIFIERS.format(source.name))
    if not has_attributes(flat.data, SOURCE_FACE):
        raise object_error("edited_pieces", f'"{flat.name}" was edited by hand. Flatten "{source.name}" again.')
    check_local(source, source.data)
    mesh, model = flat.data, source.data
    selected = read(mesh.edges, "select", bool) & ~read(mesh.edges, "hide", bool)
    rows = np.flatnonzero(selected & (faces_at_edges(mesh) == 1))
    face_of_edge = np.zeros(len(mesh.edges), dtype=np.int64)
    face_of_edge[corner_edges(mesh)] = np.repeat(find_values(mesh, SOURCE_FACE), face_sizes(mesh))
    ends = find_values(mesh, SOURCE_VERTEX)[edge_vertices(mesh)[rows]]
    keys = edge_keys(edge_vertices(model), len(model.vertices))
    order = np.argsort(keys)
    edges = order[np.searchsorted(keys[order], edge_keys(ends, len(model.vertices)))]
    return SelectedSides(source, edges, face_of_edge[rows].astype(np.int64), int(selected.sum()) - len(rows))
