# SPDX-License-Identifier: GPL-3.0-or-later
import bpy

from ..edit_marks import clear_selected
from ..issues import ObjectError


class MESH_OT_wirewarp_clear(bpy.types.Operator):
    """The selected edges are wires no longer"""

    bl_idname = "mesh.wirewarp_clear"
    bl_label = "Clear Wire"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return context.mode == "EDIT_MESH"

    def execute(self, context: bpy.types.Context) -> set[str]:
        try:
            count = clear_selected(context.objects_in_mode_unique_data)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if count == 0:
            self.report({"WARNING"}, "No selected edge is a wire")
            return {"CANCELLED"}
        return {"FINISHED"}
