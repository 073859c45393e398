# SPDX-License-Identifier: GPL-3.0-or-later
import traceback
from functools import partial
from pathlib import Path

import bpy
from bpy.props import StringProperty

from .. import core, window_run
from ..flatten_job import FlattenChoices
from ..issues import Issue
from ..properties import LIBRARY_METHODS, FlattenSettings, take_settings
from ..read_models import is_current, read_models
from ..redraw import redraw_views
from ..report_file import run_message, run_report, write_json
from ..solve_models import CancelledError, Model, Outcome, Solver, failed_report, solve_models
from ..targets import in_object_mode, mesh_targets, nothing_to_flatten
from ..ui.settings import draw_settings
from ..undo_step import hold_whole_file
from ..unit_text import meters_per_blender_unit
from ..write_results import write_results

# What a user may do during a run: look around.
HARMLESS = {"MIDDLEMOUSE", "MOUSEMOVE", "INBETWEEN_MOUSEMOVE", "HOME", "NUMPAD_PERIOD"} | {
    f"NUMPAD_{digit}" for digit in range(10)
}
HARMLESS_KINDS = ("TIMER", "WHEEL", "TRACKPAD", "NDOF", "WINDOW")


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
        """In a window: solves in a thread, while modal() waits."""
        take_settings(self, context.scene.wirewarp)
        if bpy.app.background:
            return self.execute(context)
        sources = mesh_targets(context)
        if self._is_refused(context, sources):
            return {"CANCELLED"}
        with in_object_mode(context):
            self._models = read_models(context, sources, self.use_modifiers)
        what = sources[0].name if len(sources) == 1 else f"{len(sources)} objects"
        self._run = window_run.begin(context, what, self._solver(context, self._models))
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        if event.type == "ESC" and event.value == "PRESS":
            self._run.cancel()
        if event.type == "TIMER" and self._run.is_done():
            return self._finish_run(context)
        harmless = event.type in HARMLESS or event.type.startswith(HARMLESS_KINDS)
        return {"PASS_THROUGH" if harmless else "RUNNING_MODAL"}

    def cancel(self, _context: bpy.types.Context) -> None:
        """Blender ends the run: its window closes or another file is opened."""
        window_run.stop()

    def execute(self, context: bpy.types.Context) -> set[str]:
        """In a script and for Adjust Last Operation: all at once."""
        sources = mesh_targets(context)
        if self._is_refused(context, sources):
            return {"CANCELLED"}
        with in_object_mode(context):
            models = read_models(context, sources, self.use_modifiers)
            outcomes = self._solve_waiting(context, models)
            self._write(context, outcomes)
        return self._tell(context, outcomes)

    def _solve_waiting(self, context: bpy.types.Context, models: list[Model]) -> list[Outcome]:
        manager = context.window_manager

        def progress(_stage: str, fraction: float) -> bool:
            manager.progress_update(fraction)
            return True

        manager.progress_begin(0.0, 1.0)
        try:
            return self._solver(context, models)(progress)
        finally:
            manager.progress_end()

    def _finish_run(self, context: bpy.types.Context) -> set[str]:
        try:
            outcomes = self._run.result()
        except CancelledError:
            return self._give_up(context, "cancelled", "Flattening was cancelled: nothing was written.", "WARNING")
        except Exception as error:
            traceback.print_exc()
            sentence = f"Flattening failed, nothing was written: {error or type(error).__name__}. This is a fault of "
            sentence += "WireWarp: please report it with what Blender's console says."
            return self._give_up(context, "internal_error", sentence, "ERROR")
        with in_object_mode(context):
            changed = [m.facts["object"] for m in self._models if not is_current(context, m, self.use_modifiers)]
            if not changed:
                self._write(context, outcomes)
        if changed:
            names = ", ".join(f'"{name}"' for name in changed)
            sentence = f"{names} changed while it was flattened, nothing was written: flatten again."
            return self._give_up(context, "changed", sentence, "ERROR")
        return self._tell(context, outcomes)

    def _give_up(self, context: bpy.types.Context, code: str, sentence: str, level: str) -> set[str]:
        """Ends a run of which nothing is written but the report file."""
        redraw_views()
        self._write_report(context, [failed_report(model, Issue(code, sentence)) for model in self._models])
        self.report({level}, sentence)
        return {"CANCELLED"}

    def _write(self, context: bpy.types.Context, outcomes: list[Outcome]) -> None:
        write_results(context, outcomes, self)
        hold_whole_file()

    def _tell(self, context: bpy.types.Context, outcomes: list[Outcome]) -> set[str]:
        redraw_views()  # Blender does so by itself after a run that changed data, but not after one that failed
        reports = [outcome.report for outcome in outcomes]
        self._write_report(context, reports)
        level, text = run_message(reports)
        self.report({level}, text)
        return {"FINISHED" if any(outcome.pieces for outcome in outcomes) else "CANCELLED"}

    def _is_refused(self, context: bpy.types.Context, sources: list[bpy.types.Object]) -> bool:
        """Whether nothing can be done at all; says why."""
        path = self._report_file()
        refusal = core.problem() or nothing_to_flatten(context, sources)
        if window_run.is_running():
            refusal = "Flatten is at work: wait for its end, or press Esc."
        if not refusal and path and not path.parent.is_dir():
            refusal = f'The report cannot be written: there is no folder "{path.parent}".'
        if refusal:
            self.report({"ERROR"}, refusal)
        return bool(refusal)

    def _report_file(self) -> Path | None:
        return Path(bpy.path.abspath(self.report_path)) if self.report_path else None

    def _write_report(self, context: bpy.types.Context, reports: list[dict]) -> None:
        path = self._report_file()
        if path is None:
            return
        units = {
            "meters_per_blender_unit": meters_per_blender_unit(context.scene),
            "system": context.scene.unit_settings.system,
        }
        try:
            write_json(path, run_report(core.library().__version__, units, reports))
        except OSError as error:
            self.report({"ERROR"}, f"The report cannot be written: {error}.")

    def _solver(self, context: bpy.types.Context, models: list[Model]) -> Solver:
        choices = FlattenChoices(
            method=LIBRARY_METHODS[self.method],
            fairness=self.fairness,
            node_weight=self.node_weight.lower(),
            gap=self.gap / 100,
            mirror=self.mirror,
        )
        return partial(solve_models, core.library(), models, choices, meters_per_blender_unit(context.scene))

    def draw(self, _context: bpy.types.Context) -> None:
        draw_settings(self.layout, self)
