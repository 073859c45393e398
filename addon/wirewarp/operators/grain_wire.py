# SPDX-License-Identifier: GPL-3.0-or-later
import bpy
from bpy.props import IntProperty

from ..change_wire import wire_at
from ..issues import ObjectError


class MESH_OT_wirewarp_grain_wire(bpy.types.Operator):
    """Make this wire the grain wire, which stands upright in the pieces it runs through; again: no longer"""

    bl_idname = "mesh.wirewarp_grain_wire"
    bl_label = "Grain Wire"
    bl_options = {"REGISTER", "UNDO"}

    edge: IntProperty(name="Edge", description="Any edge of the wire, by its index", min=0, options={"HIDDEN"})

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        return active is not None and active.type == "MESH" and active.wirewarp_source is None

    def execute(self, context: bpy.types.Context) -> set[str]:
        target = context.active_object
        try:
            wire = wire_at(target, self.edge)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        mesh = target.data
        mesh.wirewarp_grain = 0 if mesh.wirewarp_grain == wire.wire_id else wire.wire_id
        return {"FINISHED"}
