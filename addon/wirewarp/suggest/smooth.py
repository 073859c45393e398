# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth lines in place of edges: computed by the core, cut into the mesh; and the button for the selected seam."""

from itertools import pairwise

import bmesh
import bpy
import numpy as np

from .. import core
from ..blender.mesh import edge_vertices, faces_at_edges, read_seams, read_selected_edges
from ..blender.modes import in_object_mode
from ..blender.objects import check_local
from ..issues import Issue, ObjectError, object_error
from ..marks.change import clear_seams, edges_with_marks, mark_seams
from ..solve.chains import split_into_chains
from ..solve.smooth_lines import smooth_line
from ..solve.suggest import Pairs
from ..state.marked_mesh import marked_mesh
from ..state.owners import check_not_edited
from ..state.read_model import object_to_arrays
from ..state.suggestions import read_no_seam
from ..ui.editing import OnModel, reporting_refusals
from ..words import counted
from .cut_lines import cut_line, unchanged_on_error


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
    """Those between two faces. Raises ObjectError where marks would be lost."""
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
    """These edges alone, in Edit Mode."""
    edit = bmesh.from_edit_mesh(mesh)
    for element in (*edit.verts, *edit.edges, *edit.faces):
        element.select_set(False)
    edit.verts.ensure_lookup_table()
    for a, b in pairs:
        edit.edges.get((edit.verts[a], edit.verts[b])).select_set(True)
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


CLASSES = (MESH_OT_wirewarp_smooth_seam,)
