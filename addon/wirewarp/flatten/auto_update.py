# SPDX-License-Identifier: GPL-3.0-or-later
"""Updates flat pieces automatically after changes of the model.

1. A handler notes the change.
2. A timer in state.memory makes Blender send a mouse movement to the current position.
3. Unless a running tool (moving vertices, a knife) consumes the movement, the keymap starts wm.wirewarp_watch.
4. This operator starts the update, which usually joins the last undo step: see updating_in(). The update also ends
   with a movement that no tool consumes.

The timer cannot start the update, because timers run during tools. Leaving Edit Mode would then crash Blender, and
before version 4.2, Python cannot detect the tool.
"""

from collections.abc import Callable
from itertools import takewhile

import bmesh
import bpy

from ..blender.selection import WORKING_MODES
from ..issues import ObjectError
from ..properties import take_settings
from ..solve.report import ObjectReport
from ..state.changes import has_changed, present_state
from ..state.memory import is_due, kept, note_change, state_of
from ..state.owners import model_of
from ..state.reports import last_report
from ..ui import window_run
from .models import Outcome
from .operators import FlattenSteps
from .read import find_source

WATCH = "wm.wirewarp_watch"
# Models with more vertices are updated after Edit Mode, because reading and writing them in Edit Mode is slow.
EDIT_LIMIT = 20_000


def forget_change(scene: bpy.types.Scene) -> None:
    state = state_of(scene)
    state.is_due = state.is_undone = False


def take_changed(context: bpy.types.Context) -> list[bpy.types.Object]:
    """Return the models that differ from their flat pieces. Each state of a model is returned only once. After an undo,
    return no models, because an update would undo the undo."""
    undone = state_of(context.scene).is_undone
    forget_change(context.scene)
    changed = [source for source in _flattened(context) if _needs_update(source)]
    for source in changed:
        state_of(source).tried = _present_state(source)
    return [] if undone else changed


def _present_state(source: bpy.types.Object) -> dict | None:
    """Return the state of the model; None if an attribute of another add-on has one of our names."""
    try:
        return present_state(source, last_report(source).with_modifiers, kept)
    except ObjectError:
        return None


def put_back(sources: list[bpy.types.Object], scene: bpy.types.Scene) -> None:
    """Make take_changed return these models of the scene again, although their states are unchanged."""
    for source in sources:
        state_of(source).tried = None
    note_change(scene)


def is_left(source: bpy.types.Object) -> bool:
    """Return whether Auto ignores the model until it changes again."""
    tried = state_of(source).tried
    return tried is not None and not has_changed(source, tried)


def _flattened(context: bpy.types.Context) -> list[bpy.types.Object]:
    present = set(context.view_layer.objects)
    sources = dict.fromkeys(filter(None, map(model_of, context.scene.objects)))
    return [source for source in sources if source in present and source.library is None]


def waits_for_object_mode(source: bpy.types.Object) -> bool:
    return source.data.is_editmode and len(bmesh.from_edit_mesh(source.data).verts) > EDIT_LIMIT


def _needs_update(source: bpy.types.Object) -> bool:
    if waits_for_object_mode(source):
        return False
    report = last_report(source)
    if is_left(source) and not _is_regrained(source, report):
        return False
    return report is not None and (has_changed(source, report.model_state) or _is_regrained(source, report))


def _is_regrained(source: bpy.types.Object, report: ObjectReport | None) -> bool:
    """Return whether the grain wire has changed since the last run."""
    options = report.options if report else None
    return options is not None and options.get("grain_wire") != source.data.wirewarp_grain


def note_update(scene: bpy.types.Scene, depsgraph: bpy.types.Depsgraph) -> None:
    if depsgraph.mode != "VIEWPORT" or not scene.wirewarp.auto_update:
        return
    if any(isinstance(update.id, (bpy.types.Mesh, bpy.types.Object)) for update in depsgraph.updates):
        note_change(scene)


