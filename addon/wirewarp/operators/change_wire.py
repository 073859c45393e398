# SPDX-License-Identifier: GPL-3.0-or-later
import math

import bpy
from bpy.props import StringProperty

from ..change_wire import change_wire, wire_at
from ..edit_marks import OUTLINES_ARE_RIGID
from ..issues import ObjectError
from ..wire_summary import listed_wires
from ..words import counted
from .wire_kind import NEEDS_TOLERANCE, WireKind
from .wire_operator import WireOperator


class MESH_OT_wirewarp_change_wire(WireKind, WireOperator, bpy.types.Operator):
    """Change the name, the kind or the tolerance of this wire"""

    bl_idname = "mesh.wirewarp_change_wire"
    bl_label = "Change Wire"
    on_model = "change the wire"

    name: StringProperty(name="Name", description="What the wire is called; left empty, it keeps its name")

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        try:
            self._start_from(context)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return context.window_manager.invoke_props_dialog(self)

    def _start_from(self, context: bpy.types.Context) -> None:
        """The settings are those of the wire as it is."""
        wire = wire_at(context.active_object, self.edge)
        self.name = next(name for name, each in listed_wires(context.active_object) if self.edge in each.edges)
        if wire.tolerance == 0:
            self.kind = "RIGID"
        else:
            self.kind = "SUPER_ELASTIC" if math.isinf(wire.tolerance) else "ELASTIC"
        elastic = self.kind == "ELASTIC"
        self.tolerance = wire.tolerance if elastic else context.scene.wirewarp.tolerance_percent / 100

    def execute(self, context: bpy.types.Context) -> set[str]:
        if self.is_tolerance_missing():
            self.report({"ERROR"}, NEEDS_TOLERANCE)
            return {"CANCELLED"}
        return super().execute(context)

    def act(self, target: bpy.types.Object) -> None:
        left_out = change_wire(target, self.edge, self.name, self.chosen_tolerance())
        if left_out:
            lie = counted(left_out, "edge that lies", "edges that lie")
            self.report({"WARNING"}, f"Changed, but not {lie} on a seam or outline. {OUTLINES_ARE_RIGID}.")

    def draw(self, _context: bpy.types.Context) -> None:
        self.layout.use_property_split = True
        self.layout.prop(self, "name")
        self.draw_kind(self.layout)
