# SPDX-License-Identifier: GPL-3.0-or-later
"""Moving the view to model and pieces."""

import math

import bpy
import numpy as np
from mathutils import Quaternion, Vector

from ..blender.views import Projection, fit
from ..model.owners import find_flat_object, model_or_self

LEAST_ELEVATION, ELEVATION = math.radians(15), math.radians(40)  # of the eye above the pieces


class VIEW3D_OT_wirewarp_frame(bpy.types.Operator):
    """Move the view so that the model and its flat pieces are in sight"""

    bl_idname = "view3d.wirewarp_frame"
    bl_label = "Show Model and Pieces"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return context.area is not None and context.area.type == "VIEW_3D" and len(_objects(context)) == 2

    def execute(self, context: bpy.types.Context) -> set[str]:
        space = context.space_data
        view, region = space.region_3d, next(each for each in context.area.regions if each.type == "WINDOW")
        if view.view_perspective == "CAMERA":
            view.view_perspective = "PERSP"
            view.update()
        self._rise(view)
        corners = [target.matrix_world @ Vector(corner) for target in _objects(context) for corner in target.bound_box]
        is_perspective = view.view_perspective == "PERSP"
        projection = Projection(
            axes=np.array(view.view_rotation.to_matrix()),
            across=view.window_matrix[0][0],
            upward=view.window_matrix[1][1],
            is_perspective=is_perspective,
            covered=_covered(context) / region.width,
        )
        middle, distance = fit(np.array(corners), projection)
        view.view_location = middle
        view.view_distance = distance if is_perspective else distance * view.view_distance
        return {"FINISHED"}

    def _rise(self, view: bpy.types.RegionView3D) -> None:
        """In a view from the side (Numpad 1 or 3) flat pieces are lines: look down on them."""
        right, _, toward = view.view_rotation.to_matrix().col
        elevation = math.asin(max(-1.0, min(1.0, toward.z)))
        if abs(elevation) < LEAST_ELEVATION:
            view.view_rotation = Quaternion(right, elevation - ELEVATION) @ view.view_rotation
            view.update()


def _objects(context: bpy.types.Context) -> list[bpy.types.Object]:
    """The active model and its flat pieces, as far as they are there."""
    active = context.active_object
    if active is None:
        return []
    source = model_or_self(active)
    return [each for each in (source, find_flat_object(source)) if each is not None]


def _covered(context: bpy.types.Context) -> int:
    """Pixels of the view that lie below the sidebar."""
    sidebar = next(each for each in context.area.regions if each.type == "UI")
    return sidebar.width if context.preferences.system.use_region_overlap and sidebar.width > 1 else 0
