# SPDX-License-Identifier: GPL-3.0-or-later
import bpy
from bpy.props import EnumProperty, IntProperty

from ..issues import changed_error, object_error
from ..model_state import has_moved
from ..redraw import redraw_views
from ..selection import check_indices
from ..take_proposals import loosen_wires, mark_seams
from ..targets import check_not_edited, in_object_mode
from ..words import counted
from .report_operator import ReportOperator


class MESH_OT_wirewarp_take_proposal(ReportOperator, bpy.types.Operator):
    """Mend the model as the report proposes"""

    bl_idname = "mesh.wirewarp_take_proposal"
    bl_label = "Take Proposal"

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

    def act(self, context: bpy.types.Context, source: bpy.types.Object, report: dict) -> set[str]:
        edits_others = context.mode == "EDIT_MESH" and source.mode != "EDIT"
        with in_object_mode(context):
            count = self._take(source, report)
        if count == 0:
            self.report({"INFO"}, "Done already: flatten again")
            return {"CANCELLED"}
        if edits_others:
            bpy.ops.object.mode_set(mode="OBJECT")  # in Edit Mode, undo would bring back the edited meshes only
        redraw_views()
        done = "marked as seam" if self.what == "SEAMS" else "made more elastic"
        self.report({"INFO"}, f"{counted(count, 'edge')} {done}: flatten again")
        return {"FINISHED"}

    def _take(self, source: bpy.types.Object, report: dict) -> int:
        """Returns the number of edges that were changed. Raises ObjectError."""
        key = "proposed_seams" if self.what == "SEAMS" else "proposed_tolerances"
        issues = report["issues"]
        proposed = issues[self.issue][key] if self.issue < len(issues) else None
        if not proposed:
            proposal = "seam" if self.what == "SEAMS" else "tolerance"
            sentence = f'The report of "{source.name}" proposes no {proposal} here: flatten again to see what helps.'
            raise object_error("not_in_report", sentence)
        check_not_edited(source)
        check_indices(source, report)
        if has_moved(source, report):
            raise changed_error(source.name)
        return (mark_seams if self.what == "SEAMS" else loosen_wires)(source.data, proposed)
