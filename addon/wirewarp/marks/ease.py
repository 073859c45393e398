# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks eases, and changes existing wires and seams, on models in Object Mode.

Each function plan_... checks a model, and returns a function that writes the change. The caller writes only after all
checks, so that no object is changed if one is refused.
"""

import math
from collections.abc import Callable, Collection
from dataclasses import dataclass

import bpy
import numpy as np

from ..blender.attributes import read_values
from ..blender.mesh import (
    add_seams,
    corner_edges,
    corner_vertices,
    edge_vertices,
    faces_at_edges,
    faces_of_corners,
    read,
    read_seams,
    remove_seams,
    vertex_places,
)
from ..blender.objects import linear_part
from ..core import LooserWire
from ..issues import object_error
from ..names import EASE, MARKS
from ..solve.arrays import edge_lengths
from ..solve.chains import EdgeMarks, are_among, split_into_chains
from ..solve.identity import new_id
from ..state.allowances import SIDE_EASES, is_set, on_outlines
from ..state.identities import WireSummary, find_name, find_wires, list_places, repair_names
from ..state.marked_mesh import check_attributes, read_marks, write_marks


def wire_at(target: bpy.types.Object, edge: int) -> WireSummary:
    """Return the wire to which this edge of the mesh belongs. Raises ObjectError if the edge is not part of a wire."""
    for wire in find_wires(target):
        if edge in wire.edges:
            return wire
    sentence = f'Edge {edge} of "{target.name}" is not part of a wire. Choose a wire in the list, or mark a wire first.'
    raise object_error("no_wire", sentence)


def change_wire(target: bpy.types.Object, edge: int, name: str, tolerance: float, ease: float | None) -> None:
    """Change the wire of this edge. The wire keeps its name if `name` is empty, and its ease if `ease` is None.

    Raises ObjectError like wire_at.
    """
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
    """Make the wire of this edge the grain wire. If it already is the grain wire, leave the model without a grain wire.
    Raises ObjectError like wire_at."""
    mesh = target.data
    wire_at(target, edge)
    wire_id = int(repair_marks(target).wire_ids[edge])
    mesh.wirewarp_grain = 0 if mesh.wirewarp_grain == wire_id else wire_id


def repair_marks(target: bpy.types.Object) -> EdgeMarks:
    """Assign a separate id to each wire. Return the resulting marks."""
    marks = read_marks(target.data)
    for row, wire_id in repair_names(target).items():
        marks.wire_ids[row] = wire_id
    write_marks(target.data, marks)
    return marks


def mark_seams(mesh: bpy.types.Mesh, edges: list) -> int:
    """Mark edges, given as vertex pairs, as seams. Return the number of new seams."""
    return make_seams(mesh, _mask(mesh, edges))


def make_seams(mesh: bpy.types.Mesh, edges: np.ndarray) -> int:
    """Mark the edges of this mask (e,) as seams. Return the number of new seams."""
    before = read_seams(mesh)
    add_seams(mesh, np.flatnonzero(edges))
    mesh.update()
    return int(np.count_nonzero(edges & ~before))


def clear_seams(mesh: bpy.types.Mesh, edges: list) -> None:
    remove_seams(mesh, np.flatnonzero(_mask(mesh, edges)))
    mesh.update()


def edges_with_marks(mesh: bpy.types.Mesh) -> np.ndarray:
    """Return a mask (e,) of the edges with any mark, on one or both sides."""
    marked = np.zeros(len(mesh.edges), dtype=bool)
    for mark in MARKS:
        if mark.domain == "EDGE":
            marked |= is_set(read_values(mesh, mark))
        elif mark.domain == "CORNER":
            marked[corner_edges(mesh)[is_set(read_values(mesh, mark))]] = True
    return marked


def loosen_wires(mesh: bpy.types.Mesh, wires: list[LooserWire]) -> int:
    """Set the suggested tolerance of each wire on its edges. Edges with a larger tolerance keep it. Return the number
    of changed edges."""
    marks = read_marks(mesh)
    before, tolerances = marks.tolerances.copy(), marks.tolerances
    for wire in wires:
        rows = _mask(mesh, wire.edges) & marks.are_wires  # wires that the user has removed stay removed
        tolerances[rows] = np.maximum(tolerances[rows], np.float32(wire.tolerance))
    write_marks(mesh, marks)
    return int(np.count_nonzero(tolerances != before))


def _mask(mesh: bpy.types.Mesh, pairs: list) -> np.ndarray:
    return are_among(edge_vertices(mesh), pairs)


# A piece counts as larger if its area is larger by more than this share. Areas of mirrored pieces differ only by
# rounding.
SAME_AREA = 1e-3
Amount = Callable[[float], float]  # returns the ease of a line as a fraction, from its length in Blender units


@dataclass(frozen=True)
class Change:
    ratio: float  # ease as a fraction; 0 for a cleared ease
    length: float  # change of length, in Blender units


@dataclass(frozen=True)
class Eased:
    changes: list[Change]
    left_out: int  # number of selected edges that were ignored


Planned = Callable[[], Eased]  # writes the planned eases, and cannot fail


def check_ease_attributes(mesh: bpy.types.Mesh) -> None:
    check_attributes(mesh)
    SIDE_EASES.check_attributes(mesh)


def plan_lines(target: bpy.types.Object, rows: np.ndarray, amount: Amount) -> Planned:
    """Plan to ease the lines of these edges equally on all sides. Edges without a wire become rigid wires. Raises
    ObjectError if a line would have no length left."""
    mesh = target.data
    used = rows[faces_at_edges(mesh)[rows] > 0]
    lengths = _lengths(target)
    chains = split_into_chains(edge_vertices(mesh)[used], _places(target)) if len(used) else []
    lines = [used[chain.edges] for chain in chains]
    changes = [_change(float(lengths[line].sum()), amount) for line in lines]

    def write() -> Eased:
        if lines:
            _write_lines(target, lines, changes)
        return Eased(changes, len(rows) - len(used))

    return write


def _write_lines(target: bpy.types.Object, lines: list[np.ndarray], changes: list[Change]) -> None:
    mesh = target.data
    marks = read_marks(mesh)
    for line, change in zip(lines, changes, strict=True):
        new = line[marks.wire_ids[line] == 0]
        marks.wire_ids[new], marks.tolerances[new] = new_id(), 0
        marks.eases[line] = change.ratio
    write_marks(mesh, marks)
    wire_id = int(repair_marks(target).wire_ids[min(map(min, lines))])
    mesh.wirewarp_active_wire = list_places(mesh)[wire_id]  # choose one of these wires in the list


def plan_sides(target: bpy.types.Object, rows: np.ndarray, amount: Amount, side: int) -> Planned:
    """Plan to lengthen the lines of these seams and outlines on one side. Other edges are ignored.

    side: 0 at the smaller piece, 1 at the larger
    Raises ObjectError if a line would have no length left.
    """
    mesh = target.data
    lines = _sides_of_lines(mesh, rows[on_outlines(mesh)[rows]], _places(target))
    areas = _piece_areas(mesh)  # sizes choose the side, so that the armholes of two sleeves are eased alike
    sides = [line[::-1] if _is_larger(areas, *line) else line for line in lines]
    return _plan(target, [line[side] or line[1 - side] for line in sides], amount, len(rows))


def plan_corners(target: bpy.types.Object, corners: Collection[int], amount: Amount) -> Planned:
    """Plan to lengthen the edges that begin at these corners, only on the side of the corners' faces. Raises
    ObjectError like plan_sides, and if the corners include both sides of an edge."""
    mesh, chosen = target.data, set(corners)
    rows = np.unique(corner_edges(mesh)[list(chosen)])
    if len(rows) < len(chosen):
        raise object_error(
            "both_sides", "Both sides of a seam are selected. Select one side, or press All Sides on the model."
        )
    lines = _sides_of_lines(mesh, rows[on_outlines(mesh)[rows]], _places(target))
    return _plan(
        target, [[each for side in line for each in side if each in chosen] for line in lines], amount, len(rows)
    )


def clear_eases(target: bpy.types.Object, edges: np.ndarray) -> Eased:
    """Clear the eases of these edges on all sides. An edge may occur twice. Return a change for each line that had
    an ease."""
    mesh, rows = target.data, np.unique(edges)
    marks = read_marks(mesh)
    had = (marks.eases[rows] != 0) | SIDE_EASES.clear(mesh, rows)
    if marks.eases[rows].any():
        marks.eases[rows] = 0
        write_marks(mesh, marks)
        repair_marks(target)
    cleared = rows[had]
    lines = split_into_chains(edge_vertices(mesh)[cleared], _places(target)) if len(cleared) else []
    return Eased([Change(0.0, 0.0)] * len(lines), 0)


def _plan(target: bpy.types.Object, lines: list[list[int]], amount: Amount, selected: int) -> Planned:
    """Plan the changes. lines: for each line, the corners at which its edges begin; selected: number of selected
    edges."""
    mesh = target.data
    loop_edges, lengths = corner_edges(mesh), _lengths(target) * (1 + read_values(mesh, EASE))
    found = [line for line in lines if line]
    changes = [_change(float(lengths[loop_edges[line]].sum()), amount) for line in found]

    def write() -> Eased:
        for line, change in zip(found, changes, strict=True):
            SIDE_EASES.mark(mesh, line, change.ratio)
        return Eased(changes, selected - sum(map(len, found)))

    return write


def _sides_of_lines(mesh: bpy.types.Mesh, rows: np.ndarray, places: np.ndarray) -> list[tuple[list[int], list[int]]]:
    """Return the corners at which the edges of each line begin, on both sides.

    rows: edges on seams and outlines
    places (n,3): displayed places of the vertices, to find out where lines turn
    """
    edges, starts, loop_edges = edge_vertices(mesh), corner_vertices(mesh), corner_edges(mesh)
    corners_of: dict[tuple[int, int], list[int]] = {}
    for corner in np.flatnonzero(np.isin(loop_edges, rows)).tolist():
        corners_of.setdefault((int(loop_edges[corner]), int(starts[corner])), []).append(corner)
    lines = []
    for chain in split_into_chains(edges[rows], places):
        sides: tuple[list[int], list[int]] = ([], [])
        for side, begins in zip(sides, (chain.vertices[:-1], chain.vertices[1:]), strict=True):
            for row, vertex in zip(chain.edges, begins, strict=True):
                found = corners_of.get((int(rows[row]), vertex), [])
                side += found if len(found) == 1 else []  # if several faces are on a side, it has no single corner
        lines.append(sides)
    return lines


def _is_larger(areas: np.ndarray, one: list[int], other: list[int]) -> bool:
    """Return whether the piece on the first side of a line is larger; False for equal pieces, and for outlines. areas:
    see _piece_areas(); one, other: corners on the two sides."""
    return bool(one and other) and areas[one[0]] > (1 + SAME_AREA) * areas[other[0]]


def _piece_areas(mesh: bpy.types.Mesh) -> np.ndarray:
    """Return the area of the piece of each corner, (l,), in the units of the mesh."""
    faces, inside = faces_of_corners(mesh), ~read_seams(mesh)
    first_at = np.full(len(mesh.edges), -1)
    first_at[corner_edges(mesh)] = faces  # one face of each edge
    joined = np.flatnonzero(inside[corner_edges(mesh)])
    pairs = np.stack([faces[joined], first_at[corner_edges(mesh)[joined]]])
    piece = np.arange(len(mesh.polygons))
    # Numbers are indices of faces. Each face takes the lowest number among its neighbors, then the number of the face
    # with this index.
    while True:
        least = piece[pairs].min(axis=0)
        lower = piece.copy()
        for side in pairs:
            np.minimum.at(lower, piece[side], least)
        lower = lower[lower]
        if np.array_equal(lower, piece):
            break
        piece = lower
    areas = np.bincount(piece, weights=read(mesh.polygons, "area", np.float32), minlength=len(piece))
    return np.asarray(areas[piece][faces])


def _change(length: float, amount: Amount) -> Change:
    ratio = amount(length) if length > 0 else math.nan
    if not -1 < ratio < math.inf:
        raise object_error("invalid_ease", "With this ease, a line has no length left. Choose an ease above -100%.")
    return Change(ratio, ratio * length)


def _places(target: bpy.types.Object) -> np.ndarray:
    """Return the places (n,3) of the vertices with rotation and scale of the object, but without its location."""
    return vertex_places(target.data).astype(np.float64) @ linear_part(target).T


def _lengths(target: bpy.types.Object) -> np.ndarray:
    return edge_lengths(_places(target), edge_vertices(target.data))
