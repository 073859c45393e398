# SPDX-License-Identifier: GPL-3.0-or-later
"""When flat pieces are to be made again by themselves: what has changed since, and whether the user is at rest.

A handler only notes that something changed. The next movement of the mouse reaches the operator wm.wirewarp_watch by
the keymap, unless a tool that is still going on (moving vertices, a knife) keeps it to itself: leaving Edit Mode under
such a tool crashes Blender, and before 4.2 Python cannot ask whether there is one; timers do run under it. The operator
runs the update, with an undo step like any other operator, and the update ends by the same rule.
"""

import bmesh
import bpy

from ..blender.cache import kept
from ..flat.reports import last_report
from ..issues import ObjectError
from ..model.owners import model_of
from ..model.state import has_changed, present_state

WATCH = "wm.wirewarp_watch"
EDIT_LIMIT = 20_000  # vertices; larger models wait for the end of Edit Mode, for to leave it and come back is felt
_due: set[str] = set()  # scenes
_undone = False
_tried: dict[str, dict | None] = {}  # by object: the state in which it was left as it is
_keymap_items: list[tuple[bpy.types.KeyMap, bpy.types.KeyMapItem]] = []


def note_change(scene: str) -> None:
    """Something may have changed in this scene (ID.name_full): look into it soon."""
    _due.add(scene)


def is_due(scene: str) -> bool:
    return scene in _due


def forget_change(scene: str) -> None:
    global _undone
    _due.discard(scene)
    _undone = False


def take_changed(context: bpy.types.Context) -> list[bpy.types.Object]:
    """The models that differ from their flat pieces, each once for each of its states; nothing is due after that.

    After undo none does: what was taken back must not be made again behind the user's back.
    """
    undone = _undone
    forget_change(context.scene.name_full)
    changed = [source for source in _flattened(context) if _has_changed(source)]
    for source in changed:
        _tried[source.name_full] = _present_state(source)
    return [] if undone else changed


def _present_state(source: bpy.types.Object) -> dict | None:
    """None if an attribute of our name is another's."""
    try:
        return present_state(source, last_report(source).get("with_modifiers", False), kept)
    except ObjectError:
        return None


def put_back(names: list[str], scene: str) -> None:
    """What was taken in this scene is due there again, though it is in the same state; names: of the objects."""
    for name in names:
        _tried.pop(name, None)
    note_change(scene)


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
    report, tried = last_report(source), _tried.get(source.name_full)
    if tried is not None and not has_changed(source, {"model_state": tried}) and not _is_regrained(source, report):
        return False
    return report is not None and (has_changed(source, report) or _is_regrained(source, report))


def _is_regrained(source: bpy.types.Object, report: dict) -> bool:
    """Whether another wire is to stand upright than in the last run."""
    options = report.get("options") if report else None
    return options is not None and options.get("grain_wire") != source.data.wirewarp_grain


def note_update(scene: bpy.types.Scene, depsgraph: bpy.types.Depsgraph) -> None:
    if depsgraph.mode != "VIEWPORT" or not scene.wirewarp.auto_update:
        return
    if any(isinstance(update.id, (bpy.types.Mesh, bpy.types.Object)) for update in depsgraph.updates):
        note_change(scene.name_full)


def note_undo(*_: object) -> None:
    global _undone
    scene = bpy.context.scene
    if scene.wirewarp.auto_update:
        _undone = True
        note_change(scene.name_full)


def forget(*_: object) -> None:
    global _undone
    _undone = False
    _tried.clear()
    _due.clear()


def attach() -> None:
    keyconfig = bpy.context.window_manager.keyconfigs.addon
    if keyconfig:  # none in background
        keymap = keyconfig.keymaps.new(name="Window")
        _keymap_items.append((keymap, keymap.keymap_items.new(WATCH, "MOUSEMOVE", "ANY", any=True)))


def detach() -> None:
    for keymap, item in _keymap_items:
        keymap.keymap_items.remove(item)
    _keymap_items.clear()
