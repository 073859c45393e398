# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn of one object: arrays and names, no GPU. Everything is in the object's own space."""

from collections.abc import Mapping
from dataclasses import dataclass

import bpy
import numpy as np

from ..color_maps import ColorMap
from ..edge_keys import edge_keys
from ..foreach import read
from ..model_state import has_changed
from ..pieces.attribute import PIECE
from ..pieces.records import piece_names
from ..report_store import last_report
from ..wire_names import names_of
from ..write_flat_object import find_flat_object
from ..write_helper_wires import find_helper_wires
from .gather import gather_lines, gather_triangles, shown_mesh
from .line_marks import Name, lines_by_kind, seam_line_names, wire_line_names
from .surface_arrays import ColoredTriangles, colored, on_model, places_of


@dataclass(frozen=True)
class Lines:
    places: dict[str, np.ndarray]  # (2k,3) float32 for each kind of line
    names: list[Name]


@dataclass(frozen=True)
class Failures:
    lines: dict[str, np.ndarray]  # (2k,3) float32 for each kind of line: what failed, and what would mend it
    triangles: np.ndarray  # (3m,3) float32


def marked_lines(target: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> Lines:
    """Seams, wires and helper wires of a model or of flat pieces. Raises ObjectError as gather_lines does."""
    marks, names = gather_lines(target, depsgraph), []
    if target.wirewarp_source and target.mode == "OBJECT" and PIECE in target.data.attributes:
        names += _piece_names(target)
    names += wire_line_names(marks, names_of(target.data, marks.wire_ids[marks.wire_ids != 0].tolist()))
    report = current_report(target)
    if report:
        names += seam_line_names(marks, _seam_of_edge(report))
    places = lines_by_kind(marks)
    helpers = find_helper_wires(target)
    if helpers:
        ends = read(helpers.data.edges, "vertices", np.int32, 2).ravel()
        places["helper"] = read(helpers.data.vertices, "co", np.float32, 3)[ends]
    return Lines(places, names)


def current_report(target: bpy.types.Object) -> dict | None:
    """The last report, if its elements are still those of the object as it is shown."""
    source = target.wirewarp_source or target
    report = last_report(source)
    if not report:
        return None
    if source != target:
        return report
    other_shape = report.get("with_modifiers", False) != _is_modified(source)
    return None if other_shape or has_changed(source, report) else report


def _is_modified(source: bpy.types.Object) -> bool:
    return source.mode == "OBJECT" and any(modifier.show_viewport for modifier in source.modifiers)


def _seam_of_edge(report: dict) -> Mapping[tuple[int, int], int]:
    return {(min(edge), max(edge)): seam["index"] for seam in report["seams"] for edge in seam["edges"]}


def _piece_names(flat: bpy.types.Object) -> list[Name]:
    """At the face nearest to each piece's middle."""
    mesh, text_of = flat.data, piece_names(flat.wirewarp_source)
    pieces = read(mesh.attributes[PIECE].data, "value", np.int32)
    centers = read(mesh.polygons, "center", np.float32, 3)
    names = []
    for piece in np.unique(pieces).tolist():
        own = centers[pieces == piece]
        middle = (own.min(axis=0) + own.max(axis=0)) / 2
        place = own[np.argmin(np.linalg.norm(own - middle, axis=1))]
        names.append(Name(text_of.get(piece, ""), place, np.array([0.0, 0.0, 1.0])))
    return names


def colored_surface(
    target: bpy.types.Object, depsgraph: bpy.types.Depsgraph, color_map: ColorMap
) -> ColoredTriangles | None:
    """The map on flat pieces, or on a model that has them; None where there is no map to this shape."""
    flat = target if target.wirewarp_source else find_flat_object(target)
    if flat is None or flat.mode != "OBJECT" or color_map.attribute not in flat.data.color_attributes:
        return None
    colors = read(flat.data.color_attributes[color_map.attribute].data, "color", np.float32, 4)
    if flat == target:
        return colored(gather_triangles(flat.data), colors)
    if current_report(target) is None or "source_corner" not in flat.data.attributes:
        return None
    corners = read(flat.data.attributes["source_corner"].data, "value", np.int32)
    with shown_mesh(target, depsgraph) as mesh:
        return colored(gather_triangles(mesh), on_model(colors, corners, len(mesh.loops)))


def failures(target: bpy.types.Object) -> Failures | None:
    """The elements that the last report complains about, on the model and on its flat pieces."""
    report = current_report(target)
    if report is None or report.get("with_modifiers") or not report["issues"]:
        return None
    mesh, source = target.data, np.arange(len(target.data.vertices))
    if target.wirewarp_source:
        if not {"source_vertex", "source_face"} <= set(mesh.attributes.keys()):
            return None
        source = read(mesh.attributes["source_vertex"].data, "value", np.int32)
    faces = _failed_faces(mesh, report["issues"])
    edges = read(mesh.edges, "vertices", np.int32, 2)
    pairs = np.sort(source[edges], axis=1)
    masks = {
        "failed": _failed_edges(mesh, pairs, report["issues"], faces),
        "proposed": _named(pairs, [edge for issue in report["issues"] for edge in issue.get("proposed_seams", [])]),
    }
    places = read(mesh.vertices, "co", np.float32, 3)
    lines = {kind: places[edges[mask].ravel()] for kind, mask in masks.items() if mask.any()}
    return Failures(lines, places_of(gather_triangles(mesh), faces))


def _failed_faces(mesh: bpy.types.Mesh, issues: list[dict]) -> np.ndarray:
    faces = np.array([face for issue in issues for face in issue["faces"]], dtype=np.int32)
    if "source_face" not in mesh.attributes:
        return faces
    return np.flatnonzero(np.isin(read(mesh.attributes["source_face"].data, "value", np.int32), faces))


def _failed_edges(mesh: bpy.types.Mesh, pairs: np.ndarray, issues: list[dict], faces: np.ndarray) -> np.ndarray:
    """A mask of the edges that are named, and of all edges of faces and at vertices that are."""
    failed = _named(pairs, [edge for issue in issues for edge in issue["edges"]])
    failed |= np.isin(pairs, [vertex for issue in issues for vertex in issue["vertices"]]).any(axis=1)
    face_of_corner = np.repeat(np.arange(len(mesh.polygons)), read(mesh.polygons, "loop_total", np.int32))
    failed[read(mesh.loops, "edge_index", np.int32)[np.isin(face_of_corner, faces)]] = True
    return failed


def _named(pairs: np.ndarray, edges: list) -> np.ndarray:
    """A mask of those pairs of the model's vertices (e,2) that are among the edges."""
    wanted = np.array(edges, dtype=np.int64).reshape(-1, 2)
    count = max(int(pairs.max(initial=0)), int(wanted.max(initial=0))) + 1
    return np.isin(edge_keys(pairs, count), edge_keys(wanted, count))
