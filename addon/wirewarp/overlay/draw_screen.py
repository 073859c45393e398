# SPDX-License-Identifier: GPL-3.0-or-later
"""Names and legend of a 3D view."""

from collections.abc import Iterator

import bpy
from bpy_extras.view3d_utils import location_3d_to_region_2d
from mathutils import Vector

from .shown import Drawing, drawings, extremes, missing_maps, shown_map
from .write_screen import MAX_NAMES, PlacedName, write_legend, write_names


def draw_screen() -> None:
    """The handler for POST_PIXEL."""
    context = bpy.context
    shown = list(drawings(context))
    if not shown:
        return
    unit = context.preferences.system.ui_scale
    if context.scene.wirewarp.show_names:
        write_names((name for drawing in shown for name in _names_in_view(context, drawing)), unit)
    kinds = {kind for drawing in shown if drawing.lines for kind in drawing.lines.places}
    kinds |= {kind for drawing in shown if drawing.failures for kind in drawing.failures.lines}
    color_map = shown_map(context)
    write_legend(context, kinds, unit, missing_maps(shown) if color_map else [], color_map, extremes(shown))


def _names_in_view(context: bpy.types.Context, drawing: Drawing) -> Iterator[PlacedName]:
    """Texts with their places in the region."""
    if drawing.lines is None:
        return
    matrix = drawing.target.matrix_world
    normals = matrix.to_3x3().inverted_safe().transposed()
    scale, view = matrix.median_scale, context.region_data
    eye = view.view_matrix.inverted_safe()
    for name in drawing.lines.names[:MAX_NAMES]:
        place = matrix @ Vector(name.place)
        toward_eye = eye.translation - place if view.is_perspective else eye.col[2].to_3d()
        if (normals @ Vector(name.normal)).dot(toward_eye) < 0:
            continue
        point = location_3d_to_region_2d(context.region, view, place)
        aside = location_3d_to_region_2d(context.region, view, place + eye.col[0].to_3d() * name.reach * scale)
        if point and aside:
            yield PlacedName(name.text, point.x, point.y, (aside - point).length)
