# SPDX-License-Identifier: GPL-3.0-or-later
"""The button Flatten."""

from pathlib import Path

import bpy
from bpy.props import BoolProperty, StringProperty

from ..blender.files import OPTIONS, check_room, given_file, unwritten
from ..blender.modes import WORKING_MODES
from ..properties import take_settings
from ..ui import window_run
from ..ui.settings import draw_settings
from .steps import FlattenSteps
from .targets import active_target, mesh_targets, nothing_to_flatten


class OBJECT_OT_wirewarp_flatten(FlattenSteps, bpy.types.Operator):
    """Flatten every selected mesh into pieces that keep the length of each seam, outline and rigid wire"""

    bl_idname = "object.wirewarp_flatten"
    bl_label = "Flatten"
    bl_options = {"REGISTER", "UNDO"}

    report_path: StringProperty(
        name="Report File",
        description="Write the whole report to this JSON file, lengths in meters and in Blender units",
        subtype="FILE_PATH",
        options=OPTIONS,
    )
    only_active: BoolProperty(
        name="Only Active",
        description="Flatten the active model alone, whatever else is selected",
        default=False,
        options={"HIDDEN", "SKIP_SAVE"},
    )

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        if properties.only_active:  # the button Lay Out Again
            return "Flatten this model again and lay out all its pieces again, wherever they were moved"
        return cls.__doc__

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        if context.mode in WORKING_MODES:
            return True
        cls.poll_message_set("Flatten works in Object Mode and in Edit Mode")
        return False

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        take_settings(self, context.scene.wirewarp)
        if bpy.app.background:
            return self.execute(context)
        sources = self._sources(context)
        return {"CANCELLED"} if self._is_refused(context, sources) else self.begin_run(context, sources)

    def execute(self, context: bpy.types.Context) -> set[str]:
        """In a script and for Adjust Last Operation."""
        sources = self._sources(context)
        return {"CANCELLED"} if self._is_refused(context, sources) else self.flatten_now(context, sources)

    def _sources(self, context: bpy.types.Context) -> list[bpy.types.Object]:
        return active_target(context) if self.only_active else mesh_targets(context)

    @property
    def report_file(self) -> Path | None:
        return given_file(self.report_path) if self.report_path else None

    def _is_refused(self, context: bpy.types.Context, sources: list[bpy.types.Object]) -> bool:
        """Whether nothing can be done at all; says why."""
        refusal = window_run.busy_sentence() or nothing_to_flatten(context, sources)
        if not refusal and self.report_path:
            refusal = self._file_refusal()
        if refusal:
            self.report({"ERROR"}, refusal)
        return bool(refusal)

    def _file_refusal(self) -> str:
        try:
            check_room(self.report_file)
        except OSError as error:
            return unwritten(self.report_path, error)
        return ""

    def draw(self, _context: bpy.types.Context) -> None:
        draw_settings(self.layout, self)


class OBJECT_OT_wirewarp_cancel(bpy.types.Operator):
    """Stop and write nothing"""

    bl_idname = "object.wirewarp_cancel"
    bl_label = "Cancel"
    bl_options = {"INTERNAL"}

    @classmethod
    def poll(cls, _context: bpy.types.Context) -> bool:
        return window_run.is_running()

    def execute(self, _context: bpy.types.Context) -> set[str]:
        window_run.cancel()
        return {"FINISHED"}


CLASSES = (OBJECT_OT_wirewarp_flatten, OBJECT_OT_wirewarp_cancel)
