# SPDX-License-Identifier: GPL-3.0-or-later
"""Collects the failures of the last report, their fixes and the suggested cut as arrays, without the GPU."""

from dataclasses import dataclass

import bpy
import numpy as np

from ..blender.attributes import find_values, has_attributes
from ..blender.mesh import (
    corner_edges,
    corner_vertices,
    current_mesh,
    edge_vertices,
    faces_of_corners,
    next_loops,
    vertex_places,
)
from ..core import Issue, Kind
from ..names import SOURCE_FACE, SOURCE_VERTEX
from ..solve.chains import are_among
from ..solve.cut_faces import Segments, places_on
from ..solve.report import ObjectReport
from ..state.changes import has_changed
from ..state.owners import model_of, model_or_self
from ..state.reports import pieces_report
from ..state.suggestions import current_suggestions
from .gather import gather_triangles, shown_mesh, uv_places
from .objects import current_report, is_modified


@dataclass(frozen=True)
class Failures:
    lines: dict[str, np.ndarray]  # (2k,3) float32, ends of lines by kind: failed elements and suggested seams
    triangles: np.ndarray  # (3m,3) float32, corners of the failed faces

    @property
    def kinds(self) -> set[str]:
        """Return the kinds of line for the legend. Tinted faces count as "failed", because a closed piece has no failed
        edges."""
        return {*self.lines, "failed"} if len(self.triangles) else set(self.lines)


@dataclass(frozen=True)
class _Elements:
    """Failed elements and suggested seams, on the object's own mesh."""

    edges: dict[str, np.ndarray]  # (e,) bool for each kind of line
    faces: np.ndarray  # (f,) failed faces


def failures(target: bpy.types.Object, *, in_map: bool = False) -> Failures | None:
    """Return the failures on a model or its flat pieces; None if there are none.

    in_map: return places in the map of the pieces, for an object in Object Mode
    """
    report = None if _hides_changes(target) else current_report(target)
    if report is None or report.with_modifiers or not report.issues:
        return None
    with current_mesh(target) as mesh:
        found = _elements(target, mesh, report)
        if found is None:
            return None
        triangles = gather_triangles(mesh)
        if in_map:
            following = next_loops(mesh)
            ends = np.column_stack([np.arange(len(following)), following])
            places, edges, corners = uv_places(mesh), corner_edges(mesh), triangles.corners
        else:
            ends = edge_vertices(mesh)
            places, edges, corners = vertex_places(mesh), np.arange(len(ends)), triangles.vertices
        lines = {kind: places[ends[mask[edges]].ravel()] for kind, mask in found.edges.items()}
        return Failures(lines, places[corners[np.isin(triangles.polygons, found.faces)].ravel()])


def _hides_changes(target: bpy.types.Object) -> bool:
    """Return whether changes of the model cannot be noticed: in Edit Mode, Blender shows the active shape key."""
    mesh = model_or_self(target).data
    return mesh.is_editmode and mesh.shape_keys is not None


def _elements(target: bpy.types.Object, mesh: bpy.types.Mesh, report: ObjectReport) -> _Elements | None:
    """Return the failed elements on the present mesh of the target; None if flat pieces lack the attributes of their
    sources."""
    source = np.arange(len(mesh.vertices))
    if model_of(target):
        if not has_attributes(mesh, SOURCE_VERTEX, SOURCE_FACE):
            return None
        source = find_values(mesh, SOURCE_VERTEX)
    # A model that only needs its first seams has not failed. In Edit Mode, the selection shows the failed elements.
    is_uncut = {line.kind for line in report.tables.verdict.lines} <= {Kind.CLOSED, Kind.NEEDS_SEAM}
    issues = [] if is_uncut or target.data.is_editmode else report.issues
    faces = _failed_faces(mesh, issues)
    pairs = np.sort(source[edge_vertices(mesh)], axis=1)
    masks = {
        "failed": _failed_edges(mesh, pairs, issues, faces),
        "proposed": are_among(pairs, [] if current_suggestions(model_or_self(target)) else report.offered_seams),
    }
    return _Elements({kind: mask for kind, mask in masks.items() if mask.any()}, faces)


def _failed_faces(mesh: bpy.types.Mesh, issues: list[Issue]) -> np.ndarray:
    faces = np.array([face for issue in issues for face in issue.faces], dtype=np.int32)
    source_faces = find_values(mesh, SOURCE_FACE)
    return faces if source_faces is None else np.flatnonzero(np.isin(source_faces, faces))


def _failed_edges(mesh: bpy.types.Mesh, pairs: np.ndarray, issues: list[Issue], faces: np.ndarray) -> np.ndarray:
    """Return a mask (e,) of the edges of issues, edges at vertices of issues, and borders of failed faces.

    Edges between failed faces are left out, because they would hide wires and suggested seams.
    """
    failed = are_among(pairs, [edge for issue in issues for edge in issue.edges])
    failed |= np.isin(pairs, [vertex for issue in issues for vertex in issue.vertices]).any(axis=1)
    face_of_corner = faces_of_corners(mesh)
    of_faces = corner_edges(mesh)[np.isin(face_of_corner, faces)]
    return failed | (np.bincount(of_faces, minlength=len(pairs)) == 1)


NO_LINES = np.zeros((0, 3), dtype=np.float32)


def with_cut(failed: Failures | None, ends: np.ndarray) -> Failures | None:
    """Return the failures and the lines of the suggested cut together. ends (2k,3): ends of these lines."""
    if not len(ends):
        return failed
    failed = failed or Failures({}, NO_LINES)
    proposed = np.concatenate([failed.lines.get("proposed", NO_LINES), ends])
    return Failures(failed.lines | {"proposed": proposed}, failed.triangles)


def suggested_lines(target: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> np.ndarray:
    """Return the ends (2k,3) of the lines of the chosen cut on a model or flat pieces; empty if it cannot be shown."""
    segments = _segments(target)
    if segments is None:
        return NO_LINES
    with shown_mesh(target, depsgraph) as mesh:
        places, faces, vertices = vertex_places(mesh), faces_of_corners(mesh), corner_vertices(mesh)
        sources = vertices
        if model_or_self(target) != target:
            if not has_attributes(mesh, SOURCE_VERTEX, SOURCE_FACE):
                return NO_LINES
            faces, sources = find_values(mesh, SOURCE_FACE)[faces], find_values(mesh, SOURCE_VERTEX)[vertices]
    return places_on(segments, faces, sources, places[vertices])


def uv_suggested_lines(model: bpy.types.Object) -> np.ndarray:
    """Return the ends (2k,3) of the lines of the chosen cut in the map of the pieces, for an object in Object Mode."""
    segments = _segments(model)
    if segments is None or is_modified(model):  # the map belongs to the mesh without modifiers
        return NO_LINES
    mesh = model.data
    return places_on(segments, faces_of_corners(mesh), corner_vertices(mesh), uv_places(mesh))


def _segments(target: bpy.types.Object) -> Segments | None:
    """Return the segments of the chosen cut; None if they cannot be shown, for example on a mesh with modifiers."""
    source = model_or_self(target)
    found = None if _hides_changes(target) else current_suggestions(source)
    if found is None:
        return None
    if source == target:
        is_seen = is_modified(source) == found.with_modifiers
    else:
        report = pieces_report(source)
        is_same = report is not None and report.with_modifiers == found.with_modifiers
        is_seen = is_same and not has_changed(source, report.model_state)
    return found.cuts[found.chosen].segments if is_seen else None
