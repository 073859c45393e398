# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks and clears edges of the model, from Edit Mode of the model or of its flat pieces."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import bmesh
import bpy
import numpy as np

from ..blender.attributes import find_values, has_attributes
from ..blender.mesh import (
    add_seams,
    corner_edges,
    corner_vertices,
    edge_vertices,
    face_sizes,
    faces_at_edges,
    faces_of_corners,
    next_loops,
    read,
    read_seams,
    read_uv,
)
from ..blender.objects import check_local
from ..issues import Issue, ObjectError, object_error
from ..names import SOURCE_FACE, SOURCE_VERTEX, WIRE
from ..solve.arrays import island_borders
from ..solve.chains import edge_keys, split_into_chains
from ..solve.identity import new_id
from ..state.flat_pieces import current_pieces
from ..state.identities import list_places, repair_names
from ..state.marked_mesh import check_attributes, edit_layers
from ..state.owners import earlier_sentence, is_earlier, model_of
from ..state.read_model import own_uv_map
from ..words import counted


@dataclass(frozen=True)
class Marked:
    wires: int
    lost_eases: int  # number of wires whose edges had several eases, which are removed


def mark_selected(targets: Sequence[bpy.types.Object], tolerance: float) -> Marked:
    """Make the selected edges wires, one per chain, also along seams and outlines.

    Raises ObjectError, and marks nothing, for an edge without a face and for taken names of attributes.
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
    # The last marked wire is chosen in the list, so that the buttons below the list apply to it.
    target.data.wirewarp_active_wire = list_places(target.data)[wire_id]
    return Marked(len(planned), lost_eases)


def clear_selected(targets: Sequence[bpy.types.Object]) -> int:
    """Remove the selected edges from wires. Return how many. Raises ObjectError for taken names of attributes."""
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
    edit = bmesh.from_edit_mesh(target.data)  # keeps its edges valid
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
    """Return the positions as displayed, so that unapplied scale does not change which lines are straight."""
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
    kept_id: int  # id of the wire that is marked again as a whole; 0: a new wire


def plan_wires(
    edges: np.ndarray, wire_ids: np.ndarray, edges_of_wire: Mapping[int, int], positions: np.ndarray
) -> list[PlannedWire]:
    """Plan one wire for each chain of selected edges (k,2) with their present ids (k,).

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


def seams_from_uv(targets: Sequence[bpy.types.Object]) -> tuple[int, list[str]]:
    """Mark the borders of the islands of each object's map; existing seams stay.

    Return the number of new ones, and the names of the maps. Raises ObjectError, with nothing marked, if an object has
    no UV map.
    """
    maps = [_find_map(target) for target in targets]
    count = sum(_mark_borders(target.data, layer) for target, layer in zip(targets, maps, strict=True))
    return count, list(dict.fromkeys(layer.name for layer in maps))


def has_new_seams(mesh: bpy.types.Mesh) -> bool:
    """Return whether the user's own map has borders that are not seams yet, for a mesh in Object Mode."""
    layer = own_uv_map(mesh)
    return layer is not None and bool((_borders(mesh, layer) & ~read_seams(mesh)).any())


def _find_map(target: bpy.types.Object) -> bpy.types.MeshUVLoopLayer:
    """Return the user's own map, or that of the flat pieces if there is no other."""
    found = own_uv_map(target.data) or target.data.uv_layers.active
    if found is None:
        raise object_error("no_uv_map", f'"{target.name}" has no UV map: unwrap it first (UV > Unwrap).')
    return found


def _mark_borders(mesh: bpy.types.Mesh, layer: bpy.types.MeshUVLoopLayer) -> int:
    before, borders = read_seams(mesh), _borders(mesh, layer)
    add_seams(mesh, np.flatnonzero(borders))
    mesh.update()
    return int(np.count_nonzero(borders & ~before))


def _borders(mesh: bpy.types.Mesh, layer: bpy.types.MeshUVLoopLayer) -> np.ndarray:
    """(e,) bool"""
    return island_borders(
        corner_edges(mesh),
        corner_vertices(mesh),
        next_loops(mesh),
        read_uv(layer),
        len(mesh.edges),
    )


WITH_MODIFIERS = (
    'The pieces of "{}" were made with Modifiers, and their sides are not on the model. Mark both sides there. '
    "For one side, flatten without Modifiers, mark it on the pieces, and flatten with Modifiers again."
)


@dataclass(frozen=True)
class SelectedSides:
    """Edges of the model, and the face on the selected side of each."""

    model: bpy.types.Object
    edges: np.ndarray  # (k,)
    faces: np.ndarray  # (k,)
    left_out: int  # number of selected edges inside pieces

    @property
    def corners(self) -> np.ndarray:
        """Return corners (k,) of these faces at which these edges begin, in the order of the mesh."""
        mesh = self.model.data
        count, loop_edges = len(mesh.polygons), corner_edges(mesh).astype(np.int64)
        return np.flatnonzero(np.isin(loop_edges * count + faces_of_corners(mesh), self.edges * count + self.faces))


def selected_sides(flat: bpy.types.Object) -> SelectedSides:
    """Return the sides of the selected outline edges of flat pieces in Object Mode.

    Raises ObjectError for outdated pieces.
    """
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
