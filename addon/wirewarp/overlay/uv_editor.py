# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws lines, names and legend in a UV editor."""

from collections.abc import Iterator

import bpy
import numpy as np

from .batches import Layer, blending, draw_failed, draw_lines
from .screen import PlacedName, write_over
from .shown import UvDrawing, uv_drawings


def draw_map() -> None:
    """The handler for POST_VIEW: what is drawn has the coordinates of the map."""
    context = bpy.context
    shown = list(uv_drawings(context))
    if not shown:
        return
    unit = context.preferences.system.ui_scale
    with blending():
        for drawing in shown:
            if drawing.failures is not None and len(drawing.failures.triangles):
                draw_failed(drawing.target, "uv failed faces", drawing.failures.triangles)
        for layer in Layer:
            for drawing in shown:
                draw_lines(drawing.target, "uv", drawing.lines, drawing.failures, unit, layer)


def draw_map_names() -> None:
    """The handler for POST_PIXEL."""
    context = bpy.context
    shown = list(uv_drawings(context))
    if shown:
        write_over(context, shown, (name for drawing in shown for name in _names_in_view(context, drawing)))


def _names_in_view(context: bpy.types.Context, drawing: UvDrawing) -> Iterator[PlacedName]:
    """Texts with those of their places that are in the region."""
    region, to_region = context.region, context.region.view2d.view_to_region
    origin = np.array(to_region(0, 0, clip=False))
    pixels = (np.array(to_region(1000, 1000, clip=False)) - origin) / 1000  # it rounds
    for name in drawing.lines.names:
        points = origin + name.places[:, :2] * pixels
        seen = np.all((points >= 0) & (points <= (region.width, region.height)), axis=1)
        if seen.any():
            room = name.room * pixels[0]
            owner = drawing.target.name_full, name.piece
            yield PlacedName(name.texts, points[seen], name.reach * pixels[0], owner, room, None, name.is_selected)
