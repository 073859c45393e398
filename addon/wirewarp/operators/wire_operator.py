# SPDX-License-Identifier: GPL-3.0-or-later
"""What the buttons beside one wire have in common."""

import bpy
from bpy.props import IntProperty

from ..issues import ObjectError
from ..owners import model_of
from ..targets import check_local, in_object_mode


class WireOperator:
    """Acts on one wire of the active model, in Object Mode. Subclasses say how, and what is to be done on the model."""

    bl_options = {"REGISTER", "UNDO"}
    on_model = ""

    edge: IntProperty(name="Edge", description="Any edge of the wire, by its index", min=0, options={"HIDDEN"})

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        if active is None or active.type != "MESH" or context.mode not in {"OBJECT", "EDIT_MESH"}:
            return False
        if model_of(active):
            cls.poll_message_set(f"These are flat pieces: {cls.on_model} on the model")
            return False
        return True

    def execute(self, context: bpy.types.Context) -> set[str]:
        target = context.active_object
        try:
            check_local(target, target.data)
            with in_object_mode(context):
                self.act(target)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}
