# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth Seam: a seam along edges becomes a smooth line, cut into the mesh."""

import bmesh
import bpy
import numpy as np

from ..blender.mesh import edge_vertices, faces_at_edges, read_seams, read_selected_edges
from ..blender.modes import in_object_mode
from ..blender.objects import check_local
from ..issues import Issue, ObjectError, object_error
from ..model.change import edges_with_marks
from ..model.owners import check_not_edited
from ..run.smooth_lines import cut_smooth_lines
from ..solve.suggest import Pairs
from ..words import counted
from .editing import OnModel, reporting_refusals


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
