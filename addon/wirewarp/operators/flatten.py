# SPDX-License-Identifier: GPL-3.0-or-later
from pathlib import Path

import bpy
from bpy.props import StringProperty

from .. import core
from ..flatten_job import FlattenChoices
from ..flatten_objects import compute, write
from ..properties import LIBRARY_METHODS, FlattenSettings, take_settings
from ..redraw import redraw_views
from ..report_file import failure_text, run_report, strained_text, success_text, write_json
from ..targets import in_object_mode, mesh_targets
from ..ui.settings import draw_settings
from ..unit_text import meters_per_blender_unit


class OBJECT_OT_wirewarp_flatten(FlattenSettings, bpy.types.Operator):
    """Flatten every selected mesh into pieces that keep the length of each seam, outline and rigid wire"""

    bl_idname = "object.wirewarp_flatten"
    bl_label = "Flatten"
    bl_options = {"REGISTER", "UNDO"}

    report_path: StringProperty(
        name="Report File",
        description="Write the whole report to this JSON file, lengths in metres and in Blender units",
        subtype="FILE_PATH",
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        if context.mode in {"OBJECT", "EDIT_MESH"}:
            return True
        cls.poll_message_set("Flatten works in Object Mode and in Edit Mode")
        return False

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        take_settings(self, context.scene.wirewarp)
        return self.execute(context)

    def execute(self, context: bpy.types.Context) -> set[str]:
        report_file = Path(bpy.path.abspath(self.report_path)) if self.report_path else None
        sources = mesh_targets(context)
        refusal = core.problem() or self._refusal(context, sources, report_file)
        if refusal:
            self.report({"ERROR"}, refusal)
            return {"CANCELLED"}
        with in_object_mode(context):
            outcomes = self._compute(context, sources)
            anything = any(outcome.has_layout for outcome in outcomes)
            write(context, outcomes, self)
        redraw_views()  # Blender does so by itself after a run that changed data, but not after one that failed
        reports = [outcome.report for outcome in outcomes]
        if report_file:
            self._write_report(context, report_file, reports)
        if all(report["ok"] for report in reports):
            notes = [note for report in reports for note in report["notes"]]
            strained = strained_text(reports)
            text = "\n".join([strained or success_text(reports), *notes])
            self.report({"WARNING" if strained or notes else "INFO"}, text)
        else:
            self.report({"ERROR"}, failure_text(reports))
        return {"FINISHED"} if anything else {"CANCELLED"}

    def _refusal(self, context: bpy.types.Context, sources: list[bpy.types.Object], report_file: Path | None) -> str:
        """Why nothing can be done at all, as a sentence."""
        if not sources:
            active = context.view_layer.objects.active
            if active and active.type == "MESH" and not active.visible_get():
                return f'Nothing to flatten: "{active.name}" is hidden. Show it in the Outliner and select it.'
            if any(target.wirewarp_source for target in context.selected_objects):
                return "Nothing to flatten: flat pieces are not flattened again. Select the model."
            return "Nothing to flatten: select a mesh object."
        if report_file and not report_file.parent.is_dir():
            return f'The report cannot be written: there is no folder "{report_file.parent}".'
        return ""

    def _write_report(self, context: bpy.types.Context, path: Path, reports: list[dict]) -> None:
        units = {
            "meters_per_blender_unit": meters_per_blender_unit(context.scene),
            "system": context.scene.unit_settings.system,
        }
        try:
            write_json(path, run_report(core.library().__version__, units, reports))
        except OSError as error:
            self.report({"ERROR"}, f"The report cannot be written: {error}.")

    def _compute(self, context: bpy.types.Context, sources: list[bpy.types.Object]) -> list:
        choices = FlattenChoices(
            method=LIBRARY_METHODS[self.method],
            fairness=self.fairness,
            node_weight=self.node_weight.lower(),
            gap=self.gap / 100,
            mirror=self.mirror,
        )
        manager = context.window_manager
        manager.progress_begin(0.0, 1.0)
        try:
            return compute(context, core.library(), sources, choices, self.use_modifiers, manager.progress_update)
        finally:
            manager.progress_end()

    def draw(self, _context: bpy.types.Context) -> None:
        draw_settings(self.layout, self)
