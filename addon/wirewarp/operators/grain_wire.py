# SPDX-License-Identifier: GPL-3.0-or-later
import bpy
from bpy.props import IntProperty

from ..change_wire import change_grain
from ..issues import ObjectError
from ..targets import in_object_mode
from ..undo_step import hold_whole_file


class MESH_OT_wirewarp_grain_wire(bpy.types.Operator):
    """Make this wire the grain wire, which stands upright in the pieces it runs through; again: no longer"""

    bl_idname = "mesh.wirewarp_grain_wire"
    bl_label = "Grain Wire"
    bl_options = {"REGISTER", "UNDO"}

    edge: IntProperty(name="Edge", description="Any edge of the wire, by its index", min=0, options={"HIDDEN"})

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        if active is None or active.type != "MESH" or context.mode not in {"OBJECT", "EDIT_MESH"}:
            return False
        if active.wirewarp_source:
            cls.poll_message_set("These are flat pieces: choose the grain wire on the model")
            return False
        return True

    def execute(self, context: bpy.types.Context) -> set[str]:
        target = context.active_object
        try:
            with in_object_mode(context):
                change_grain(target, self.edge)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        hold_whole_file()
        return {"FINISHED"}
