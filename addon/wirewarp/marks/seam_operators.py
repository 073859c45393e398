# SPDX-License-Identifier: GPL-3.0-or-later
"""To begin to mark a model, and Blender's own Mark Seam with a question before it cuts every edge."""

import bmesh
import bpy
from bpy.props import BoolProperty

from ..ui.editing import OnModel

WIDTH = 360  # of the question, in Blender's own pixels


def has_every_edge(mesh: bpy.types.Mesh) -> bool:
    """Whether all edges of a mesh in Edit Mode are selected, as they are in a model that was just imported."""
    edges = bmesh.from_edit_mesh(mesh).edges
    return len(edges) > 0 and all(edge.select for edge in edges)


def _deselect(mesh: bpy.types.Mesh) -> None:
    edit = bmesh.from_edit_mesh(mesh)
    for elements in (edit.faces, edit.edges, edit.verts):
        for element in elements:
            element.select = False
    edit.select_flush(False)
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


class OBJECT_OT_wirewarp_mark_model(bpy.types.Operator):
    """Enter Edit Mode to select edges and mark them as seams and wires. If every edge is selected, none is then"""

    bl_idname = "object.wirewarp_mark_model"
    bl_label = "Mark This Model"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        if active is None or active.type != "MESH" or context.mode != "OBJECT":
            return False
        if active.library or active.data.library or active.override_library:
            cls.poll_message_set("Linked data cannot be edited. Use Object > Relations > Make Local first")
            return False
        return active.visible_get()

    def execute(self, context: bpy.types.Context) -> set[str]:
        bpy.ops.object.mode_set(mode="EDIT")
        context.tool_settings.mesh_select_mode = (False, True, False)
        for mesh in (each.data for each in context.objects_in_mode_unique_data):
            if has_every_edge(mesh):
                _deselect(mesh)
        return {"FINISHED"}


class MESH_OT_wirewarp_mark_seam(OnModel, bpy.types.Operator):
    """Mark the selected edges as seams, or clear them; asks first if every edge is selected"""

    bl_idname = "mesh.wirewarp_mark_seam"
    bl_label = "Mark Seam"
    bl_options = {"INTERNAL", "REGISTER", "UNDO"}
    on_model = "mark seams"
    _asks = False

    clear: BoolProperty(name="Clear", description="Clear seams", default=False, options={"HIDDEN"})

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        if properties.clear:
            return "Make the selected edges ordinary edges again"
        return "The fabric is cut along the selected edges"

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        if not self.clear and any(has_every_edge(each.data) for each in context.objects_in_mode_unique_data):
            self._asks = True
            return context.window_manager.invoke_props_dialog(self, width=WIDTH)
        return self.execute(context)

    def draw(self, _context: bpy.types.Context) -> None:
        """The question, in the dialog alone."""
        if self._asks:
            self.layout.label(text="Every edge is selected. Cut the fabric along all of them?", icon="QUESTION")

    def execute(self, _context: bpy.types.Context) -> set[str]:
        self._asks = False
        return bpy.ops.mesh.mark_seam(clear=self.clear)


CLASSES = (OBJECT_OT_wirewarp_mark_model, MESH_OT_wirewarp_mark_seam)
