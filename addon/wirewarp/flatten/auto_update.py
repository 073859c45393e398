# SPDX-License-Identifier: GPL-3.0-or-later
"""When flat pieces are to be made again by themselves: what has changed since, and whether the user is at rest.

A handler only notes that something changed. The next movement of the mouse reaches the operator wm.wirewarp_watch by
the keymap, unless a tool that is still going on (moving vertices, a knife) keeps it to itself: leaving Edit Mode under
such a tool crashes Blender, and before 4.2 Python cannot ask whether there is one; timers do run under it. The operator
runs the update, with an undo step like any other operator, and the update ends by the same rule. Nobody has to move the
mouse: while something is due, the timer of state.due makes Blender send such an event for where the mouse is.
"""

from collections.abc import Callable

import bmesh
import bpy

from ..issues import ObjectError
from ..solve.report import ObjectReport
from ..state.changes import has_changed, present_state
from ..state.due import note_change
from ..state.memory import kept, state_of
from ..state.owners import model_of
from ..state.reports import last_report

WATCH = "wm.wirewarp_watch"
EDIT_LIMIT = 20_000  # vertices; larger models wait for the end of Edit Mode, for to leave it and come back is felt


def forget_change(scene: bpy.types.Scene) -> None:
    state = state_of(scene)
    state.is_due = state.is_undone = False


def take_changed(context: bpy.types.Context) -> list[bpy.types.Object]:
    """The models that differ from their flat pieces, each once for each of its states; nothing is due after that.

    After undo none does: what was taken back must not be made again behind the user's back.
    """
    undone = state_of(context.scene).is_undone
    forget_change(context.scene)
    changed = [source for source in _flattened(context) if _has_changed(source)]
    for source in changed:
        state_of(source).tried = _present_state(source)
    return [] if undone else changed


def _present_state(source: bpy.types.Object) -> dict | None:
    """None if an attribute of our name is another's."""
    try:
        return present_state(source, last_report(source).with_modifiers, kept)
    except ObjectError:
        return None


def put_back(sources: list[bpy.types.Object], scene: bpy.types.Scene) -> None:
    """What was taken in this scene is due there again, though it is in the same state."""
    for source in sources:
        state_of(source).tried = None
    note_change(scene)


def is_left(source: bpy.types.Object) -> bool:
    """Whether Auto leaves the pieces of the model as they are until it changes again."""
    tried = state_of(source).tried
    return tried is not None and not has_changed(source, tried)


def _flattened(context: bpy.types.Context) -> list[bpy.types.Object]:
    """The models of this view layer that have flat pieces."""
    present = set(context.view_layer.objects)
    sources = dict.fromkeys(filter(None, map(model_of, context.scene.objects)))
    return [source for source in sources if source in present and source.library is None]


def waits_for_object_mode(source: bpy.types.Object) -> bool:
    return source.data.is_editmode and len(bmesh.from_edit_mesh(source.data).verts) > EDIT_LIMIT


def _has_changed(source: bpy.types.Object) -> bool:
    if waits_for_object_mode(source):
        return False
    report = last_report(source)
    if is_left(source) and not _is_regrained(source, report):
        return False
    return report is not None and (has_changed(source, report.model_state) or _is_regrained(source, report))


def _is_regrained(source: bpy.types.Object, report: ObjectReport | None) -> bool:
    """Whether another wire is to stand upright than in the last run."""
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
    if not keyconfig:  # in background
        return lambda: None
    keymap = keyconfig.keymaps.new(name="Window")
    item = keymap.keymap_items.new(WATCH, "MOUSEMOVE", "ANY", any=True)

    return lambda: keymap.keymap_items.remove(item)
