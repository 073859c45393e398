# SPDX-License-Identifier: GPL-3.0-or-later
"""The operator Flatten, and the steps that it shares with the automatic update: read, solve, write."""

import json
from pathlib import Path

import bpy
from bpy.props import BoolProperty, StringProperty

from ..blender.files import OPTIONS, check_room, given_file, unwritten
from ..blender.objects import meters_per_blender_unit
from ..blender.selection import WORKING_MODES, hold_whole_file
from ..blender.views import is_over_sidebar, redraw_views, show_objects, work_area
from ..core import Issue, library, pattern, run_to_dict
from ..export.read import read_outlines
from ..issues import ObjectError, object_error
from ..properties import preferences, take_settings
from ..solve.report import ObjectReport, run_message
from ..solve.steps import CanceledError, Steps
from ..state.owners import find_flat_object
from ..state.settings import FlattenSettings, choices_of
from ..ui import window_run
from ..ui.editing import reporting_refusals
from ..ui.settings import draw_settings
from ..ui.window_run import WindowSteps, fault_sentence
from .models import Model, Outcome, failed_report, solve_models
from .read import active_target, check_current, check_sources, find_source, in_suitable_mode, mesh_targets, read_models
from .write import write_results

# These events do not change the models, so Blender may handle them during a run.
HARMLESS = {"MIDDLEMOUSE", "MOUSEMOVE", "INBETWEEN_MOUSEMOVE", "HOME", "NUMPAD_PERIOD"} | {
    f"NUMPAD_{digit}" for digit in range(10)
}
HARMLESS_KINDS = ("TIMER", "WHEEL", "TRACKPAD", "NDOF", "WINDOW")


class FlattenSteps(WindowSteps, FlattenSettings):
    tries_uv_seams = True  # whether to try UV seams; the attempt takes as long as the rest of the run

    @property
    def report_file(self) -> Path | None:
        """Return the path of the JSON report; None if no report is to be written to a file."""
        return None

    def begin_run(self, context: bpy.types.Context, sources: list[bpy.types.Object]) -> set[str]:
        """Read the models, and start to solve them in steps, which modal() continues."""
        with in_suitable_mode(context, sources, self):
            self._models = read_models(context, sources, self)
        self._scene, self._view_layer = _place(context)
        what = sources[0].name if len(sources) == 1 else f"{len(sources)} objects"
        return self.begin(context, window_run.FLATTEN, what, self._solving(context, self._models))

    def lets_pass(self, event: bpy.types.Event) -> bool:
        """Return whether Blender may handle the event during the run. Other events could change the models."""
        if event.type == "LEFTMOUSE":
            return is_over_sidebar(event)  # the sidebar has the button Cancel
        return event.type in HARMLESS or event.type.startswith(HARMLESS_KINDS)

    def flatten_now(self, context: bpy.types.Context, sources: list[bpy.types.Object]) -> set[str]:
        """Read, solve and write while Blender waits."""
        with in_suitable_mode(context, sources, self):
            models = read_models(context, sources, self)
            outcomes = self.wait_for(context, self._solving(context, models))
            self._write(context, outcomes)
        return self._tell(context, outcomes)

    def message(self, level: str, text: str) -> None:
        """Show the result to the user. level: INFO, WARNING or ERROR."""
        self.report({level}, text)

    def _solving(self, context: bpy.types.Context, models: list[Model]) -> Steps[list[Outcome]]:
        meters = meters_per_blender_unit(context.scene)
        choices = choices_of(self, meters)
        return solve_models(models, choices, meters, tries_uv_seams=self.tries_uv_seams)

    def finish_run(self, context: bpy.types.Context) -> set[str]:
        try:
            outcomes = self._run.result()
        except CanceledError:
            return self.give_up(context, "cancelled", "Flatten was canceled. Nothing was written.", "WARNING")
        except Exception as error:
            sentence = fault_sentence(error, "Flatten failed and wrote nothing")
            return self.give_up(context, "internal_error", sentence, "ERROR")
        if context.mode not in WORKING_MODES or _place(context) != (self._scene, self._view_layer):
            sentence = "The mode or the scene changed during the run, so nothing was written. Flatten again."
            return self.give_up(context, "elsewhere", sentence, "ERROR")
        sources = [each for each in map(find_source, self._models) if each and each.type == "MESH"]
        try:
            with in_suitable_mode(context, sources, self):
                check_current(context, self._models, self)
                self._write(context, outcomes)
        except ObjectError as error:
            return self.give_up(context, error.issue.code, str(error), "ERROR")
        except Exception as error:  # for example if memory is full; the undo step removes the partial result
            sentence = fault_sentence(error, "Flatten failed. Press Ctrl+Z to undo the partial result")
            self.give_up(context, "internal_error", sentence, "ERROR")
            hold_whole_file()
            return {"FINISHED"}
        self.show(context, outcomes)
        return self._tell(context, outcomes, "WARNING")  # an error would open a popup over the button and the verdict

    def show(self, context: bpy.types.Context, outcomes: list[Outcome]) -> None:
        sources = [find_source(outcome.model) for outcome in outcomes if outcome.is_elsewhere]
        area = work_area(context)
        # In Edit Mode, the view does not move, because the user is selecting edges in it.
        if sources and area and preferences(context).moves_view and context.mode == "OBJECT":
            show_objects(context, area, [each for source in sources for each in (source, find_flat_object(source))])

    def give_up(self, context: bpy.types.Context, code: str, sentence: str, level: str) -> set[str]:
        """End a run that has no result. Only the report file is written."""
        redraw_views()
        self._write_report(context, [failed_report(model, Issue(code, sentence)) for model in self._models])
        self.message(level, sentence)
        return {"CANCELLED"}

    def _write(self, context: bpy.types.Context, outcomes: list[Outcome]) -> None:
        write_results(context, outcomes, self)
        hold_whole_file()

    def _tell(self, context: bpy.types.Context, outcomes: list[Outcome], failed: str = "ERROR") -> set[str]:
        """Report the results to the user and in the report file. failed: level of the message if pieces failed."""
        redraw_views()  # Blender redraws on its own only if the run changed data
        reports = [outcome.report for outcome in outcomes]
        self._write_report(context, reports)
        are_ok = all(report.ok for report in reports)
        narrow = {each.report.object: _narrow_pieces(context, each) for each in outcomes} if are_ok else {}
        level, text = run_message(reports, narrow)
        self.message(failed if level == "ERROR" else level, text)
        return {"FINISHED" if any(outcome.pieces for outcome in outcomes) else "CANCELLED"}

    def _write_report(self, context: bpy.types.Context, reports: list[ObjectReport]) -> None:
        if self.report_file is None:
            return
        units = {
            "meters_per_blender_unit": meters_per_blender_unit(context.scene),
            "system": context.scene.unit_settings.system,
        }
        try:
            report = run_to_dict(library().__version__, units, reports)
            with pattern.files.replaced_file(self.report_file) as unfinished:
                unfinished.write_text(json.dumps(report, indent=1, allow_nan=False) + "\n", encoding="utf-8")
        except OSError as error:
            self.report({"ERROR"}, unwritten(self.report_file, error))


