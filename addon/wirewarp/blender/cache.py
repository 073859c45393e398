# SPDX-License-Identifier: GPL-3.0-or-later
"""What was gathered from a mesh or object to be shown, kept until it changes: drawing need not read it again."""

from collections.abc import Callable
from typing import Any, TypeVar

import bpy

T = TypeVar("T")
Owner = TypeVar("Owner", bpy.types.Mesh, bpy.types.Object)
Take = Callable[[bpy.types.ID, str, Callable], Any]  # kept or read_anew
_kept: dict[tuple[str, str], dict[str, Any]] = {}  # by owner, then by what it is


def kept(owner: Owner, what: str, gather: Callable[[Owner], T]) -> T:
    """gather(owner), from the last time if its geometry has not changed since. A selection may count as a change."""
    found = _kept.setdefault(_key(owner), {})
    if what not in found:
        found[what] = gather(owner)
    return found[what]


def read_anew(owner: Owner, _what: str, gather: Callable[[Owner], T]) -> T:
    """As kept, whatever was kept: scripts may change a mesh without telling Blender."""
    return gather(owner)


def stamp(owner: bpy.types.Mesh | bpy.types.Object) -> object:
    """The same object until the owner's geometry changes, and never again the same after that."""
    return kept(owner, "stamp", lambda _: object())


def _key(owner: bpy.types.ID) -> tuple[str, str]:
    return "Mesh" if isinstance(owner, bpy.types.Mesh) else "Object", owner.name_full


def drop_changed(_scene: bpy.types.Scene, depsgraph: bpy.types.Depsgraph) -> None:
    """After an update of the depsgraph, of another frame too: in playback only what is animated is read again."""
    for update in depsgraph.updates:
        changed = update.id
        if isinstance(changed, bpy.types.Mesh):
            _kept.pop(_key(changed), None)
        elif isinstance(changed, bpy.types.Object) and update.is_updated_geometry and changed.type == "MESH":
            _kept.pop(_key(changed), None)
            _kept.pop(_key(changed.data), None)


def drop_all(*_: object) -> None:
    _kept.clear()
