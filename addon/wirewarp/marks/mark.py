# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks edges of the model, and clears marks. The user selects the edges on the model or on its flat pieces."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import bpy
import numpy as np

from ..blender.attributes import find_values, has_attributes
from ..blender.mesh import (
    corner_edges,
    corner_vertices,
    edge_vertices,
    face_sizes,
    faces_at_edges,
    faces_of_corners,
    next_loops,
    read_seams,
    read_uv,
    selected_edges,
    vertex_places,
)
from ..blender.objects import check_local
from ..core import Issue, counted
from ..issues import ObjectError, object_error
from ..names import SOURCE_FACE, SOURCE_VERTEX
from ..solve.arrays import island_borders
from ..solve.chains import find_edges, split_into_chains
from ..solve.identity import new_id
from ..state.flat_pieces import current_pieces
from ..state.identities import list_places
from ..state.marked_mesh import check_attributes, read_marks, write_marks
from ..state.owners import earlier_sentence, is_earlier, model_of
from ..state.read_model import own_uv_map
from .ease import make_seams, repair_marks


class Marked(NamedTuple):
    wires: int
    lost_eases: int  # number of wires whose edges had different eases; these eases are removed


def plan_wires(target: bpy.types.Object, tolerance: float) -> Callable[[], Marked]:
    """Plan to turn the selected edges into wires, one for each line.

    If a line contains one whole wire and no other, this wire keeps its id and name.
    Raises ObjectError if an edge has no face, and like check_attributes.
    """
    mesh = target.data
    check_attributes(mesh)
    rows = selected_edges(mesh)
    loose = rows[faces_at_edges(mesh)[rows] == 0]
    if len(loose):
        count = counted(len(loose), "selected edge")
        have, them = ("has", "it") if len(loose) == 1 else ("have", "them")
        sentence = (
            f'{count} of "{target.name}" {have} no face. Deselect {them}, or delete {them} with Mesh > Clean Up > '
            "Delete Loose."
        )
        pairs = [tuple(pair) for pair in edge_vertices(mesh)[loose].tolist()]
        raise ObjectError(Issue("loose_edge", sentence, edges=pairs))
    return lambda: _mark(target, rows, tolerance) if len(rows) else Marked(0, 0)


def _mark(target: bpy.types.Object, rows: np.ndarray, tolerance: float) -> Marked:
    mesh, marks, lost_eases = target.data, repair_marks(target), 0
    edges_of_wire = np.unique(marks.wire_ids, return_counts=True)
    counts = dict(zip(*(each.tolist() for each in edges_of_wire), strict=True))
    # The displayed places are used, so that unapplied scale does not change which lines are straight.
    positions = vertex_places(mesh) @ np.array(target.matrix_world)[:3, :3].T
    chains = split_into_chains(edge_vertices(mesh)[rows], positions)
    for chain in chains:
        own = rows[chain.edges]
        before = own[marks.wire_ids[own] != 0]
        ids, eases = (np.unique(each[before]).tolist() for each in (marks.wire_ids, marks.eases))
        is_whole = len(ids) == 1 and len(before) == counts[ids[0]]
        marks.wire_ids[own], marks.tolerances[own] = ids[0] if is_whole else new_id(), tolerance
        marks.eases[own] = eases[0] if len(eases) == 1 else 0
        lost_eases += len(eases) > 1
    write_marks(mesh, marks)
    wire_id = int(repair_marks(target).wire_ids[rows[chains[-1].edges[0]]])
    # The last marked wire is chosen in the list, so that the buttons below the list apply to it.
    mesh.wirewarp_active_wire = list_places(mesh)[wire_id]
    return Marked(len(chains), lost_eases)


def plan_clear(target: bpy.types.Object) -> Callable[[], int]:
    """Plan to remove the selected edges from wires. The plan returns the number of these edges. Raises ObjectError if
    attributes of another add-on have our names."""
    check_attributes(target.data)

    def clear() -> int:
        marks, rows = read_marks(target.data), selected_edges(target.data)
        cleared = rows[marks.wire_ids[rows] != 0]
        if len(cleared):
            marks.wire_ids[cleared] = marks.tolerances[cleared] = marks.eases[cleared] = 0
            write_marks(target.data, marks)
            repair_marks(target)
        return len(cleared)

    return clear


def seams_from_uv(targets: Sequence[bpy.types.Object]) -> tuple[int, list[str]]:
    """Mark the island borders of each object's map as seams. Return the number of new seams and the maps' names.

    Raises ObjectError, with nothing marked, if an object has no UV map.
    """
    maps = [_find_map(target) for target in targets]
    count = sum(make_seams(each.data, _borders(each.data, layer)) for each, layer in zip(targets, maps, strict=True))
    return count, list(dict.fromkeys(layer.name for layer in maps))


def has_new_seams(mesh: bpy.types.Mesh) -> bool:
    """Return whether the user's own map has borders that are not seams yet, for a mesh in Object Mode."""
    layer = own_uv_map(mesh)
    return layer is not None and bool((_borders(mesh, layer) & ~read_seams(mesh)).any())


def _find_map(target: bpy.types.Object) -> bpy.types.MeshUVLoopLayer:
    """Return the user's own map, or WireWarp's map of the pieces if the user has none. Raises ObjectError if there is
    no map."""
    found = own_uv_map(target.data) or target.data.uv_layers.active
    if found is None:
        raise object_error("no_uv_map", f'"{target.name}" has no UV map. Use UV > Unwrap first.')
    return found


def _borders(mesh: bpy.types.Mesh, layer: bpy.types.MeshUVLoopLayer) -> np.ndarray:
    return island_borders(corner_edges(mesh), corner_vertices(mesh), next_loops(mesh), read_uv(layer), len(mesh.edges))


WITH_MODIFIERS = (
    'The pieces of "{}" were made with Modifiers, so the model may lack their edges. Mark both sides on the model. '
    "To mark one side, flatten without Modifiers, mark the side on the pieces, and flatten with Modifiers again."
)


@dataclass(frozen=True)
class SelectedSides:
    """Edges of the model, each with the face on its selected side."""

    model: bpy.types.Object
    edges: np.ndarray  # (k,)
    faces: np.ndarray  # (k,)
    left_out: int  # number of selected edges inside pieces

    @property
    def corners(self) -> np.ndarray:
        """Return, in the order of the mesh, the corners (k,) at which the edges begin in their faces."""
        mesh = self.model.data
        count, loop_edges = len(mesh.polygons), corner_edges(mesh).astype(np.int64)
        return np.flatnonzero(np.isin(loop_edges * count + faces_of_corners(mesh), self.edges * count + self.faces))


def selected_sides(flat: bpy.types.Object) -> SelectedSides:
    """Return the sides of the model's edges at the outline edges that are selected on flat pieces.

    The flat pieces must be in Object Mode. Raises ObjectError if they are outdated, were edited by hand or were made
    with modifiers, or if the model is linked.
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
    selected = selected_edges(mesh)
    rows = selected[faces_at_edges(mesh)[selected] == 1]
    face_of_edge = np.zeros(len(mesh.edges), dtype=np.int64)
    face_of_edge[corner_edges(mesh)] = np.repeat(find_values(mesh, SOURCE_FACE), face_sizes(mesh))
    ends = find_values(mesh, SOURCE_VERTEX)[edge_vertices(mesh)[rows]]
    edges = find_edges(ends, edge_vertices(model))
    return SelectedSides(source, edges, face_of_edge[rows].astype(np.int64), len(selected) - len(rows))
