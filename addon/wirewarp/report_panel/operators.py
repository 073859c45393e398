# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that select elements of the report, apply its suggestions, copy it, and show the pieces in the view."""

import bpy
from bpy.props import EnumProperty, IntProperty

from ..blender.mesh import current_mesh, element_counts
from ..blender.objects import check_local, length_text
from ..blender.selection import WORKING_MODES, in_object_mode, select_elements
from ..blender.views import redraw_views, show_objects
from ..core import Elements, counted, elements_of, report_csv
from ..issues import changed_error, object_error
from ..marks.ease import loosen_wires, mark_seams
from ..solve.report import ObjectReport
from ..state.changes import has_changed, has_moved
from ..state.flat_pieces import on_flat, pieces_of_report
from ..state.owners import check_not_edited, find_flat_object, model_or_self
from ..state.reports import last_report, pieces_report
from ..ui.editing import OnMesh, reporting_refusals

PROPOSALS = [
    ("SEAMS", "Mark as Seam", "Mark the suggested edges as seams on the model"),
    ("TOLERANCES", "Loosen Wires", "Set the suggested tolerances of the named wires"),
]


def check_indices(target: bpy.types.Object, report: ObjectReport) -> None:
    """Raises ObjectError if the report's indices no longer refer to the object's own mesh."""
    check_local(target, target.data)
    if report.with_modifiers:
        raise object_error(
            "with_modifiers",
            "This report is about the mesh with its modifiers. To mark the model itself, flatten without Modifiers.",
        )
    with current_mesh(target) as mesh:
        counts = element_counts(mesh)
    if report.counts not in (None, counts):
        raise changed_error(target.name)


def check_flattened(source: bpy.types.Object, report: ObjectReport | None) -> ObjectReport:
    if report is None:
        raise object_error("not_flattened", f'"{source.name}" has not been flattened yet. Press Flatten first.')
    return report


class ReportOperator(OnMesh):
    """Mixin of operators that use a report of the active model, or of the model of active flat pieces."""

    bl_options = {"REGISTER", "UNDO"}
    modes = WORKING_MODES

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        """Return the description of the chosen item; "" without a choice, so that Blender shows the docstring."""
        what = properties.rna_type.properties.get("what")
        return what.enum_items[properties.what].description if what else ""

    def report_of(self, source: bpy.types.Object) -> ObjectReport | None:
        return last_report(source)

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        source = model_or_self(context.active_object)
        return self.act(context, source, check_flattened(source, self.report_of(source)))


class OBJECT_OT_wirewarp_copy_report(ReportOperator, bpy.types.Operator):
    """Copy all lengths and areas of the report to the clipboard, as a table in the scene's units for spreadsheets"""

    bl_idname = "object.wirewarp_copy_report"
    bl_label = "Copy as CSV"
    bl_options = {"REGISTER"}

    def report_of(self, source: bpy.types.Object) -> ObjectReport | None:
        """Return the report of the flat pieces if there are any, otherwise the report that the panel shows."""
        return pieces_report(source) or last_report(source)

    def act(self, context: bpy.types.Context, source: bpy.types.Object, report: ObjectReport) -> set[str]:
        table = report_csv(report, length_text(context.scene))
        context.window_manager.clipboard = table
        lines = table.count("\n") - 1
        if has_changed(source, report.model_state):
            self.report({"WARNING"}, f'{lines} lines copied. "{source.name}" has changed since it was flattened')
        else:
            self.report({"INFO"}, f"{lines} lines copied")
        return {"FINISHED"}


class MESH_OT_wirewarp_select_issues(ReportOperator, bpy.types.Operator):
    """Select the vertices, edges and faces of the last run's problems in Edit Mode"""

    bl_idname = "mesh.wirewarp_select_issues"
    bl_label = "Select Problems"

    def act(self, context: bpy.types.Context, source: bpy.types.Object, report: ObjectReport) -> set[str]:
        check_indices(source, report)
        if not any(issue.has_place for issue in report.issues):
            self.report({"INFO"}, "The problems of the last run have no vertices, edges or faces")
            return {"CANCELLED"}
        elements = Elements(
            [vertex for issue in report.issues for vertex in issue.vertices],
            [edge for issue in report.issues for edge in issue.edges],
            [face for issue in report.issues for face in issue.faces],
        )
        select_elements(context, source, elements)
        return {"FINISHED"}


