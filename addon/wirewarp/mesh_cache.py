# SPDX-License-Identifier: GPL-3.0-or-later
"""What was gathered from a mesh for the panel, kept until the mesh changes, so that drawing need not read it again."""

from collections.abc import Callable
from typing import TypeVar

import bpy
from bpy.app.handlers import persistent

T = TypeVar("T")
_kept: dict[str, dict[str, object]] = {}  # by mesh, then by what it is


def kept(mesh: bpy.types.Mesh, what: str, gather: Callable[[bpy.types.Mesh], T]) -> T:
    """gather(mesh), from the last time if the mesh has not changed since."""
    found = _kept.setdefault(mesh.name_full, {})
    if what not in found:
        found[what] = gather(mesh)
    return found[what]


@persistent
def _drop_changed(_scene: bpy.types.Scene, depsgraph: bpy.types.Depsgraph) -> None:
    for update in depsgraph.updates:
        changed = update.id
        if isinstance(changed, bpy.types.Mesh):
            _kept.pop(changed.name_full, None)
        elif isinstance(changed, bpy.types.Object) and update.is_updated_geometry and changed.type == "MESH":
            _kept.pop(changed.data.name_full, None)


@persistent
def _drop_all(*_: object) -> None:
    _kept.clear()


def attach() -> None:
    bpy.app.handlers.depsgraph_update_post.append(_drop_changed)
    for handlers in (bpy.app.handlers.undo_post, bpy.app.handlers.redo_post, bpy.app.handlers.load_post):
        handlers.append(_drop_all)


def detach() -> None:
    bpy.app.handlers.depsgraph_update_post.remove(_drop_changed)
    for handlers in (bpy.app.handlers.undo_post, bpy.app.handlers.redo_post, bpy.app.handlers.load_post):
        handlers.remove(_drop_all)
    _drop_all()
