# SPDX-License-Identifier: GPL-3.0-or-later
import bpy

from ..selection import check_indices, select_elements
from .report_operator import ReportOperator


class MESH_OT_wirewarp_select_issues(ReportOperator, bpy.types.Operator):
    """Select, in Edit Mode, the vertices, edges and faces that the last flattening complained about"""

    bl_idname = "mesh.wirewarp_select_issues"
    bl_label = "Select Problems"

    def act(self, context: bpy.types.Context, source: bpy.types.Object, report: dict) -> set[str]:
        check_indices(source, report)
        names = ("vertices", "edges", "faces")
        elements = {name: [item for issue in report["issues"] for item in issue[name]] for name in names}
        if not any(elements.values()):
            self.report({"INFO"}, "The last flattening found nothing wrong with single elements")
            return {"CANCELLED"}
        select_elements(context, source, **elements)
        return {"FINISHED"}
