# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn of one object: arrays, no GPU."""

from collections.abc import Mapping
from dataclasses import dataclass

import bpy
import numpy as np

from ..blender.mesh import read, read_attribute, read_numbers
from ..flat.pattern import read_cut_lines
from ..flat.pieces import piece_names
from ..flat.read import has_flat_attributes, read_flat_attribute
from ..flat.reports import last_report, pieces_report
from ..issues import ObjectError
from ..model.owners import find_flat_object, model_of, model_or_self
from ..model.state import has_changed
from ..model.wire_names import chain_names
from ..names import PIECE, RANGE, SOURCE_CORNER
from ..solve.maps import ColorMap
from .gather import gather_lines, gather_triangles, shown_mesh
from .lines import LineEdges, Name, dashes_by_kind, lines_by_kind, seam_line_names, wire_line_names, wire_runs
from .surfaces import ColoredTriangles, Extremes, colored, on_model


@dataclass(frozen=True)
class Lines:
    places: dict[str, np.ndarray]  # (2k,3) float32 for each kind of line
    dashes: dict[str, np.ndarray]  # (2m,3) float32 for each kind that has them
    names: list[Name]


def marked_lines(target: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> Lines:
    """Seams and wires of a model or of flat pieces. Raises ObjectError as gather_lines does."""
    lines = lines_of(target, gather_lines(target, depsgraph))
    if model_of(target) and not target.data.is_editmode and has_flat_attributes(target.data, PIECE):
        lines.names[:0] = _piece_names(target)
    return lines


def lines_of(target: bpy.types.Object, edges: LineEdges) -> Lines:
    """The marked edges of this object, wherever they are drawn."""
    runs, report = wire_runs(edges.vertices, edges.ends, edges.marks), current_report(target)
    names = wire_line_names(edges, runs, _wire_names(target, [run.wire_id for run in runs], report))
    if report:
        names += seam_line_names(edges, _seam_of_edge(report))
    return Lines(lines_by_kind(edges), dashes_by_kind(edges, runs), names)


def cut_lines(
    source: bpy.types.Object, flat: bpy.types.Object, meters: float, allowance: float, depsgraph: bpy.types.Depsgraph
) -> np.ndarray:
    """(2k,3) float32 around flat pieces outside Edit Mode; empty where they make no pattern: Export says why."""
    try:
        lines = read_cut_lines(source, flat, meters, allowance, depsgraph)
    except ObjectError:
        lines = []
    ends = [np.stack([line, np.roll(line, -1, axis=0)], axis=1).reshape(-1, 2) for line in lines]
    places = np.concatenate([np.empty((0, 2)), *ends])
    return np.column_stack([places, np.zeros(len(places))]).astype(np.float32)


def _wire_names(target: bpy.types.Object, wire_ids: list[int], report: dict | None) -> list[str]:
    """On flat pieces as in the report, for there copies of wires have ids of their own."""
    names = chain_names(model_or_self(target).data, wire_ids)
    given = {wire["wire_id"]: wire["name"] for wire in report["wires"]} if report and model_of(target) else {}
    return [given.get(wire_id, name) for wire_id, name in zip(wire_ids, names, strict=True)]


def current_report(target: bpy.types.Object) -> dict | None:
    """The last report, if its elements are still those of the object as it is shown."""
    source = model_or_self(target)
    if source != target:
        return pieces_report(source)
    report = last_report(source)
    if not report:
        return None
    other_shape = report.get("with_modifiers", False) != _is_modified(source)
    return None if other_shape or has_changed(source, report) else report


def _is_modified(source: bpy.types.Object) -> bool:
    return not source.data.is_editmode and any(modifier.show_viewport for modifier in source.modifiers)


def _seam_of_edge(report: dict) -> Mapping[tuple[int, int], int]:
    return {(min(edge), max(edge)): seam["index"] for seam in report["seams"] for edge in seam["edges"]}


def _piece_names(flat: bpy.types.Object) -> list[Name]:
    """At the face nearest to each piece's middle."""
    mesh, text_of = flat.data, piece_names(model_of(flat))
    pieces = read_flat_attribute(mesh, PIECE)
    centers = read(mesh.polygons, "center", np.float32, 3)
    names = []
    for piece in np.unique(pieces).tolist():
        own = centers[pieces == piece]
        middle = (own.min(axis=0) + own.max(axis=0)) / 2
        place = own[np.argmin(np.linalg.norm(own - middle, axis=1))]
        reach = float(np.linalg.norm(own - place, axis=1).max())
        names.append(Name(text_of.get(piece, ""), place[None], np.array([[0.0, 0.0, 1.0]]), reach))
    return names


def colored_surface(
    target: bpy.types.Object, depsgraph: bpy.types.Depsgraph, color_map: ColorMap
) -> ColoredTriangles | None:
    """The map on flat pieces, or on a model that has them; None where there is no map to this shape."""
    flat = target if model_of(target) else find_flat_object(target)
    if flat is None or flat.data.is_editmode:
        return None
    colors = read_attribute(flat.data, color_map.attribute, "FLOAT_COLOR", "CORNER")
    if colors is None:
        return None
    extremes = map_extremes(flat.data, color_map)
    if flat == target:
        return colored(gather_triangles(flat.data), colors, extremes)
    corners = read_flat_attribute(flat.data, SOURCE_CORNER)
    if corners is None or current_report(target) is None:
        return None
    with shown_mesh(target, depsgraph) as mesh:
        return colored(gather_triangles(mesh), on_model(colors, corners, len(mesh.loops)), extremes)


def map_extremes(flat: bpy.types.Mesh, color_map: ColorMap) -> Extremes | None:
    """None on flat pieces that an earlier version wrote."""
    ranges = read_numbers(flat, f"{RANGE}{color_map.attribute}")
    return tuple(ranges.tolist()) if ranges is not None and len(ranges) == 2 else None
