# SPDX-License-Identifier: GPL-3.0-or-later
"""The overlay: seams, wires and failures on models, on flat pieces and in the UV editor, with names and a legend; maps.

3D view: shown (which objects) -> object_drawing, failure_drawing (arrays and names, kept in cache) -> draw_space,
draw_screen (handlers). UV editor: uv_drawing -> draw_uv.
"""

import bpy

from . import cache
from .draw_screen import draw_screen
from .draw_space import draw_space
from .draw_uv import draw_map, draw_map_names

_HANDLERS = (
    (bpy.types.SpaceView3D, draw_space, "POST_VIEW"),
    (bpy.types.SpaceView3D, draw_screen, "POST_PIXEL"),
    (bpy.types.SpaceImageEditor, draw_map, "POST_VIEW"),
    (bpy.types.SpaceImageEditor, draw_map_names, "POST_PIXEL"),
)
_added: list[tuple[type[bpy.types.Space], object]] = []


def attach() -> None:
    cache.attach()
    for space, draw, stage in _HANDLERS:
        _added.append((space, space.draw_handler_add(draw, (), "WINDOW", stage)))


def detach() -> None:
    while _added:
        space, handler = _added.pop()
        space.draw_handler_remove(handler, "WINDOW")
    cache.detach()
