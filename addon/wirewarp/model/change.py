# SPDX-License-Identifier: GPL-3.0-or-later
"""Changing wires and seams that are there: by hand, or as a report proposes. Of meshes in Object Mode."""

import bpy
import numpy as np

from ..blender.mesh import add_seams, edge_vertices, faces_at_edges, read_seams
from ..issues import object_error
from ..pattern.chains import EdgeMarks, edge_keys
from .attributes import read_marks, write_marks
from .mark import OUTLINES_ARE_RIGID
from .wire_names import find_name
from .wires import WireSummary, find_wires, repair_names


def wire_at(target: bpy.types.Object, edge: int) -> WireSummary:
    """The wire that this edge of the mesh belongs to. Raises ObjectError if it is none's."""
    for wire in find_wires(target):
        if edge in wire.edges:
            return wire
    sentence = f'Edge {edge} of "{target.name}" is not part of a wire. Choose one in the list, or mark it first.'
    raise object_error("no_wire", sentence)


def change_wire(target: bpy.types.Object, edge: int, name: str, tolerance: float) -> int:
    """Changes the wire that this edge belongs to; name "": it keeps its own.

    Returns how many of its edges lie on seams and outlines, which stay as they are if a tolerance is asked for. Raises
    ObjectError, with nothing changed, if those are all.
    """
    mesh = target.data
    rows = np.array(wire_at(target, edge).edges)
    outline = _outline_mask(mesh)[rows] if tolerance > 0 else np.zeros(len(rows), dtype=bool)
    if outline.all():
        sentence = (
            f'All of this wire lies on a seam or outline of "{target.name}". {OUTLINES_ARE_RIGID}: leave it rigid.'
        )
        raise object_error("tolerance_on_outline", sentence)
    marks = read_marks(mesh)
    marks.tolerances[rows[~outline]] = tolerance
    write_marks(mesh, marks)
    marks = _repair(target)
    if name:
        find_name(mesh, int(marks.wire_ids[rows[~outline][0]])).name = name
    return int(outline.sum())


def change_grain(target: bpy.types.Object, edge: int) -> None:
    """Makes the wire that this edge belongs to the grain wire, or none if it is. Raises ObjectError as wire_at does."""
    mesh = target.data
    wire_at(target, edge)
    wire_id = int(_repair(target).wire_ids[edge])
    mesh.wirewarp_grain = 0 if mesh.wirewarp_grain == wire_id else wire_id


def _repair(target: bpy.types.Object) -> EdgeMarks:
    """Gives each wire an id of its own; returns the marks as they are then."""
    marks = read_marks(target.data)
    for row, wire_id in repair_names(target).items():
        marks.wire_ids[row] = wire_id
    write_marks(target.data, marks)
    return marks


def _outline_mask(mesh: bpy.types.Mesh) -> np.ndarray:
    return read_seams(mesh) | (faces_at_edges(mesh) != 2)


def mark_seams(mesh: bpy.types.Mesh, edges: list) -> int:
    """Marks edges, given as vertex pairs, as seams. Returns how many were none before."""
    before = read_seams(mesh)
    wanted = _mask(mesh, edges)
    add_seams(mesh, np.flatnonzero(wanted))
    mesh.update()
    return int(np.count_nonzero(wanted & ~before))


def loosen_wires(mesh: bpy.types.Mesh, wires: list[dict]) -> int:
    """Gives the edges of each proposed wire its tolerance, unless theirs is wider. Returns how many edges changed."""
    marks = read_marks(mesh)
    before, tolerances = marks.tolerances.copy(), marks.tolerances
    for wire in wires:
        rows = _mask(mesh, wire["edges"]) & marks.are_wires  # what is no wire any more stays so
        tolerances[rows] = np.maximum(tolerances[rows], np.float32(wire["tolerance"]))
    write_marks(mesh, marks)
    return int(np.count_nonzero(tolerances != before))


def _mask(mesh: bpy.types.Mesh, pairs: list) -> np.ndarray:
    count = len(mesh.vertices)
    return np.isin(edge_keys(edge_vertices(mesh), count), edge_keys(pairs, count))