def _narrow_pieces(context: bpy.types.Context, outcome: Outcome) -> list[str]:
    """Return the names of the pieces without room for their allowances; none if the pieces are in Edit Mode."""
    source = find_source(outcome.model)
    flat = find_flat_object(source) if source and outcome.pieces else None
    if flat is None or flat.data.is_editmode:
        return []
    parts = read_outlines(context.scene, source, flat, context.evaluated_depsgraph_get())
    return parts.narrow(context.scene.wirewarp.allowance) if parts else []


def _place(context: bpy.types.Context) -> tuple[str, str]:
    """Return the names of the scene and the view layer for the results. Names are used, because undo may replace the
    scene."""
    return context.scene.name_full, context.view_layer.name


class OBJECT_OT_wirewarp_flatten(FlattenSteps, bpy.types.Operator):
    """Flatten every selected mesh into pieces that keep the length of each seam, outline and rigid wire"""

    bl_idname = "object.wirewarp_flatten"
    bl_label = "Flatten"
    bl_options = {"REGISTER", "UNDO"}

    report_path: StringProperty(
        name="Report File",
        description="JSON file for the whole report, with lengths in meters and in Blender units",
        subtype="FILE_PATH",
        options=OPTIONS,
    )
    only_active: BoolProperty(
        name="Only Active",
        description="Flatten only the active model, even if other objects are selected",
        options={"HIDDEN", "SKIP_SAVE"},
    )

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        if properties.only_active:  # set by the button Lay Out Again
            return "Flatten this model again, and lay out all its pieces again, including pieces that you moved"
        return cls.__doc__

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        if context.mode in WORKING_MODES:
            return True
        cls.poll_message_set("Flatten works in Object Mode and in Edit Mode")
        return False

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        take_settings(self, context.scene.wirewarp)
        return self.execute(context) if bpy.app.background else self._begin(context)

    @reporting_refusals
    def _begin(self, context: bpy.types.Context) -> set[str]:
        return self.begin_run(context, self._sources(context))

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        """Flatten without a modal run, for scripts and Adjust Last Operation."""
        return self.flatten_now(context, self._sources(context))

    def _sources(self, context: bpy.types.Context) -> list[bpy.types.Object]:
        """Return the models to flatten. Raises ObjectError if the run cannot start."""
        sources = active_target(context) if self.only_active else mesh_targets(context)
        check_sources(context, sources)
        try:
            if self.report_path:
                check_room(self.report_file)
        except OSError as error:
            raise object_error("file", unwritten(self.report_path, error)) from error
        return sources

    @property
    def report_file(self) -> Path | None:
        return given_file(self.report_path) if self.report_path else None

    def draw(self, _context: bpy.types.Context) -> None:
        draw_settings(self.layout, self)


class OBJECT_OT_wirewarp_cancel(bpy.types.Operator):
    """Cancel this run, but keep suggestions that a search has found so far"""

    bl_idname = "object.wirewarp_cancel"
    bl_label = "Cancel"
    bl_options = {"INTERNAL"}

    @classmethod
    def poll(cls, _context: bpy.types.Context) -> bool:
        return window_run.is_running()

    def execute(self, _context: bpy.types.Context) -> set[str]:
        window_run.cancel()
        return {"FINISHED"}
