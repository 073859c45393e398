# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the drawings of one object as arrays, without the GPU."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial

import bpy
import numpy as np

from ..blender.attributes import find_values, has_attributes
from ..blender.mesh import corner_vertices, face_sizes, read, read_attribute, vertex_places
from ..core import joined_pieces
from ..names import PIECE, PIECE_INDEX, SOURCE_CORNER
from ..solve.maps import ColorMap
from ..solve.report import ObjectReport
from ..state.changes import has_changed
from ..state.identities import chain_names, piece_names, seam_names
from ..state.owners import find_flat_object, model_of, model_or_self
from ..state.record import grains, read_record
from ..state.reports import last_report, pieces_report
from .gather import (
    ColoredTriangles,
    colored,
    gather_lines,
    gather_side_eases,
    gather_triangles,
    gather_uv_lines,
    on_model,
    shown_mesh,
)
from .lines import (
    LineEdges,
    Name,
    arrow,
    dashes_by_kind,
    ease_arrows,
    lines_by_kind,
    piece_rooms,
    seam_line_names,
    wire_line_names,
    wire_runs,
)

# Unit vectors (2,32) for finding the outermost vertices of a piece within 1 - cos(pi / 32) = 0.5% of its radius.
# No vector is along an axis, so both ends of an upright side are found.
DIRECTIONS = np.array([[np.cos(angle), np.sin(angle)] for angle in np.pi * (np.arange(32) + 0.5) / 16]).T
ARROW = 0.4  # length of a grain arrow as a share of the size of its piece; less than half leaves room for names


@dataclass(frozen=True)
class Lines:
    places: dict[str, np.ndarray]  # (2k,3) float32 ends of the edges, for each kind of line
    dashes: dict[str, np.ndarray]  # (2m,3) float32 ends of the dashes, for each kind of line that has dashes
    names: list[Name]


