# SPDX-License-Identifier: GPL-3.0-or-later
import bpy

from ..change_wire import change_grain
from ..undo_step import hold_whole_file
from .wire_operator import WireOperator


class MESH_OT_wirewarp_grain_wire(WireOperator, bpy.types.Operator):
    """Make this wire the grain wire, which stands upright in the pieces it runs through; again: no longer"""

    bl_idname = "mesh.wirewarp_grain_wire"
    bl_label = "Grain Wire"
    on_model = "choose the grain wire"

    def act(self, target: bpy.types.Object) -> None:
        change_grain(target, self.edge)
        hold_whole_file()
