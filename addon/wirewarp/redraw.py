# SPDX-License-Identifier: GPL-3.0-or-later
"""Redrawing what Blender does not redraw by itself."""

import bpy


def redraw_views() -> None:
    """All 3D views and UV editors with their sidebars."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type in {"VIEW_3D", "IMAGE_EDITOR"}:
                area.tag_redraw()
