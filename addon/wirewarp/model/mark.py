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
from ..pattern.chains import split_into_chains
from ..solve.identity import new_id
from ..words import counted
from .attributes import check_attributes, edit_layers
from .wire_names import list_places
from .wires import repair_names

OUTLINES_ARE_RIGID = "Outlines are rigid, or the two sides of a seam would not match"


def mark_selected(targets: Sequence[bpy.types.Object], tolerance: float) -> tuple[int, int]:
    """The selected edges become wires, one a chain. Returns the numbers of wires and of edges that were left out.

    Where a tolerance is asked for, edges of seams and outlines are left out: they are rigid anyway. Raises ObjectError,
    with nothing marked on any, if no other edge is selected, on an edge without a face, and on attributes that are not
    ours.
    """
    for target in targets:
        check_attributes(target.data)
        _refuse_loose(target)
    left_out = [edge for target in targets for edge in _outline_edges(target)] if tolerance > 0 else []
    if left_out and len(left_out) == sum(map(_count_selected, targets)):
        raise _all_on_outlines(targets, left_out)
    return sum(_mark_object(target, tolerance) for target in targets), len(left_out)


def _mark_object(target: bpy.types.Object, tolerance: float) -> int:
    if not _edges_to_mark(bmesh.from_edit_mesh(target.data), tolerance):
        return 0
    edit, wire_layer, tolerance_layer = edit_layers(target.data)
    selected = _edges_to_mark(edit, tolerance)
    _repair(target, edit, wire_layer)
    edit.verts.index_update()
    edges = np.array([[vertex.index for vertex in edge.verts] for edge in selected])
    present = np.array([edge[wire_layer] for edge in selected])
    counts = Counter(edge[wire_layer] for edge in edit.edges)
    planned = plan_wires(edges, present, counts, _positions(target, edit))
    for wire in planned:
        wire_id = wire.kept_id or new_id()
        for row in wire.rows:
            selected[row][wire_layer] = wire_id
            selected[row][tolerance_layer] = tolerance
    _finish(target, edit, wire_layer)
    # What was marked last is chosen in the list, so that the buttons below that act on it.
    target.data.wirewarp_active_wire = list_places(target.data)[wire_id]
    return len(planned)


def _edges_to_mark(edit: bmesh.types.BMesh, tolerance: float) -> list[bmesh.types.BMEdge]:
    return [edge for edge in _selected_edges(edit) if tolerance == 0 or not _is_outline(edge)]


def clear_selected(targets: Sequence[bpy.types.Object]) -> int:
    """Selected edges stop being wires. Returns how many did. Raises ObjectError on attributes that are not ours."""
    for target in targets:
        check_attributes(target.data)
    return sum(map(_clear_object, targets))


def _clear_object(target: bpy.types.Object) -> int:
    if WIRE not in bmesh.from_edit_mesh(target.data).edges.layers.int:
        return 0
    edit, wire_layer, tolerance_layer = edit_layers(target.data)
    cleared = [edge for edge in _selected_edges(edit) if edge[wire_layer]]
    for edge in cleared:
        edge[wire_layer] = 0
        edge[tolerance_layer] = 0.0
    _finish(target, edit, wire_layer)
    return len(cleared)


def _selected_edges(edit: bmesh.types.BMesh) -> list[bmesh.types.BMEdge]:
    return [edge for edge in edit.edges if edge.select and not edge.hide]


def _count_selected(target: bpy.types.Object) -> int:
    edit = bmesh.from_edit_mesh(target.data)
    return len(_selected_edges(edit))


def _is_outline(edge: bmesh.types.BMEdge) -> bool:
    return edge.seam or len(edge.link_faces) != 2


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


def _outline_edges(target: bpy.types.Object) -> list[tuple[int, int]]:
    """Those of the selected edges that lie on a seam or outline, as vertex pairs."""
    edit = bmesh.from_edit_mesh(target.data)
    return _pairs([edge for edge in _selected_edges(edit) if _is_outline(edge)])


def _all_on_outlines(targets: Sequence[bpy.types.Object], edges: list[tuple[int, int]]) -> ObjectError:
    count = counted(len(edges), "selected edge lies", "selected edges lie")
    names = " and ".join(f'"{target.name}"' for target in targets)
    sentence = f"{count} on a seam or outline of {names}. {OUTLINES_ARE_RIGID}: select other edges, or mark them rigid."
    return ObjectError(Issue("tolerance_on_outline", sentence, edges=edges))


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
