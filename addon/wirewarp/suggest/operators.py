# SPDX-License-Identifier: GPL-3.0-or-later
"""Suggest Darts and Suggest Seams: where to cut a piece, each with what it gains. Taken by report_panel/mend.py."""

import bpy
from bpy.props import IntProperty

from ..blender.modes import WORKING_MODES, in_object_mode
from ..blender.units import length_text
from ..blender.views import redraw_views
from ..flatten.targets import active_target, nothing_to_flatten
from ..issues import ObjectError
from ..properties import mend_settings
from ..solve.steps import CanceledError
from ..solve.suggest import Cut
from ..solve.suggestion_words import cut_text, found_words, shortfall, step_text
from ..state.owners import model_or_self
from ..state.suggestions import choose, drop
from ..ui import window_run
from ..ui.window_steps import WindowSteps, fault_sentence
from ..words import paragraph, quoted
from .search import Search, begin_search, keep_found


class SuggestCuts(WindowSteps):
    """Mixed into operators. Nothing is written: what is found is in the panel, until the model changes."""

    bl_options = {"REGISTER"}
    kind = ""  # DARTS or SEAMS

    piece: IntProperty(
        name="Piece",
        description="Which piece to cut, by its place in the report from 0; -1 for any, whichever gains most",
        default=-1,
        min=-1,
        options={"HIDDEN", "SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        if _is_mesh(context.active_object) and context.mode in WORKING_MODES:
            return True
        cls.poll_message_set("Select a mesh, in Object Mode or in Edit Mode")
        return False

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        if bpy.app.background:
            return self.execute(context)
        if not self._read(context):
            return {"CANCELLED"}
        return self.begin(context, window_run.SUGGEST, self._search.model.facts.object, self._search.steps)

    def execute(self, context: bpy.types.Context) -> set[str]:
        """In a script; Blender waits."""
        if not self._read(context):
            return {"CANCELLED"}
        try:
            return self._keep(context, self.wait_for(context, self._search.steps))
        except ObjectError as error:
            return self._refuse(context, error)

    def lets_pass(self, event: bpy.types.Event) -> bool:
        """All but what stops it: everything it needs has been read, and what changes meanwhile is noticed."""
        return event.type != "ESC"

    def finish_run(self, context: bpy.types.Context) -> set[str]:
        try:
            return self._keep(context, self._run.result())
        except CanceledError:
            self.report({"WARNING"}, "The search was canceled.")
            return {"CANCELLED"}
        except ObjectError as error:
            return self._refuse(context, error)
        except Exception as error:
            self.report({"ERROR"}, fault_sentence(error, "The search failed, nothing is suggested"))
            return {"CANCELLED"}

    def _read(self, context: bpy.types.Context) -> bool:
        """Whether there is something to search; says why not."""
        refusal = window_run.busy_sentence() or nothing_to_flatten(context, active_target(context))
        if refusal:
            self.report({"ERROR"}, refusal)
            return False
        source = model_or_self(context.active_object)
        mend_settings(context.scene.wirewarp)
        try:
            with in_object_mode(context):
                piece = None if self.piece == -1 else self.piece
                self._search: Search = begin_search(context, source, self.kind, piece)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return False
        return True

    def _keep(self, context: bpy.types.Context, cuts: list[Cut]) -> set[str]:
        """In any mode: leaving Edit Mode under a tool that is still going on crashes Blender. Raises ObjectError."""
        found = keep_found(self._search, cuts)
        redraw_views()
        lengths, name = length_text(context.scene), found.names[0]
        is_named = cuts[0].piece in self._search.names or self._search.is_of_model
        piece = quoted([name]) if is_named else name
        if found.target:
            step = step_text(self.kind, cuts[-1], lengths)
            said = [f"Stretch of {piece} with {step}", shortfall(self.kind, cuts, found.target)]
        elif cuts[0].is_first:
            said = [f"{found_words(self.kind, cuts)} suggested", f"The first: {cut_text(cuts[0], lengths)}"]
        else:
            said = [f"{found_words(self.kind, cuts)} suggested; for {piece}: {cut_text(cuts[0], lengths)}"]
        self.report({"INFO"}, paragraph(each for each in said if each))
        return {"FINISHED"}

    def _refuse(self, context: bpy.types.Context, error: ObjectError) -> set[str]:
        self.report({"ERROR"}, str(error))
        return {"CANCELLED"}


class OBJECT_OT_wirewarp_suggest_darts(SuggestCuts, bpy.types.Operator):
    """Find the darts that lower the stretch of this piece most"""

    bl_idname = "object.wirewarp_suggest_darts"
    bl_label = "Suggest Darts"
    kind = "DARTS"


class OBJECT_OT_wirewarp_suggest_seams(SuggestCuts, bpy.types.Operator):
    """Find the seams that lower the stretch of this piece most, or the first ones of a closed model"""

    bl_idname = "object.wirewarp_suggest_seams"
    bl_label = "Suggest Seams"
    kind = "SEAMS"


class OBJECT_OT_wirewarp_choose_suggestion(bpy.types.Operator):
    """Show this cut on the model and on its flat pieces"""

    bl_idname = "object.wirewarp_choose_suggestion"
    bl_label = "Show Suggestion"
    bl_options = {"INTERNAL"}

    index: IntProperty(name="Index", description="Its place in the list, from 0", min=0)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return _is_mesh(context.active_object)

    def execute(self, context: bpy.types.Context) -> set[str]:
        choose(model_or_self(context.active_object), self.index)
        redraw_views()
        return {"FINISHED"}


class OBJECT_OT_wirewarp_drop_suggestions(bpy.types.Operator):
    """Discard these suggestions"""

    bl_idname = "object.wirewarp_drop_suggestions"
    bl_label = "Discard Suggestions"
    bl_options = {"INTERNAL"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return _is_mesh(context.active_object)

    def execute(self, context: bpy.types.Context) -> set[str]:
        drop(model_or_self(context.active_object))
        redraw_views()
        return {"FINISHED"}


def _is_mesh(active: bpy.types.Object | None) -> bool:
    return active is not None and active.type == "MESH"


CLASSES = (
    OBJECT_OT_wirewarp_suggest_darts,
    OBJECT_OT_wirewarp_suggest_seams,
    OBJECT_OT_wirewarp_choose_suggestion,
    OBJECT_OT_wirewarp_drop_suggestions,
)
