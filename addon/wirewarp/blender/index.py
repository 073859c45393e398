# SPDX-License-Identifier: GPL-3.0-or-later
"""Which objects concern us, asked again only of those that Blender has updated: a file may have thousands of others."""

from collections.abc import Callable

import bpy

Key = tuple[str, str | None]  # name and library, by which bpy.data.objects finds an object
_ours: set[Key] | None = None  # None: all are to be asked
_updated: set[Key] = set()  # these are to be asked again


def find_objects(concerns_us: Callable[[bpy.types.Object], bool]) -> list[bpy.types.Object]:
    """All objects of the file for which concerns_us holds. The same function each time."""
    global _ours
    if _ours is not None:
        asked = {key: bpy.data.objects.get(key) for key in _updated}
        _ours -= asked.keys()
        _ours |= {key for key, target in asked.items() if target and concerns_us(target)}
    _updated.clear()
    found = [bpy.data.objects.get(key) for key in _ours] if _ours is not None else [None]
    if None in found:  # removed or renamed
        found = [target for target in bpy.data.objects if concerns_us(target)]
        _ours = set(map(_key, found))
    return found


def note(target: bpy.types.Object) -> None:
    """Something of ours on it has changed of which Blender need not know."""
    _updated.add(_key(target))


def note_updates(_scene: bpy.types.Scene, depsgraph: bpy.types.Depsgraph) -> None:
    _updated.update(_key(update.id) for update in depsgraph.updates if isinstance(update.id, bpy.types.Object))


def forget(*_: object) -> None:
    global _ours
    _ours = None


def _key(target: bpy.types.Object) -> Key:
    return target.name, target.library.filepath if target.library else None
