# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws lines, names and legend in a UV editor."""

from collections.abc import Iterator

import bpy

from .batches import draw_failed, draw_lines
from .blending import blending
from .uv_drawing import UvDrawing, uv_drawings
from .write_screen import PlacedName, write_legend, write_names


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
        for is_rim in (True, False):
            for drawing in shown:
                draw_lines(drawing.target, "uv", drawing.lines, drawing.failures, unit, is_rim)


def draw_map_names() -> None:
    """The handler for POST_PIXEL."""
    context = bpy.context
    shown = list(uv_drawings(context))
    if not shown:
        return
    unit = context.preferences.system.ui_scale
    if context.scene.wirewarp.show_names:
        write_names((name for drawing in shown for name in _names_in_view(context, drawing)), unit)
    kinds = {kind for drawing in shown for kind in drawing.lines.places}
    kinds |= {kind for drawing in shown if drawing.failures for kind in drawing.failures.lines}
    write_legend(context, kinds, unit)


def _names_in_view(context: bpy.types.Context, drawing: UvDrawing) -> Iterator[PlacedName]:
    """Texts with their places in the region."""
    region, to_region = context.region, context.region.view2d.view_to_region
    pixels = (to_region(1000, 0, clip=False)[0] - to_region(0, 0, clip=False)[0]) / 1000  # it rounds
    for name in drawing.lines.names:
        x, y = to_region(*name.place[:2].tolist(), clip=False)
        if 0 <= x <= region.width and 0 <= y <= region.height:
            yield PlacedName(name.text, x, y, name.reach * pixels)
