# SPDX-License-Identifier: GPL-3.0-or-later
import bpy
from bpy.props import EnumProperty, IntProperty

from ..issues import ObjectError, object_error
from ..model_state import has_moved
from ..redraw import redraw_views
from ..report_store import last_report
from ..selection import check_indices
from ..take_proposals import loosen_wires, mark_seams
from ..targets import in_object_mode


class MESH_OT_wirewarp_take_proposal(bpy.types.Operator):
    """Mend the model as the report proposes"""

    bl_idname = "mesh.wirewarp_take_proposal"
    bl_label = "Take Proposal"
    bl_options = {"REGISTER", "UNDO"}

    what: EnumProperty(
        name="What",
        description="What to take from the report",
        items=[
            ("SEAMS", "Mark as Seam", "Mark the proposed edges as seams on the model. Then flatten again"),
            ("TOLERANCES", "Loosen Wires", "Give the named wires the proposed tolerances. Then flatten again"),
        ],
        options={"HIDDEN"},
    )
    issue: IntProperty(name="Issue", description="Its place in the report, from 0", min=0, options={"HIDDEN"})

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        return cls.bl_rna.properties["what"].enum_items[properties.what].description

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        return active is not None and active.type == "MESH" and context.mode in {"OBJECT", "EDIT_MESH"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        target = context.active_object.wirewarp_source or context.active_object
        if context.mode == "EDIT_MESH" and target.mode != "EDIT":
            bpy.ops.object.mode_set(mode="OBJECT")  # in Edit Mode, undo would bring back the edited meshes only
        try:
            with in_object_mode(context):
                count = self._take(target)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        redraw_views()
        if count == 0:
            self.report({"INFO"}, "Done already: flatten again")
            return {"CANCELLED"}
        edges = "1 edge" if count == 1 else f"{count} edges"
        done = "marked as seam" if self.what == "SEAMS" else "made more elastic"
        self.report({"INFO"}, f"{edges} {done}: flatten again")
        return {"FINISHED"}

    def _take(self, target: bpy.types.Object) -> int:
        """Returns the number of edges that were changed. Raises ObjectError."""
        report = last_report(target)
        issues = report["issues"] if report else []
        key = "proposed_seams" if self.what == "SEAMS" else "proposed_tolerances"
        proposed = issues[self.issue].get(key) if self.issue < len(issues) else None
        if not proposed:
            raise object_error("not_in_report", f'The report of "{target.name}" proposes no such thing.')
        check_indices(target, report)
        if has_moved(target, report):
            raise object_error("changed", f'"{target.name}" has changed since it was flattened: flatten it again.')
        return (mark_seams if self.what == "SEAMS" else loosen_wires)(target.data, proposed)
