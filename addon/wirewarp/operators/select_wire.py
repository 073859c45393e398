# SPDX-License-Identifier: GPL-3.0-or-later
import bpy
import numpy as np
from bpy.props import FloatProperty, IntProperty

from ..foreach import read
from ..issues import ObjectError
from ..selection import select_elements
from ..wire_attributes import read_marks


class MESH_OT_wirewarp_select_wire(bpy.types.Operator):
    """Select this wire's edges in Edit Mode"""

    bl_idname = "mesh.wirewarp_select_wire"
    bl_label = "Select Wire"
    bl_options = {"REGISTER", "UNDO"}

    wire_id: IntProperty(name="Wire Id", description="The wire's id on the edges", options={"HIDDEN"})
    tolerance: FloatProperty(
        name="Tolerance",
        description="Edges of one id with different tolerances are different wires",
        options={"HIDDEN"},
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        return active is not None and active.type == "MESH" and context.mode in {"OBJECT", "EDIT_MESH"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        target = context.active_object
        if context.mode == "EDIT_MESH":
            bpy.ops.object.mode_set(mode="OBJECT")
        try:
            select_elements(context, target, edges=self._edges(target.data))
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}

    def _edges(self, mesh: bpy.types.Mesh) -> np.ndarray:
        marks = read_marks(mesh)
        # A property cannot hold infinity: it becomes the largest number.
        tolerances = np.minimum(marks.tolerances, np.finfo(np.float32).max)
        members = (marks.wire_ids == self.wire_id) & (tolerances == np.float32(self.tolerance))
        return read(mesh.edges, "vertices", np.int32, 2)[members]
