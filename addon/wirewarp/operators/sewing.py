# SPDX-License-Identifier: GPL-3.0-or-later
"""The flat pieces made ready to be sewn in a cloth simulation."""

import bpy

from ..blender.modes import in_object_mode
from ..flat.sewing import WORN, add_sewing_object
from ..model.owners import model_or_self
from .editing import reporting_refusals


class OBJECT_OT_wirewarp_sewing(bpy.types.Operator):
    """Copy the flat pieces with sewing edges between the sides of each seam, and a shape key that folds them onto the
    model"""

    bl_idname = "object.wirewarp_sewing"
    bl_label = "Add Sewing Edges"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        if active is not None and active.type == "MESH" and context.mode == "OBJECT":
            return True
        cls.poll_message_set("Select a model that has been flattened, or its flat pieces, in Object Mode")
        return False

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        with in_object_mode(context):
            target = add_sewing_object(model_or_self(context.active_object))
        context.view_layer.update()  # which does not know the new object yet
        if target.name not in context.view_layer.objects:  # as its flat pieces, whose collection is not shown here
            context.scene.collection.objects.link(target)
        for each in context.selected_objects:
            each.select_set(False)
        target.select_set(True)
        context.view_layer.objects.active = target
        told = f'"{target.name}" is ready for Physics > Cloth with Shape > Sewing; its shape key "{WORN}" closes it.'
        self.report({"INFO"}, told)
        return {"FINISHED"}


CLASSES = (OBJECT_OT_wirewarp_sewing,)