def note_undo(*_: object) -> None:
    scene = bpy.context.scene
    if scene.wirewarp.auto_update:
        state_of(scene).is_undone = True
        note_change(scene)


def attach() -> Callable[[], None]:
    keyconfig = bpy.context.window_manager.keyconfigs.addon
    if not keyconfig:  # Blender runs in the background
        return lambda: None
    keymap = keyconfig.keymaps.new(name="Window")
    item = keymap.keymap_items.new(WATCH, "MOUSEMOVE", "ANY", any=True)

    return lambda: keymap.keymap_items.remove(item)


LABEL = "Update Flat Pieces"
JOINING = "OBJECT_OT_wirewarp_update_{}"  # class names of the numbered operators that updating_in registers
# Largest number of these operators, more than the kinds of operators in a session. An update that needs one more gets
# its own undo step.
MOST = 32


class UpdateSteps(FlattenSteps):
    """Mixin of the operators that update flat pieces. There is one operator for each name of an undo step that an
    update has joined: see updating_in."""

    bl_label = LABEL
    bl_options = {"INTERNAL", "UNDO_GROUPED"}
    tries_uv_seams = False

    # The run starts and ends with a mouse movement that no tool has consumed: see the beginning of this file.
    ends_on = "MOUSEMOVE"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Forbid a second run in the window, even from a script, because the first run would then not end."""
        return context.mode in WORKING_MODES and not window_run.is_running()

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        take_settings(self, context.scene.wirewarp)
        sources = take_changed(context)
        return self.begin_run(context, sources) if sources else {"CANCELLED"}

    def lets_pass(self, _event: bpy.types.Event) -> bool:
        """Let every event pass. If the user changes the model during the run, the run ends without a result."""
        return True

    def show(self, context: bpy.types.Context, outcomes: list[Outcome]) -> None:
        """Do not move the view, because the user is working in it."""

    def give_up(self, context: bpy.types.Context, code: str, sentence: str, level: str) -> set[str]:
        """End the run without a result. If the mode or the scene has changed, make the models due again. A model that
        has changed is due already."""
        if code == "elsewhere":
            sources = filter(None, map(find_source, self._models))
            put_back(list(sources), bpy.data.scenes.get(self._scene, context.scene))
        return {"CANCELLED"} if code in {"changed", "elsewhere"} else super().give_up(context, code, sentence, level)

    def message(self, level: str, text: str) -> None:
        """Report errors as warnings, because an error would open a window while the user is working."""
        self.report({"WARNING" if level == "ERROR" else level}, text)


class OBJECT_OT_wirewarp_update(UpdateSteps, bpy.types.Operator):
    """Flatten the changed models again"""

    bl_idname = "object.wirewarp_update"
    bl_undo_group = LABEL


class WM_OT_wirewarp_watch(bpy.types.Operator):
    """Check whether flat pieces need an update"""

    bl_idname = "wm.wirewarp_watch"
    bl_label = "Watch for Changes"
    bl_options = {"INTERNAL"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Return whether an update is due and may run. Updates wait for the end of other modes and runs."""
        return is_due(context.scene) and OBJECT_OT_wirewarp_update.poll(context)

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        if context.scene.wirewarp.auto_update:
            last = context.window_manager.operators[-1].name if context.window_manager.operators else LABEL
            updating_in(last)("INVOKE_DEFAULT", True)
        else:
            forget_change(context.scene)
        return {"PASS_THROUGH"}


def updating_in(group: str) -> Callable:
    """Return an operator that updates within the last undo step. group: the name of that step.

    With a separate step, the first undo would restore earlier pieces, which do not match the marks.
    """
    if group == LABEL:
        return bpy.ops.object.wirewarp_update
    # Each group has its own operator, because Blender reads the group when it registers an operator. Registering one
    # operator again for another group would make Adjust Last Operation disappear.
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
    return list(takewhile(bool, (getattr(bpy.types, JOINING.format(number), None) for number in range(MOST))))


def forget_joining() -> None:
    for cls in _joining():
        bpy.utils.unregister_class(cls)
