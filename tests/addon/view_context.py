# SPDX-License-Identifier: GPL-3.0-or-later
"""What the overlay sees of a 3D view, which there is none of without a window."""

from types import SimpleNamespace

import bpy


def view_context(**space):
    overlay = SimpleNamespace(**({"show_overlays": True} | space))
    return SimpleNamespace(
        scene=bpy.context.scene,
        view_layer=bpy.context.view_layer,
        visible_objects=list(bpy.context.view_layer.objects),
        space_data=SimpleNamespace(overlay=overlay),
    )
