# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives the overlay a 3D view, because Blender draws no view without a window."""

from types import SimpleNamespace

import bpy
from mathutils import Matrix, Vector


def view_context(show_overlays=True):
    areas = (area for screen in bpy.data.screens for area in screen.areas)
    space = next(area.spaces.active for area in areas if area.type == "VIEW_3D")
    space.overlay.show_overlays = show_overlays
    return SimpleNamespace(scene=bpy.context.scene, view_layer=bpy.context.view_layer, space_data=space)


def marked_lines(addon, target):
    return addon.overlay.objects.marked_lines(target, bpy.context.evaluated_depsgraph_get())


def look(addon, source, eye, target, perspective=True, xray=False):
    """Return the names in a view of 800 by 600 pixels from `eye` toward `target`, keyed by their texts."""
    forward = (Vector(target) - Vector(eye)).normalized()
    view = (Matrix.Translation(eye) @ forward.to_track_quat("-Z", "Y").to_matrix().to_4x4()).inverted()
    if perspective:  # The angle of view is 90° across. Points nearer than 0.1 or farther than 100 are clipped.
        window = Matrix(((1, 0, 0, 0), (0, 4 / 3, 0, 0), (0, 0, -1.002, -0.2002), (0, 0, -1, 0)))
    else:  # The view is 8 units wide.
        window = Matrix.Diagonal((1 / 4, 1 / 3, -0.01, 1))
    data = SimpleNamespace(view_matrix=view, perspective_matrix=window @ view, is_perspective=perspective)
    context = SimpleNamespace(
        region=SimpleNamespace(width=800, height=600),
        region_data=data,
        space_data=SimpleNamespace(shading=SimpleNamespace(type="SOLID", show_xray=xray)),
        view_layer=bpy.context.view_layer,
    )
    drawing = addon.overlay.shown.Drawing(source, marked_lines(addon, source), None, None)
    return {name.texts[-1]: name for name in addon.overlay.view3d._names_in_view(context, drawing)}
