# SPDX-License-Identifier: GPL-3.0-or-later
"""Marking and clearing the selected edges of a mesh in Edit Mode."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import bmesh
import bpy
import numpy as np

from ..issues import Issue, ObjectError
from ..names import WIRE
from ..solve.chains import split_into_chains
from ..solve.identity import new_id
from ..state.marked_mesh import check_attributes, edit_layers
from ..state.wires import list_places, repair_names
from ..words import counted


@dataclass(frozen=True)
class Marked:
    wires: int
    lost_eases: int  # of these wires: their edges had several eases, and have none now


def mark_selected(targets: Sequence[bpy.types.Object], tolerance: float) -> Marked:
    """The selected edges become wires, one a chain; along seams and outlines, too.

    Raises ObjectError, with nothing marked on any, on an edge without a face, and on attributes that are not ours.
    """
    for target in targets:
        check_attributes(target.data)
        _refuse_loose(target)
    marked = [_mark_object(target, tolerance) for target in targets]
    return Marked(sum(each.wires for each in marked), sum(each.lost_eases for each in marked))


def _mark_object(target: bpy.types.Object, tolerance: float) -> Marked:
    if not _selected_edges(bmesh.from_edit_mesh(target.data)):
        return Marked(0, 0)
    edit, wire_layer, tolerance_layer, ease_layer = edit_layers(target.data)
    selected = _selected_edges(edit)
    _repair(target, edit, wire_layer)
    edit.verts.index_update()
    edges = np.array([[vertex.index for vertex in edge.verts] for edge in selected])
    present = np.array([edge[wire_layer] for edge in selected])
    counts = Counter(edge[wire_layer] for edge in edit.edges)
    planned = plan_wires(edges, present, counts, _positions(target, edit))
    lost_eases = 0
    for wire in planned:
        wire_id = wire.kept_id or new_id()
        if ease_layer:
            eases = {selected[row][ease_layer] for row in wire.rows if selected[row][wire_layer]}
            lost_eases += len(eases) > 1
            ease = eases.pop() if len(eases) == 1 else 0.0
            for row in wire.rows:
                selected[row][ease_layer] = ease
        for row in wire.rows:
            selected[row][wire_layer] = wire_id
            selected[row][tolerance_layer] = tolerance
    _finish(target, edit, wire_layer)
    # What was marked last is chosen in the list, so that the buttons below that act on it.
    target.data.wirewarp_active_wire = list_places(target.data)[wire_id]
    return Marked(len(planned), lost_eases)


def clear_selected(targets: Sequence[bpy.types.Object]) -> int:
    """Selected edges stop being wires. Returns how many did. Raises ObjectError on attributes that are not ours."""
    for target in targets:
        check_attributes(target.data)
    return sum(map(_clear_object, targets))


def _clear_object(target: bpy.types.Object) -> int:
    if WIRE.name not in bmesh.from_edit_mesh(target.data).edges.layers.int:
        return 0
    edit, wire_layer, tolerance_layer, ease_layer = edit_layers(target.data)
    cleared = [edge for edge in _selected_edges(edit) if edge[wire_layer]]
    for edge in cleared:
        edge[wire_layer] = 0
        edge[tolerance_layer] = 0.0
        if ease_layer:
            edge[ease_layer] = 0.0
    _finish(target, edit, wire_layer)
    return len(cleared)


def _selected_edges(edit: bmesh.types.BMesh) -> list[bmesh.types.BMEdge]:
    return [edge for edge in edit.edges if edge.select and not edge.hide]


def _refuse_loose(target: bpy.types.Object) -> None:
    edit = bmesh.from_edit_mesh(target.data)  # its edges live as long as this does
    loose = [edge for edge in _selected_edges(edit) if not edge.link_faces]
    if loose:
        count = counted(len(loose), "selected edge")
        have, them = ("has", "it") if len(loose) == 1 else ("have", "them")
        sentence = (
            f'{count} of "{target.name}" {have} no face. Deselect {them}, or delete {them} with Mesh > Clean Up > '
            "Delete Loose."
        )
        raise ObjectError(Issue("loose_edge", sentence, edges=_pairs(loose)))


def _pairs(edges: list[bmesh.types.BMEdge]) -> list[tuple[int, int]]:
    return [tuple(vertex.index for vertex in edge.verts) for edge in edges]


def _positions(target: bpy.types.Object, edit: bmesh.types.BMesh) -> np.ndarray:
    """As seen in the viewport, so that unapplied scale does not change what is straight."""
    return np.array([vertex.co[:] for vertex in edit.verts]) @ np.array(target.matrix_world)[:3, :3].T


def _finish(target: bpy.types.Object, edit: bmesh.types.BMesh, wire_layer: bmesh.types.BMLayerItem) -> None:
    _repair(target, edit, wire_layer)
    bmesh.update_edit_mesh(target.data, loop_triangles=False, destructive=False)


def _repair(target: bpy.types.Object, edit: bmesh.types.BMesh, wire_layer: bmesh.types.BMLayerItem) -> None:
    edit.edges.ensure_lookup_table()
    for row, wire_id in repair_names(target).items():
        edit.edges[row][wire_layer] = wire_id


@dataclass(frozen=True)
class PlannedWire:
    rows: list[int]  # rows of the selected edges
    kept_id: int  # the id of the wire that is marked again as a whole, 0: a new wire


def plan_wires(
    edges: np.ndarray, wire_ids: np.ndarray, edges_of_wire: Mapping[int, int], positions: np.ndarray
) -> list[PlannedWire]:
    """Selected edges (k,2) with their present ids (k,) to one wire a chain.

    A chain that contains all edges of one wire, and of no other, is that wire: it keeps its id and name and only
    changes its tolerance. edges_of_wire counts the edges of each id on the whole mesh.
    """
    planned = []
    for chain in split_into_chains(edges, positions):
        present = wire_ids[chain.edges]
        ids = np.unique(present[present != 0]).tolist()
        whole = len(ids) == 1 and np.count_nonzero(present) == edges_of_wire[ids[0]]
        planned.append(PlannedWire(chain.edges, ids[0] if whole else 0))
    return planned
