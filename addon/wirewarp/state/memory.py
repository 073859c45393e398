# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps data about objects, meshes and scenes in memory until these are removed or another file is opened.

Data from geometry is kept until the geometry changes, so that drawing does not read it again.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any, TypeVar

import bpy

from ..blender.views import send_mouse_move

T = TypeVar("T")
Owner = TypeVar("Owner", bpy.types.Mesh, bpy.types.Object)
Take = Callable[[bpy.types.ID, str, Callable], Any]  # type of the functions kept and read_anew
Place = tuple[str, str | None]  # name and library of an object, the key of bpy.data.objects


@dataclass
class ObjectState:
    """Data about one object, mesh or scene."""

    name: str  # Blender's name_full at the last call of state_of
    gathered: dict[str, Any] = field(default_factory=dict)  # data read from its geometry, by name; see kept
    drawings: dict[str, Any] = field(default_factory=dict)  # drawings by kind; see state.drawings
    parsed: Any = None  # the text of the stored report, and the parsed report; see state.reports
    failure: Any = None  # the report of a run that wrote nothing; see state.reports
    failed_after: str = ""  # text of the stored report during the run in `failure`; "" if there was none
    suggestions: Any = None  # the suggested cuts; see state.suggestions
    size_asked: Any = None  # the question about the object's size; see report_panel.flatten_panel
    solved: Any = None  # the wirewarp.Cache of its solved pieces; see flatten.read
    solved_by_map: Any = None  # the Cache for the attempt with the seams of its UV map
    tried: dict | None = None  # changed state that Auto last handled, even without an update; see flatten.auto_update
    is_due: bool = False  # for a scene: Auto has to look for changes; see note_change
    is_undone: bool = False  # for a scene: the last change was an undo


@dataclass
class _Memory:
    states: dict[object, ObjectState] = field(default_factory=dict)  # states, keyed by _key()
    counts: tuple[int, ...] = ()  # numbers of objects and meshes when states of removed objects were last dropped
    ours: set[Place] | None = None  # objects found by find_objects; None if it must check all objects
    updated: set[Place] = field(default_factory=set)  # objects that find_objects must check again


_memory = _Memory()


def state_of(owner: bpy.types.ID) -> ObjectState:
    """Returns the state of this data-block, which is made if it does not exist."""
    key, name = _key(owner), owner.name_full
    state = _memory.states.get(key)
    if state is None:
        state = _memory.states[key] = ObjectState(name)
    elif state.name != name:  # before Blender 4.1, another data-block may have the same address
        state.name = name
        state.gathered.clear()
        state.drawings.clear()
    return state


def all_states() -> Iterator[ObjectState]:
    return iter(_memory.states.values())


def _key(owner: bpy.types.ID) -> object:
    """Returns a key of the data-block that renaming does not change. Before Blender 4.1, a later data-block may get the
    same key."""
    return owner.session_uid if hasattr(owner, "session_uid") else owner.as_pointer()


def kept(owner: Owner, what: str, gather: Callable[[Owner], T]) -> T:
    """Returns gather(owner), or its last result if the owner's geometry is unchanged. A changed selection may count as
    a change of geometry. what: name of the result."""
    found = state_of(owner).gathered
    if what not in found:
        found[what] = gather(owner)
    return found[what]


def read_anew(owner: Owner, _what: str, gather: Callable[[Owner], T]) -> T:
    """Returns a new gather(owner), because scripts may change a mesh without Blender noticing."""
    return gather(owner)


def stamp(owner: bpy.types.Mesh | bpy.types.Object) -> object:
    """Returns an object that is replaced by a new one when the owner's geometry changes."""
    return kept(owner, "stamp", lambda _: object())


def find_objects(concerns_us: Callable[[bpy.types.Object], bool]) -> list[bpy.types.Object]:
    """Returns all objects of the file for which concerns_us() is true. All calls must pass the same function."""
    # Only objects that Blender has updated are checked again, because a file may contain thousands of objects.
    if _memory.ours is not None:
        asked = {place: bpy.data.objects.get(place) for place in _memory.updated}
        _memory.ours -= asked.keys()
        _memory.ours |= {place for place, target in asked.items() if target and concerns_us(target)}
    _memory.updated.clear()
    found = [None] if _memory.ours is None else [bpy.data.objects.get(place) for place in _memory.ours]
    if None in found:  # an object was removed or renamed
        found = [target for target in bpy.data.objects if concerns_us(target)]
        _memory.ours = set(map(_place, found))
    return found


def note(target: bpy.types.Object) -> None:
    """Notes that the add-on's data on the object have changed, because Blender does not report this change."""
    _memory.updated.add(_place(target))


def _place(target: bpy.types.Object) -> Place:
    return target.name, target.library.filepath if target.library else None


def note_updates(scene: bpy.types.Scene, depsgraph: bpy.types.Depsgraph) -> None:
    """Handler that runs after an update of the depsgraph. It notes updated objects, and drops states of removed
    data-blocks."""
    _memory.updated.update(_place(update.id) for update in depsgraph.updates if isinstance(update.id, bpy.types.Object))
    drop_changed(scene, depsgraph)
    counts = len(bpy.data.objects), len(bpy.data.meshes)
    if counts != _memory.counts:
        _memory.counts = counts
        present = {_key(each) for each in (*bpy.data.objects, *bpy.data.meshes, *bpy.data.scenes)}
        for key in _memory.states.keys() - present:
            del _memory.states[key]


def drop_changed(_scene: bpy.types.Scene, depsgraph: bpy.types.Depsgraph) -> None:
    """Drops data gathered from changed geometry, after an update or a change of the frame. During playback, only
    animated objects are read again."""
    for update in depsgraph.updates:
        changed = update.id.original
        if isinstance(changed, bpy.types.Mesh):
            _drop(changed)
        elif isinstance(changed, bpy.types.Object) and update.is_updated_geometry and changed.type == "MESH":
            _drop(changed)
            _drop(changed.data)


def _drop(owner: bpy.types.ID) -> None:
    if state := _memory.states.get(_key(owner)):
        state.gathered.clear()


def drop_gathered(*_: object) -> None:
    """Handler that drops all gathered data after undo and redo, which may change any object."""
    for state in all_states():
        state.gathered.clear()
    _memory.ours = None


def forget(*_: object) -> None:
    global _memory
    _memory = _Memory()
    if bpy.app.timers.is_registered(_nudge):
        bpy.app.timers.unregister(_nudge)


SECONDS = 0.2  # seconds between mouse movements of _nudge: updates feel immediate, and running tools are not disturbed


def is_due(scene: bpy.types.Scene) -> bool:
    return state_of(scene).is_due


def note_change(scene: bpy.types.Scene) -> None:
    """Notes that something may have changed in this scene, so that Auto checks it soon."""
    state_of(scene).is_due = True
    if not bpy.app.background and not bpy.app.timers.is_registered(_nudge):
        bpy.app.timers.register(_nudge, first_interval=SECONDS)


def _nudge() -> float | None:
    """Timer that sends mouse movements while Auto must check a visible scene. Returns the seconds until the next
    call."""
    windows = [window for window in bpy.context.window_manager.windows if is_due(window.scene)]
    for window in windows:
        send_mouse_move(window)
    return SECONDS if windows else None
