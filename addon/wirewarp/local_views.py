# SPDX-License-Identifier: GPL-3.0-or-later
"""Local views: 3D views that show only some objects (numpad /)."""

from collections.abc import Iterator, Sequence

import bpy


def show_where_shown(source: bpy.types.Object, targets: Sequence[bpy.types.Object]) -> None:
    """Adds the targets to every local view that shows the source; new objects are in all of them anyway."""
    for window in bpy.context.window_manager.windows:
        present = window.view_layer.objects.values()
        for view in _local_views(window) if source in present else ():
            # Not local_view_get, which is always False in Blender 3.4.
            if source.visible_get(view_layer=window.view_layer, viewport=view):
                for target in targets:
                    if target in present:
                        target.local_view_set(view, True)


def _local_views(window: bpy.types.Window) -> Iterator[bpy.types.SpaceView3D]:
    for area in window.screen.areas:
        if area.type == "VIEW_3D" and area.spaces.active.local_view:
            yield area.spaces.active
