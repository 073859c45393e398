# SPDX-License-Identifier: GPL-3.0-or-later
"""The areas on flat pieces follow the units of their scene."""

import bpy
from bpy.app.handlers import persistent

from .write_texts import write_areas

_owner = object()  # of the subscriptions to Blender's message bus


def write_all_areas() -> None:
    for scene in bpy.data.scenes:
        write_areas(scene)


@persistent
def _on_undo(*_: object) -> None:
    """The step of a change of units does not hold what was written after it."""
    write_all_areas()


@persistent
def _subscribe(*_: object) -> None:
    """Another file ends all subscriptions."""
    bpy.msgbus.clear_by_owner(_owner)
    for name in ("system", "scale_length", "length_unit"):
        key = (bpy.types.UnitSettings, name)
        bpy.msgbus.subscribe_rna(key=key, owner=_owner, args=(), notify=write_all_areas)


def attach() -> None:
    _subscribe()
    bpy.app.handlers.load_post.append(_subscribe)
    bpy.app.handlers.undo_post.append(_on_undo)
    bpy.app.handlers.redo_post.append(_on_undo)


def detach() -> None:
    bpy.app.handlers.redo_post.remove(_on_undo)
    bpy.app.handlers.undo_post.remove(_on_undo)
    bpy.app.handlers.load_post.remove(_subscribe)
    bpy.msgbus.clear_by_owner(_owner)
