# SPDX-License-Identifier: GPL-3.0-or-later
"""3D views that show some objects only (Local View, the slash key)."""

from collections.abc import Sequence

import bpy


def show_beside(source: bpy.types.Object, targets: Sequence[bpy.types.Object]) -> None:
    """In local views that show `source`, these objects are shown too."""
    for space in _local_views():
        if source.local_view_get(space):
            for target in targets:
                target.local_view_set(space, True)


def _local_views() -> list[bpy.types.SpaceView3D]:
    windows = bpy.context.window_manager.windows
    spaces = [area.spaces.active for window in windows for area in window.screen.areas if area.type == "VIEW_3D"]
    return [space for space in spaces if space.local_view]
