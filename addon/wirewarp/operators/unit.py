# SPDX-License-Identifier: GPL-3.0-or-later
"""What a Blender unit means."""

import bpy
from bpy.props import FloatProperty

from ..blender.modes import hold_whole_file
from ..blender.units import meters_per_blender_unit


class SCENE_OT_wirewarp_set_unit(bpy.types.Operator):
    """Take the lengths of this scene to be in this unit. Nothing changes its place or its size in the view"""

    bl_idname = "scene.wirewarp_set_unit"
    bl_label = "Set Unit"
    bl_options = {"REGISTER", "UNDO"}

    meters: FloatProperty(name="Unit", description="Meters in one Blender unit", min=1e-6, max=1e6, default=0.01)

    def execute(self, context: bpy.types.Context) -> set[str]:
        scene = context.scene
        before, settings = meters_per_blender_unit(scene), scene.unit_settings
        if settings.system == "NONE":
            settings.system = "METRIC"
        settings.scale_length = self.meters
        scene.wirewarp.spacing *= before / self.meters  # as long as it was
        hold_whole_file()
        return {"FINISHED"}
