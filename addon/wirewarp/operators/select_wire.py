# SPDX-License-Identifier: GPL-3.0-or-later
import bpy
from bpy.props import IntProperty

from ..change_wire import wire_at
from ..foreach import read
from ..issues import ObjectError, object_error
from ..mesh_topology import edge_vertices
from ..selection import select_elements, update_mesh
from ..wire_summary import find_wires


class MESH_OT_wirewarp_select_wire(bpy.types.Operator):
    """Select this wire's edges in Edit Mode"""

    bl_idname = "mesh.wirewarp_select_wire"
    bl_label = "Select Whole Wires"
    bl_options = {"REGISTER", "UNDO"}

    edge: IntProperty(
        name="Edge",
        description="Any edge of the wire, by its index; -1: the wires of all selected edges",
        min=-1,
        default=-1,
        options={"HIDDEN"},
    )

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        return cls.__doc__ if properties.edge >= 0 else "Select all edges of the wires of which an edge is selected"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        return active is not None and active.type == "MESH" and context.mode in {"OBJECT", "EDIT_MESH"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        target = context.active_object
        update_mesh(target)
        try:
            rows = wire_at(target, self.edge).edges if self.edge >= 0 else self._rows_of_selected(target)
            select_elements(context, target, edges=edge_vertices(target.data)[rows])
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}

    def _rows_of_selected(self, target: bpy.types.Object) -> list[int]:
        selected = read(target.data.edges, "select", bool)
        found = [wire.edges for wire in find_wires(target.data) if selected[wire.edges].any()]
        if not found:
            raise object_error("no_wire", "No selected edge is a wire: select an edge of the wire first.")
        return [row for rows in found for row in rows]
