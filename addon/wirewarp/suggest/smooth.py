# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth lines in place of edges: computed by the core, cut into the mesh; and the button for a seam.

The surface stays, and so do marks, maps and attributes: what is new gets them from what it lies on.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import pairwise

import bmesh
import bpy
import numpy as np

from .. import core
from ..blender.mesh import edge_vertices, faces_at_edges, read_seams, read_selected_edges
from ..blender.objects import check_local
from ..blender.selection import in_object_mode
from ..core import Issue, counted
from ..issues import ObjectError, object_error
from ..marks.ease import clear_seams, edges_with_marks, mark_seams
from ..names import MARKS
from ..solve.chains import split_into_chains
from ..solve.smooth_lines import Point, SmoothLine, smooth_line
from ..solve.suggest import Pairs
from ..state.marked_mesh import marked_mesh
from ..state.owners import check_not_edited
from ..state.read_model import object_to_arrays
from ..state.suggestions import read_no_seam
from ..ui.editing import OnModel, reporting_refusals


def cut_across_faces(mesh: bpy.types.Mesh, pairs: Pairs) -> None:
    """Adds edges, given as vertex pairs, across faces of four corners."""
    with _edited(mesh) as edited:
        vertices = list(edited.verts)
        for a, b in pairs:
            first, second = vertices[a], vertices[b]
            face = next(each for each in first.link_faces if second in each.verts and len(each.verts) == 4)
            _split(edited, face, first, second)


def cut_line(mesh: bpy.types.Mesh, line: SmoothLine) -> Pairs:
    """Makes edges of the line; vertices keep their indices. Returns these edges. Raises ObjectError, with no change."""
    with _edited(mesh) as edited:
        old_vertices, old_faces = list(edited.verts), list(edited.faces)
        for polygon, pairs in line.diagonals.items():
            parts = [old_faces[polygon]]
            for a, b in pairs:
                ends = old_vertices[a], old_vertices[b]
                face = next(each for each in parts if set(ends) <= set(each.verts))
                parts.append(_split(edited, face, *ends))
        vertices = [_vertex_at(edited, old_vertices, point) for point in line.points]
        for first, second in pairwise(vertices):
            if edited.edges.get((first, second)) is None:
                face = next(each for each in first.link_faces if second in each.verts)
                _split(edited, face, first, second)
        edited.verts.index_update()
        return [(first.index, second.index) for first, second in pairwise(vertices)]


@contextmanager
def unchanged_on_error(mesh: bpy.types.Mesh) -> Iterator[None]:
    """Cut all of several lines, or none."""
    before = bmesh.new()
    try:
        before.from_mesh(mesh)
        yield
    except Exception:
        before.to_mesh(mesh)
        mesh.update()
        raise
    finally:
        before.free()


@contextmanager
def _edited(mesh: bpy.types.Mesh) -> Iterator[bmesh.types.BMesh]:
    """Write the mesh at the end, unless something is raised."""
    edited = bmesh.new()
    try:
        edited.from_mesh(mesh)
        yield edited
        edited.to_mesh(mesh)
    finally:
        edited.free()
    mesh.update()


def _split(
    edited: bmesh.types.BMesh, face: bmesh.types.BMFace, first: bmesh.types.BMVert, second: bmesh.types.BMVert
) -> bmesh.types.BMFace:
    """Return the new face."""
    new, corner = bmesh.utils.face_split(face, first, second)
    for loop in corner.edge.link_loops:  # they are copies of corners that begin other edges
        for side in _side_layers(edited):
            loop[side] = 0.0
    return new


def _vertex_at(edited: bmesh.types.BMesh, vertices: list[bmesh.types.BMVert], point: Point) -> bmesh.types.BMVert:
    """Return the vertex at the point, a new one if there is none."""
    first, second, share = point
    if first == second:
        return vertices[first]
    edge = edited.edges.get((vertices[first], vertices[second]))
    if edge is None:
        sentence = f"The smooth line would cross itself at edge {first}-{second}. Mark it along edges instead."
        raise object_error("line_crosses_itself", sentence)
    _, vertex = bmesh.utils.edge_split(edge, vertices[first], share)
    for loop in vertex.link_loops:  # it begins the second half of what the corner before it began
        for side in _side_layers(edited):
            loop[side] = loop.link_loop_prev[side]
    return vertex


