# SPDX-License-Identifier: GPL-3.0-or-later
import bpy

from ..issues import ObjectError
from ..seams_from_uv import seams_from_uv
from ..targets import in_object_mode
from ..words import counted, quoted


class MESH_OT_wirewarp_seams_from_uv_islands(bpy.types.Operator):
    """Mark seams where the islands of the active UV map end; of your own map where that of the flat pieces is active"""

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
                count, maps = seams_from_uv(targets)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        named = f"{'UV map' if len(maps) == 1 else 'UV maps'} {quoted(maps)}"
        if count == 0:
            self.report({"INFO"}, f"Every border of the islands of the {named} is a seam or an outline already")
            return {"CANCELLED"}
        self.report({"INFO"}, f"{counted(count, 'edge')} marked as seam by the {named}")
        return {"FINISHED"}
