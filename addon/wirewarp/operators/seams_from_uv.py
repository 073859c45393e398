# SPDX-License-Identifier: GPL-3.0-or-later
import bpy

from ..issues import ObjectError
from ..seams_from_uv import seams_from_uv
from ..targets import in_object_mode


class MESH_OT_wirewarp_seams_from_uv_islands(bpy.types.Operator):
    """Mark seams where the islands of the active UV map end. Seams that are there stay"""

    bl_idname = "mesh.wirewarp_seams_from_uv_islands"
    bl_label = "Seams from UV Islands"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return context.mode == "EDIT_MESH"

    def execute(self, context: bpy.types.Context) -> set[str]:
        targets = list(context.objects_in_mode_unique_data)
        try:
            with in_object_mode(context):
                count = seams_from_uv(targets)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if count == 0:
            self.report({"INFO"}, "Every border of the UV islands is a seam or an outline already")
            return {"CANCELLED"}
        self.report({"INFO"}, f"{count} edge{'s' if count != 1 else ''} marked as seam")
        return {"FINISHED"}