def _side_layers(edited: bmesh.types.BMesh) -> list[bmesh.types.BMLayerItem]:
    layers = edited.loops.layers.float
    return [layers[mark.name] for mark in MARKS if mark.domain == "CORNER" and mark.name in layers]


def cut_smooth_lines(source: bpy.types.Object, edges: Pairs) -> Pairs:
    """Each line of these edges becomes a smooth one with the same ends, which is a seam; what was one is none any more.

    Lines meet each other, other seams and wires where they did, and do not enter painted faces. Vertices keep their
    indices. Returns the edges of the smooth lines. Raises ObjectError, with no change.
    """
    mesh, seams = source.data, []
    places = object_to_arrays(source, marked_mesh(source), None).vertices
    paths = [chain.vertices for chain in split_into_chains(np.array(edges), places)]
    for path in paths:
        _check_ends(source, path)
    with unchanged_on_error(mesh):
        for index, path in enumerate(paths):
            clear_seams(mesh, list(pairwise(path)))  # before the line cuts some of these edges in two
            arrays = object_to_arrays(source, marked_mesh(source), None)
            kept = [pair for other in paths[index + 1 :] for pair in pairwise(other)]
            line = smooth_line(core.library(), arrays, path, kept, read_no_seam(source))
            cut = cut_line(mesh, line)
            mark_seams(mesh, cut)
            seams += cut
    return seams


def _check_ends(source: bpy.types.Object, path: list[int]) -> None:
    again = [vertex for index, vertex in enumerate(path) if vertex in path[:index]]
    if again:
        sentence = f'A line of "{source.name}" meets itself at vertex {again[0]}: smooth it in parts with two ends.'
        raise ObjectError(Issue("line_meets_itself", sentence, vertices=again))


class MESH_OT_wirewarp_smooth_seam(OnModel, bpy.types.Operator):
    """Replace the selected seam, which follows edges, by the shortest line beside it, cut into the faces"""

    bl_idname = "mesh.wirewarp_smooth_seam"
    bl_label = "Smooth Seam"
    bl_options = {"REGISTER", "UNDO"}
    on_model = "smooth the seam"

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        target = context.active_object
        with in_object_mode(context):
            check_local(target, target.data)
            check_not_edited(target)
            edges = _selected_seams(target)
            seams = cut_smooth_lines(target, edges) if edges else []
        if not seams:
            raise object_error("nothing", "Nothing to smooth: select edges of a seam first.")
        _select(target.data, seams)
        self.report({"INFO"}, f"A smooth line of {counted(len(seams), 'edge')} instead of {len(edges)}")
        return {"FINISHED"}


def _selected_seams(target: bpy.types.Object) -> Pairs:
    """Return the selected seams between two faces. Raises ObjectError if marks would be lost."""
    mesh = target.data
    rows = read_selected_edges(mesh) & read_seams(mesh) & (faces_at_edges(mesh) == 2)
    pairs = edge_vertices(mesh)
    marked = pairs[rows & edges_with_marks(mesh)]
    if len(marked):
        sentence = (
            f'{counted(len(marked), "selected edge")} of "{target.name}" would lose what is marked there: a wire, an '
            "ease or an allowance. Clear it first, and mark it on the smooth line again."
        )
        raise ObjectError(Issue("marks_lost", sentence, edges=[tuple(pair) for pair in marked.tolist()]))
    return [tuple(pair) for pair in pairs[np.flatnonzero(rows)].tolist()]


def _select(mesh: bpy.types.Mesh, pairs: Pairs) -> None:
    """Select only these edges, in Edit Mode."""
    edit = bmesh.from_edit_mesh(mesh)
    for element in (*edit.verts, *edit.edges, *edit.faces):
        element.select_set(False)
    edit.verts.ensure_lookup_table()
    for a, b in pairs:
        edit.edges.get((edit.verts[a], edit.verts[b])).select_set(True)
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


CLASSES = (MESH_OT_wirewarp_smooth_seam,)