def marked_lines(target: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> Lines:
    """Return the seams, wires, eases and names of a model or of flat pieces. Raises ObjectError like gather_lines."""
    edges = gather_lines(target, depsgraph)
    is_flat = model_of(target) is not None
    lines = lines_of(target, edges, is_flat)
    if eases := gather_side_eases(target, depsgraph):
        lines.places["ease"], names = ease_arrows(eases)
        lines.names[:0] = names
    if is_flat and not target.data.is_editmode and has_attributes(target.data, PIECE, PIECE_INDEX):
        middles = _middles(target.data)
        lines.names[:0] = _piece_names(target, middles, piece_rooms(edges))
        lines.places.update(_grain_arrows(target, edges, middles))
    return lines


def uv_lines(target: bpy.types.Object) -> Lines:
    """Return the seams and wires of a model in the map of its pieces. Raises ObjectError like gather_lines."""
    return lines_of(target, gather_uv_lines(target), in_plane=True)


def lines_of(target: bpy.types.Object, edges: LineEdges, in_plane: bool) -> Lines:
    """Return the lines and names of these edges of the object. in_plane: whether the edges are in a plane."""
    rooms = piece_rooms(edges) if in_plane else {}
    runs, report = wire_runs(edges.vertices, edges.ends, edges.marks), current_report(target)
    names = wire_line_names(edges, runs, _wire_names(target, [run.wire_id for run in runs], report), rooms)
    if report and report.pieces:
        texts = partial(_seam_texts, report, model_of(target) is not None)
        names += seam_line_names(edges, _seams_of_report(edges, report), texts, rooms)
    else:  # if the model has changed or could not be flattened, the names do not list the joined pieces
        given = seam_names(model_or_self(target))
        numbers = np.where(edges.seams & np.isin(edges.seam_ids, list(given)), edges.seam_ids, 0)
        names += seam_line_names(edges, numbers, lambda seam_id, _: (given[seam_id],), rooms)
    names.sort(key=lambda name: not name.is_selected)
    return Lines(lines_by_kind(edges), dashes_by_kind(edges, runs), names)


def _wire_names(target: bpy.types.Object, wire_ids: list[int], report: ObjectReport | None) -> list[str]:
    """Return the names of wires. On flat pieces, the names are from the report, because wires that share an id on the
    model have other ids on the pieces."""
    names = chain_names(model_or_self(target).data, wire_ids)
    given = {wire.wire_id: wire.name for wire in report.wires} if report and model_of(target) else {}
    return [given.get(wire_id, name) for wire_id, name in zip(wire_ids, names, strict=True)]


def current_report(target: bpy.types.Object) -> ObjectReport | None:
    """Return the last report if its indices still refer to the elements of the displayed object, otherwise None."""
    source = model_or_self(target)
    if source != target:
        return pieces_report(source)
    report = last_report(source)
    if not report:
        return None
    other_shape = report.with_modifiers != is_modified(source)
    return None if other_shape or has_changed(source, report.model_state) else report


def is_modified(source: bpy.types.Object) -> bool:
    return not source.data.is_editmode and any(modifier.show_viewport for modifier in source.modifiers)


def _seams_of_report(edges: LineEdges, report: ObjectReport) -> np.ndarray:
    """Return, for each edge, the index of its seam in the report plus 1, (k,); 0 for edges without a seam."""
    numbers = {(min(edge), max(edge)): seam.index + 1 for seam in report.seams for edge in seam.edges}
    pairs = np.sort(edges.vertices, axis=1).tolist()
    return np.array([numbers.get((a, b), 0) for a, b in pairs], dtype=np.int32)


def _seam_texts(report: ObjectReport, on_flat: bool, number: int, piece: int) -> tuple[str, ...]:
    """Return the texts of a seam, see Name: its name with the joined pieces, then the name alone.

    On a flat piece, the first text names only the other piece. number: as in _seams_of_report
    """
    seam = report.seams[number - 1]
    joined = joined_pieces(report, [each for each in seam.pieces if not on_flat or each != piece])
    return (f"{seam.name}: {joined}", seam.name) if joined and len(set(seam.pieces)) > 1 else (seam.name,)


@dataclass(frozen=True)
class _Middle:
    piece_id: int
    place: np.ndarray  # (3,) center of the face nearest to the middle
    reach: float  # distance from this center to the center of the farthest face
    around: np.ndarray  # (c,3) outermost vertices of the piece


def _middles(mesh: bpy.types.Mesh) -> dict[int, _Middle]:
    """Return the middle of each piece, by its index in the report."""
    pieces, ids = find_values(mesh, PIECE_INDEX), find_values(mesh, PIECE)
    centers, corners = read(mesh.polygons, "center", np.float32, 3), corner_vertices(mesh)
    piece_of_corner, places = np.repeat(pieces, face_sizes(mesh)), vertex_places(mesh)
    found = {}
    for piece in np.unique(pieces).tolist():
        faces = np.flatnonzero(pieces == piece)
        own = centers[faces]
        middle = (own.min(axis=0) + own.max(axis=0)) / 2
        place = own[np.argmin(np.linalg.norm(own - middle, axis=1))]
        vertices = places[corners[piece_of_corner == piece], :2]
        outermost = np.unique(np.argmax(vertices @ DIRECTIONS, axis=0))
        around = np.column_stack([vertices[outermost], np.zeros(len(outermost))])
        reach = float(np.linalg.norm(own - place, axis=1).max())
        found[piece] = _Middle(int(ids[faces[0]]), place, reach, around)
    return found


def _piece_names(flat: bpy.types.Object, middles: Mapping[int, _Middle], rooms: Mapping[int, float]) -> list[Name]:
    """Return a name for each piece, for its middle or, if there is no room, for a place beside the piece."""
    text_of, up = piece_names(model_of(flat)), np.array([[0.0, 0.0, 1.0]])
    return [
        Name(
            (text_of.get(own.piece_id, ""),),
            own.place[None],
            up,
            own.reach,
            piece,
            rooms.get(piece, np.inf),
            around=own.around,
        )
        for piece, own in middles.items()
    ]


def _grain_arrows(flat: bpy.types.Object, edges: LineEdges, middles: Mapping[int, _Middle]) -> dict[str, np.ndarray]:
    """Return the ends (2k,3) of the grain arrows by kind of line: "grain" in pieces that follow the grain wire,
    otherwise "default grain", which is lighter."""
    report, rooms = pieces_report(model_of(flat)), piece_rooms(edges)
    directions = grains(flat.data, vertex_places(flat.data)[:, :2])
    arrows: dict[str, list[np.ndarray]] = {}
    for piece, direction in directions.items():
        if report is None or piece >= len(report.pieces) or piece not in middles or piece not in rooms:
            continue
        ends = arrow(edges, piece, middles[piece].place[:2], direction, ARROW * rooms[piece])
        if ends is not None:
            kind = "grain" if report.follows_grain_wire(piece) else "default grain"
            arrows.setdefault(kind, []).append(ends)
    return {kind: np.concatenate(parts) for kind, parts in arrows.items()}


def colored_surface(
    target: bpy.types.Object, depsgraph: bpy.types.Depsgraph, color_map: ColorMap
) -> ColoredTriangles | None:
    """Return the colors of the map on flat pieces, or on a model with flat pieces; None if there is no map for the
    object's present shape."""
    flat = target if model_of(target) else find_flat_object(target)
    if flat is None or flat.data.is_editmode:
        return None
    colors = read_attribute(flat.data, color_map.attribute, "FLOAT_COLOR", "CORNER")
    if colors is None:
        return None
    highest = _highest_value(flat.data, color_map)
    if flat == target:
        return colored(gather_triangles(flat.data), colors, highest)
    corners = find_values(flat.data, SOURCE_CORNER)
    if corners is None or current_report(target) is None:
        return None
    with shown_mesh(target, depsgraph) as mesh:
        return colored(gather_triangles(mesh), on_model(colors, corners, len(mesh.loops)), highest)


def _highest_value(flat: bpy.types.Mesh, color_map: ColorMap) -> float | None:
    """Return the largest value of the map; None if a user or a script has removed the record of values."""
    record = read_record(flat)
    if record is None or color_map.attribute not in record.ranges:
        return None
    return record.ranges[color_map.attribute][1]
