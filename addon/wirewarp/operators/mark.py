# SPDX-License-Identifier: GPL-3.0-or-later
import bpy

from ..edit_marks import OUTLINES_ARE_RIGID, mark_selected
from ..issues import ObjectError
from ..words import counted
from .wire_kind import DESCRIPTIONS, NEEDS_TOLERANCE, WireKind


class MESH_OT_wirewarp_mark(WireKind, bpy.types.Operator):
    """Make wires of the selected edges, one of each line"""

    bl_idname = "mesh.wirewarp_mark"
    bl_label = "Mark Wire"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        return f"Make wires of the selected edges, one of each line. {DESCRIPTIONS[properties.kind]}"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return context.mode == "EDIT_MESH"

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        if not self.properties.is_property_set("tolerance"):
            self.tolerance = context.scene.wirewarp.tolerance_percent / 100
        return self.execute(context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        if self.is_tolerance_missing():
            self.report({"ERROR"}, NEEDS_TOLERANCE)
            return {"CANCELLED"}
        try:
            count, left_out = mark_selected(context.objects_in_mode_unique_data, self.chosen_tolerance())
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if count == 0:
            self.report({"ERROR"}, "Nothing to mark: select the edges of the wire first.")
            return {"CANCELLED"}
        marked = f"{counted(count, 'wire')} marked"
        if left_out:
            lie = counted(left_out, "selected edge that lies", "selected edges that lie")
            self.report({"WARNING"}, f"{marked}, but not {lie} on a seam or outline. {OUTLINES_ARE_RIGID}.")
        else:
            self.report({"INFO"}, marked)
        return {"FINISHED"}

    def draw(self, _context: bpy.types.Context) -> None:
        self.layout.use_property_split = True
        self.draw_kind(self.layout)
