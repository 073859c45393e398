# SPDX-License-Identifier: GPL-3.0-or-later
import math

import bpy
from bpy.props import EnumProperty, FloatProperty

from ..edit_marks import mark_selected
from ..issues import ObjectError
from ..tolerance_text import tolerance_text

KINDS = [
    ("RIGID", "Rigid", "A rigid wire keeps exactly its length on the model"),
    ("ELASTIC", "Elastic", "An elastic wire may become longer or shorter, up to the tolerance"),
    ("SUPER_ELASTIC", "Free", "A free wire (super-elastic) gets the length that distorts the pieces least"),
]
DESCRIPTIONS = {identifier: description for identifier, _, description in KINDS}


class MESH_OT_wirewarp_mark(bpy.types.Operator):
    """Make wires of the selected edges, one of each line"""

    bl_idname = "mesh.wirewarp_mark"
    bl_label = "Mark Wire"
    bl_options = {"REGISTER", "UNDO"}

    kind: EnumProperty(name="Kind", description="How strictly the wire keeps its length", items=KINDS, default="RIGID")
    tolerance: FloatProperty(
        name="Tolerance",
        description="Elastic wires: how much the total length may change, as a fraction (0.03 is 3 %)",
        min=0.0,
        soft_max=0.2,
        max=0.99,
        default=0.03,
        precision=4,
        step=1,
    )

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
        if self.kind == "ELASTIC" and self.tolerance == 0:
            self.report({"ERROR"}, "An elastic wire needs a tolerance above 0: set one, or mark the wire rigid.")
            return {"CANCELLED"}
        tolerance = {"RIGID": 0.0, "ELASTIC": self.tolerance, "SUPER_ELASTIC": math.inf}[self.kind]
        try:
            count = mark_selected(context.objects_in_mode_unique_data, tolerance)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if count == 0:
            self.report({"ERROR"}, "Nothing to mark: select the edges of the wire first.")
            return {"CANCELLED"}
        self.report({"INFO"}, f"{count} wire{'s' if count != 1 else ''} marked")
        return {"FINISHED"}

    def draw(self, _context: bpy.types.Context) -> None:
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "kind")
        if self.kind == "ELASTIC":
            layout.prop(self, "tolerance", text=f"Tolerance ({tolerance_text(self.tolerance)})")
