# SPDX-License-Identifier: GPL-3.0-or-later
"""Moving the view to model and pieces."""

import bpy

from ..blender.views import show_objects
from ..model.owners import find_flat_object, model_or_self


class VIEW3D_OT_wirewarp_frame(bpy.types.Operator):
    """Move the view so that the model and its flat pieces are in sight"""

    bl_idname = "view3d.wirewarp_frame"
    bl_label = "Show Model and Pieces"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return context.area is not None and context.area.type == "VIEW_3D" and len(_objects(context)) == 2

    def execute(self, context: bpy.types.Context) -> set[str]:
        show_objects(context, context.area, _objects(context))
        return {"FINISHED"}


def _objects(context: bpy.types.Context) -> list[bpy.types.Object]:
    """The active model and its flat pieces, as far as they are there."""
    active = context.active_object
    if active is None:
        return []
    source = model_or_self(active)
    return [each for each in (source, find_flat_object(source)) if each is not None]


CLASSES = (VIEW3D_OT_wirewarp_frame,)
