# SPDX-License-Identifier: GPL-3.0-or-later
"""To begin to mark a model, and Blender's own Mark Seam with a question before it cuts every edge."""

import bmesh
import bpy
from bpy.props import BoolProperty

from ..ui.editing import OnModel


def has_every_edge(mesh: bpy.types.Mesh) -> bool:
    """Whether all edges of a mesh in Edit Mode are selected, as they are in a model that was just imported."""
    edges = bmesh.from_edit_mesh(mesh).edges
    return len(edges) > 0 and all(edge.select for edge in edges)


class OBJECT_OT_wirewarp_mark_model(bpy.types.Operator):
    """Enter Edit Mode with no edge selected, to select edges and mark them as seams and wires"""

    bl_idname = "object.wirewarp_mark_model"
    bl_label = "Mark This Model"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        return active is not None and active.type == "MESH" and context.mode == "OBJECT" and active.visible_get()

    def execute(self, context: bpy.types.Context) -> set[str]:
        bpy.ops.object.mode_set(mode="EDIT")
        context.tool_settings.mesh_select_mode = (False, True, False)
        if all(map(has_every_edge, [each.data for each in context.objects_in_mode_unique_data])):
            bpy.ops.mesh.select_all(action="DESELECT")
        return {"FINISHED"}


class MESH_OT_wirewarp_mark_seam(OnModel, bpy.types.Operator):
    """Mark the selected edges as seams, or clear them; asks first if every edge is selected"""

    bl_idname = "mesh.wirewarp_mark_seam"
    bl_label = "Mark Every Edge as Seam"  # the question
    bl_options = {"INTERNAL", "REGISTER", "UNDO"}
    on_model = "mark seams"

    clear: BoolProperty(name="Clear", description="Clear seams", default=False, options={"HIDDEN"})

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        if properties.clear:
            return "Make the selected edges ordinary edges again"
        return "The fabric is cut along the selected edges"

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        if not self.clear and any(has_every_edge(each.data) for each in context.objects_in_mode_unique_data):
            return context.window_manager.invoke_confirm(self, event)
        return self.execute(context)

    def execute(self, _context: bpy.types.Context) -> set[str]:
        return bpy.ops.mesh.mark_seam(clear=self.clear)


CLASSES = (OBJECT_OT_wirewarp_mark_model, MESH_OT_wirewarp_mark_seam)
