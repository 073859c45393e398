# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattening again by itself what has changed."""

from collections.abc import Callable
from itertools import takewhile

import bpy

from ..blender.modes import WORKING_MODES
from ..properties import take_settings
from ..state.due import is_due
from ..ui import window_run
from . import auto_update
from .models import Outcome
from .read import find_source
from .steps import FlattenSteps

LABEL = "Update Flat Pieces"
JOINING = "OBJECT_OT_wirewarp_update_{}"  # names of the operators of updating_in, by number
MOST = 32  # of them: more kinds of operators than a session uses; after that, updates have undo steps of their own


class UpdateSteps(FlattenSteps):
    """Mixed into the operators that update: one for each undo step that an update has joined, see updating_in."""

    bl_label = LABEL
    bl_options = {"INTERNAL", "UNDO_GROUPED"}
    tries_uv_seams = False

    # As it was begun, it ends with a movement of the mouse that no tool has taken: see auto_update.
    ends_on = "MOUSEMOVE"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Also for scripts: a second run in the window would leave the first without its end."""
        return context.mode in WORKING_MODES and not window_run.is_running()

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        take_settings(self, context.scene.wirewarp)
        sources = auto_update.take_changed(context)
        return self.begin_run(context, sources) if sources else {"CANCELLED"}

    def lets_pass(self, _event: bpy.types.Event) -> bool:
        """Everything: if the user goes on marking, this run ends without a result and the next one begins."""
        return True

    def show(self, context: bpy.types.Context, outcomes: list[Outcome]) -> None:
        """Nothing: the user is at work in this view."""

    def give_up(self, context: bpy.types.Context, code: str, sentence: str, level: str) -> set[str]:
        """A model that changed meanwhile is due again already; what only could not be written is due as it is."""
        if code == "elsewhere":
            sources = filter(None, map(find_source, self._models))
            auto_update.put_back(list(sources), bpy.data.scenes.get(self._scene, context.scene))
        return {"CANCELLED"} if code in {"changed", "elsewhere"} else super().give_up(context, code, sentence, level)

    def message(self, level: str, text: str) -> None:
        """Without the window that an error opens: the report has it, and the user is still at work."""
        self.report({"WARNING" if level == "ERROR" else level}, text)


class OBJECT_OT_wirewarp_update(UpdateSteps, bpy.types.Operator):
    """Flatten again what has changed"""

    bl_idname = "object.wirewarp_update"
    bl_undo_group = LABEL


class WM_OT_wirewarp_watch(bpy.types.Operator):
    """Look whether flat pieces are to be made again"""

    bl_idname = "wm.wirewarp_watch"
    bl_label = "Watch for Changes"
    bl_options = {"INTERNAL"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """A change in another mode, or during a run, waits for its end."""
        return is_due(context.scene) and OBJECT_OT_wirewarp_update.poll(context)

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        if context.scene.wirewarp.auto_update:
            last = context.window_manager.operators[-1].name if context.window_manager.operators else LABEL
            updating_in(last)("INVOKE_DEFAULT", True)
        else:
            auto_update.forget_change(context.scene)
        return {"PASS_THROUGH"}


def updating_in(group: str) -> Callable:
    """The operator that updates within the last undo step, if that is of this name.

    With a step of its own, undo would first take back the pieces alone, and leave them at odds with the marks. Blender
    joins steps of one undo group, and takes an operator's group when it is registered. To register one anew would take
    Adjust Last Operation from the user, for Blender forgets all operations when an operator goes; so there is one more.
    """
    if group == LABEL:
        return bpy.ops.object.wirewarp_update
    joining = _joining()
    number = next((number for number, cls in enumerate(joining) if cls.bl_undo_group == group), len(joining))
    if number == MOST:
        return bpy.ops.object.wirewarp_update
    if number == len(joining):
        idname = f"object.wirewarp_update_{number}"
        content = {"__doc__": OBJECT_OT_wirewarp_update.__doc__, "bl_idname": idname, "bl_undo_group": group}
        bpy.utils.register_class(type(JOINING.format(number), (UpdateSteps, bpy.types.Operator), content))
    return getattr(bpy.ops.object, f"wirewarp_update_{number}")


def _joining() -> list[type[bpy.types.Operator]]:
    """The operators of updating_in that there are."""
    return list(takewhile(bool, (getattr(bpy.types, JOINING.format(number), None) for number in range(MOST))))


def forget_joining() -> None:
    for cls in _joining():
        bpy.utils.unregister_class(cls)


CLASSES = (OBJECT_OT_wirewarp_update, WM_OT_wirewarp_watch)
