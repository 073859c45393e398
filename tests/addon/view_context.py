# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives the overlay a 3D view of the file, because none is drawn without a window."""

from types import SimpleNamespace

import bpy


def view_context(show_overlays=True):
    areas = (area for screen in bpy.data.screens for area in screen.areas)
    space = next(area.spaces.active for area in areas if area.type == "VIEW_3D")
    space.overlay.show_overlays = show_overlays
    return SimpleNamespace(scene=bpy.context.scene, view_layer=bpy.context.view_layer, space_data=space)
