# SPDX-License-Identifier: GPL-3.0-or-later
"""Object Mode and Edit Mode, and undo from either."""

from collections.abc import Iterator
from contextlib import contextmanager

import bpy

WORKING_MODES = {"OBJECT", "EDIT_MESH"}  # in which models are read and results written; in_object_mode leads there


@contextmanager
def in_object_mode(context: bpy.types.Context) -> Iterator[None]:
    """Leaves Edit Mode, so that mesh data is current and can be written, and returns to it at the end."""
    if context.mode != "EDIT_MESH":
        yield
        return
    edited = list(context.objects_in_mode)
    selected = list(context.selected_objects)
    bpy.ops.object.mode_set(mode="OBJECT")
    try:
        yield
    finally:
        _select_only(context, edited)
        bpy.ops.object.mode_set(mode="EDIT")
        _select_only(context, selected)


def _select_only(context: bpy.types.Context, objects: list[bpy.types.Object]) -> None:
    for other in context.view_layer.objects:
        other.select_set(other in objects)


def hold_whole_file() -> None:
    """Makes the operator's undo step one of the whole file. To be called while it writes.

    In Edit Mode Blender's steps hold the edited meshes only, and undo would leave the flat pieces behind. But whenever
    a data-block has come or gone since the whole file was last kept, Blender keeps it again, hidden, with the next
    such step; going back before that step brings back both. So one comes and goes.
    """
    bpy.data.meshes.remove(bpy.data.meshes.new("WireWarp"))
