# SPDX-License-Identifier: GPL-3.0-or-later
import bpy

from ..issues import ObjectError
from ..report_store import last_report
from ..selection import check_indices, select_elements


class MESH_OT_wirewarp_select_issues(bpy.types.Operator):
    """Select, in Edit Mode, the vertices, edges and faces that the last flattening complained about"""

    bl_idname = "mesh.wirewarp_select_issues"
    bl_label = "Select Issues"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        return active is not None and active.type == "MESH" and context.mode in {"OBJECT", "EDIT_MESH"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        target = context.active_object.wirewarp_source or context.active_object
        report = last_report(target)
        if report is None:
            self.report({"ERROR"}, f'"{target.name}" has not been flattened yet.')
            return {"CANCELLED"}
        try:
            check_indices(target, report)
            if not self._select(context, target, report["issues"]):
                self.report({"INFO"}, "The last flattening found nothing wrong with single elements")
                return {"CANCELLED"}
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}

    def _select(self, context: bpy.types.Context, target: bpy.types.Object, issues: list[dict]) -> bool:
        names = ("vertices", "edges", "faces")
        elements = {name: [item for issue in issues for item in issue[name]] for name in names}
        if not any(elements.values()):
            return False
        select_elements(context, target, **elements)
        return True
