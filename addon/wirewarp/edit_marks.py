# SPDX-License-Identifier: GPL-3.0-or-later
"""Marking and clearing the selected edges of a mesh in Edit Mode."""

from collections import Counter
from collections.abc import Sequence

import bmesh
import bpy
import numpy as np

from .issues import Issue, ObjectError
from .marking import plan_wires
from .mesh_to_arrays import linear_part
from .wire_attributes import edit_layers, new_wire_id
from .wire_names import update_names


def mark_selected(targets: Sequence[bpy.types.Object], tolerance: float) -> int:
    """The selected edges become wires, one a chain. Returns the number of wires, 0 if nothing is selected.

    Raises ObjectError, with nothing marked, on an edge without a face, and where a tolerance is asked for on an edge
    that is rigid anyway.
    """
    for target in targets:
        _refuse_loose(target)
    if tolerance > 0:
        for target in targets:
            _refuse_outlines(target)
    return sum(_mark_object(target, tolerance) for target in targets)


def _mark_object(target: bpy.types.Object, tolerance: float) -> int:
    edit, wire_layer, tolerance_layer = edit_layers(target.data)
    selected = _selected_edges(edit)
    if not selected:
        return 0
    edit.verts.index_update()
    edges = np.array([[vertex.index for vertex in edge.verts] for edge in selected])
    present = np.array([edge[wire_layer] for edge in selected])
    counts = Counter(edge[wire_layer] for edge in edit.edges)
    planned = plan_wires(edges, present, counts, _positions(target, edit))
    for wire in planned:
        wire_id = wire.kept_id or new_wire_id()
        for row in wire.rows:
            selected[row][wire_layer] = wire_id
            selected[row][tolerance_layer] = tolerance
    _finish(target.data, edit, wire_layer)
    return len(planned)


def clear_selected(target: bpy.types.Object) -> int:
    """Selected edges stop being wires. Returns how many did."""
    edit, wire_layer, tolerance_layer = edit_layers(target.data)
    cleared = [edge for edge in _selected_edges(edit) if edge[wire_layer]]
    for edge in cleared:
        edge[wire_layer] = 0
        edge[tolerance_layer] = 0.0
    _finish(target.data, edit, wire_layer)
    return len(cleared)


def _selected_edges(edit: bmesh.types.BMesh) -> list[bmesh.types.BMEdge]:
    return [edge for edge in edit.edges if edge.select and not edge.hide]


def _refuse_loose(target: bpy.types.Object) -> None:
    edit = bmesh.from_edit_mesh(target.data)  # its edges live as long as this does
    loose = [edge for edge in _selected_edges(edit) if not edge.link_faces]
    if loose:
        count = "1 selected edge belongs" if len(loose) == 1 else f"{len(loose)} selected edges belong"
        raise _edges_error(
            "loose_edge",
            f'{count} to no face of "{target.name}", so there is nothing to flatten along it: leave such edges out, or '
            "delete them with Mesh > Clean Up > Delete Loose.",
            loose,
        )


def _refuse_outlines(target: bpy.types.Object) -> None:
    edit = bmesh.from_edit_mesh(target.data)
    rigid = [edge for edge in _selected_edges(edit) if edge.seam or len(edge.link_faces) != 2]
    if rigid:
        count = "1 selected edge lies" if len(rigid) == 1 else f"{len(rigid)} selected edges lie"
        raise _edges_error(
            "tolerance_on_outline",
            f'{count} on a seam or outline of "{target.name}". Outlines are rigid, or the two sides of a seam '
            "would not match: leave these edges out, or mark them rigid.",
            rigid,
        )


def _edges_error(code: str, sentence: str, edges: list[bmesh.types.BMEdge]) -> ObjectError:
    return ObjectError(Issue(code, sentence, edges=[tuple(vertex.index for vertex in edge.verts) for edge in edges]))


def _positions(target: bpy.types.Object, edit: bmesh.types.BMesh) -> np.ndarray:
    """As seen in the viewport, so that unapplied scale does not change what is straight."""
    return np.array([vertex.co[:] for vertex in edit.verts]) @ linear_part(target).T


def _finish(mesh: bpy.types.Mesh, edit: bmesh.types.BMesh, wire_layer: bmesh.types.BMLayerItem) -> None:
    update_names(mesh, [wire_id for wire_id in (edge[wire_layer] for edge in edit.edges) if wire_id])
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)
