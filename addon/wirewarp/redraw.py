# SPDX-License-Identifier: GPL-3.0-or-later
"""Redrawing what Blender does not redraw by itself."""

import bpy


def redraw_views() -> None:
    """All 3D views with their sidebars."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()