class MESH_OT_wirewarp_select_result(ReportOperator, bpy.types.Operator):
    """Select this part of the report in Edit Mode and show it"""

    bl_idname = "mesh.wirewarp_select_result"
    bl_label = "Select in Report"

    what: EnumProperty(
        name="What",
        description="What to select",
        items=[
            ("SEAM", "Seam", "Select and show the seam: on the model, or all sides on flat pieces if these are active"),
            ("WIRE", "Wire", "Select and show the wire: on the model, or on the flat pieces if these are active"),
            ("OUTLINE", "Open Edge", "Select and show the outline section: on the model, or on active flat pieces"),
            ("PIECE", "Piece", "Select and show the piece: on the model, or on the flat pieces if these are active"),
            ("STRETCH", "Largest Stretch", "Select and show the place in this piece that must stretch most"),
            ("EASE", "Largest Compression", "Select and show the place in this piece that is compressed most"),
            ("ISSUE", "Issue", "Select and show the elements that the sentence is about"),
            ("HINT", "Hint", "Select and show the place: on the model, or on the flat pieces if these are active"),
        ],
        options={"HIDDEN"},
    )
    index: IntProperty(name="Index", description="Index in the report, from 0", min=0, options={"HIDDEN"})

    def report_of(self, source: bpy.types.Object) -> ObjectReport | None:
        """Return the report of the flat pieces for items of the list of pieces, otherwise the report that the panel
        shows."""
        return (pieces_report if self.what in {"PIECE", "STRETCH", "EASE"} else last_report)(source)

    def act(self, context: bpy.types.Context, source: bpy.types.Object, report: ObjectReport) -> set[str]:
        elements = elements_of(report, self.what, self.index)
        if elements is None:
            raise object_error("not_in_report", "The report no longer has this entry. Flatten again.")
        # If modifiers made the elements, only the flat pieces have them.
        wants_flat = context.active_object != source or report.with_modifiers
        if wants_flat and self._lies_flat(report, elements):
            with in_object_mode(context):
                flat, pieces = pieces_of_report(source, report)
            select_elements(context, flat, on_flat(elements, pieces))
            return {"FINISHED"}
        check_indices(source, report)
        if elements.whole_piece:
            with in_object_mode(context):
                _, pieces = pieces_of_report(source, report)
            elements = Elements(faces=pieces.source_face[pieces.face_piece == elements.piece])
        select_elements(context, source, elements)
        return {"FINISHED"}

    def _lies_flat(self, report: ObjectReport, elements: Elements) -> bool:
        """Return whether the elements are on a flat piece. Failed pieces and models may have no flat shape."""
        if self.what != "ISSUE":
            return True
        return elements.piece is not None and report.pieces[elements.piece].has_layout


def take_proposals(source: bpy.types.Object, report: ObjectReport, what: str, issues: slice = slice(None)) -> int:
    """Apply suggestions of these issues to a model in Object Mode. Return the number of changed edges.

    what: SEAMS or TOLERANCES
    Raises ObjectError if there is no such suggestion, or if the model has changed.
    """
    chosen = report.issues[issues]
    seams = [edge for issue in chosen for edge in issue.proposed_seams] if what == "SEAMS" else []
    wires = [wire for issue in chosen for wire in issue.proposed_tolerances] if what == "TOLERANCES" else []
    if not (seams or wires):
        proposal = "seam" if what == "SEAMS" else "tolerance"
        sentence = f'The report of "{source.name}" does not suggest a {proposal} here. Flatten again for suggestions.'
        raise object_error("not_in_report", sentence)
    check_not_edited(source)
    check_indices(source, report)
    if has_moved(source, report.model_state):
        raise changed_error(source.name)
    return mark_seams(source.data, seams) if seams else loosen_wires(source.data, wires)


class MESH_OT_wirewarp_take_proposal(ReportOperator, bpy.types.Operator):
    """Fix the model as the report suggests"""

    bl_idname = "mesh.wirewarp_take_proposal"
    bl_label = "Use Suggestion"

    what: EnumProperty(name="What", description="What to use from the report", items=PROPOSALS, options={"HIDDEN"})
    issue: IntProperty(name="Issue", description="Index in the report, from 0", min=0, options={"HIDDEN"})

    def act(self, context: bpy.types.Context, source: bpy.types.Object, report: ObjectReport) -> set[str]:
        edits_others = context.mode == "EDIT_MESH" and source.mode != "EDIT"
        with in_object_mode(context):
            count = take_proposals(source, report, self.what, slice(self.issue, self.issue + 1))
        if count == 0:
            self.report({"INFO"}, "Already done. Flatten again")
            return {"CANCELLED"}
        if edits_others:
            bpy.ops.object.mode_set(mode="OBJECT")  # in Edit Mode, undo would restore only the edited meshes
        redraw_views()
        done = "marked as seam" if self.what == "SEAMS" else "loosened"
        self.report({"INFO"}, f"{counted(count, 'edge')} {done}: flatten again")
        return {"FINISHED"}


class VIEW3D_OT_wirewarp_frame(bpy.types.Operator):
    """Move the view so that the model and its flat pieces are visible"""

    bl_idname = "view3d.wirewarp_frame"
    bl_label = "Show Model and Pieces"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return context.area is not None and context.area.type == "VIEW_3D" and bool(_objects(context))

    def execute(self, context: bpy.types.Context) -> set[str]:
        show_objects(context, context.area, _objects(context))
        return {"FINISHED"}


def _objects(context: bpy.types.Context) -> list[bpy.types.Object]:
    active = context.active_object
    if active is None or active.type != "MESH":
        return []
    source = model_or_self(active)
    return [each for each in (source, find_flat_object(source)) if each is not None]
