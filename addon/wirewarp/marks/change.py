# SPDX-License-Identifier: GPL-3.0-or-later
"""Changing wires and seams that are there: by hand, or as is proposed. Of meshes in Object Mode."""

import bpy
import numpy as np

from ..blender.attributes import read_values
from ..blender.mesh import add_seams, corner_edges, edge_vertices, read_seams, remove_seams
from ..issues import LooserWire, object_error
from ..names import MARKS
from ..solve.chains import EdgeMarks, edge_keys
from ..state.marked_mesh import read_marks, write_marks
from ..state.sides import is_set
from ..state.wires import WireSummary, find_name, find_wires, repair_names


def wire_at(target: bpy.types.Object, edge: int) -> WireSummary:
    """The wire that this edge of the mesh belongs to. Raises ObjectError if it is none's."""
    for wire in find_wires(target):
        if edge in wire.edges:
            return wire
    sentence = f'Edge {edge} of "{target.name}" is not part of a wire. Choose one in the list, or mark it first.'
    raise object_error("no_wire", sentence)


def change_wire(target: bpy.types.Object, edge: int, name: str, tolerance: float, ease: float | None) -> None:
    """Changes the wire of this edge; name "", ease None: it keeps its own. Raises ObjectError as wire_at does."""
    mesh = target.data
    rows = np.array(wire_at(target, edge).edges)
    marks = read_marks(mesh)
    marks.tolerances[rows] = tolerance
    if ease is not None:
        marks.eases[rows] = ease
    write_marks(mesh, marks)
    marks = repair_marks(target)
    if name:
        find_name(mesh, int(marks.wire_ids[rows[0]])).name = name


def change_grain(target: bpy.types.Object, edge: int) -> None:
    """Makes the wire that this edge belongs to the grain wire, or none if it is. Raises ObjectError as wire_at does."""
    mesh = target.data
    wire_at(target, edge)
    wire_id = int(repair_marks(target).wire_ids[edge])
    mesh.wirewarp_grain = 0 if mesh.wirewarp_grain == wire_id else wire_id


def repair_marks(target: bpy.types.Object) -> EdgeMarks:
    """Gives each wire an id of its own; returns the marks as they are then."""
    marks = read_marks(target.data)
    for row, wire_id in repair_names(target).items():
        marks.wire_ids[row] = wire_id
    write_marks(target.data, marks)
    return marks


def mark_seams(mesh: bpy.types.Mesh, edges: list) -> int:
    """Marks edges, given as vertex pairs, as seams. Returns how many were none before."""
    before = read_seams(mesh)
    wanted = _mask(mesh, edges)
    add_seams(mesh, np.flatnonzero(wanted))
    mesh.update()
    return int(np.count_nonzero(wanted & ~before))


def clear_seams(mesh: bpy.types.Mesh, edges: list) -> None:
    """Edges, given as vertex pairs, are no seams any more."""
    remove_seams(mesh, np.flatnonzero(_mask(mesh, edges)))
    mesh.update()


def edges_with_marks(mesh: bpy.types.Mesh) -> np.ndarray:
    """(e,) bool: those with any mark, of both sides or of one."""
    marked = np.zeros(len(mesh.edges), dtype=bool)
    for mark in MARKS:
        if mark.domain == "EDGE":
            marked |= is_set(read_values(mesh, mark))
        elif mark.domain == "CORNER":
            marked[corner_edges(mesh)[is_set(read_values(mesh, mark))]] = True
    return marked


def loosen_wires(mesh: bpy.types.Mesh, wires: list[LooserWire]) -> int:
    """Gives the edges of each proposed wire its tolerance, unless theirs is wider. Returns how many edges changed."""
    marks = read_marks(mesh)
    before, tolerances = marks.tolerances.copy(), marks.tolerances
    for wire in wires:
        rows = _mask(mesh, wire.edges) & marks.are_wires  # what is no wire any more stays so
        tolerances[rows] = np.maximum(tolerances[rows], np.float32(wire.tolerance))
    write_marks(mesh, marks)
    return int(np.count_nonzero(tolerances != before))


def _mask(mesh: bpy.types.Mesh, pairs: list) -> np.ndarray:
    count = len(mesh.vertices)
    return np.isin(edge_keys(edge_vertices(mesh), count), edge_keys(pairs, count))
