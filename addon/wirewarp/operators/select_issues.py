# SPDX-License-Identifier: GPL-3.0-or-later
import bpy

from ..issues import ObjectError
from ..mesh_to_arrays import element_counts
from ..report_store import last_report
from ..selection import select_elements


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
        refusal = self._refusal(target, report)
        if refusal:
            self.report({"ERROR"}, refusal)
            return {"CANCELLED"}
        elements = {
            name: [item for issue in report["issues"] for item in issue[name]]
            for name in ("vertices", "edges", "faces")
        }
        if not any(elements.values()):
            self.report({"INFO"}, "The last flattening found nothing wrong with single elements")
            return {"CANCELLED"}
        try:
            select_elements(context, target, **elements)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}

    def _refusal(self, target: bpy.types.Object, report: dict | None) -> str:
        if report is None:
            return f'"{target.name}" has not been flattened yet.'
        if target.library is not None or target.data.library is not None:
            return f'"{target.name}" is linked from another file and has no Edit Mode here: make it local.'
        if report.get("with_modifiers") and report["issues"]:
            return "The issues lie on the mesh with modifiers: apply the modifiers, flatten again and select."
        if target.mode == "EDIT":
            target.update_from_editmode()
        if "counts" in report and report["counts"] != element_counts(target.data):
            return f'"{target.name}" has changed since it was flattened: flatten it again.'
        return ""
