# SPDX-License-Identifier: GPL-3.0-or-later
"""The overlay of the 3D view: seams, wires, failures and maps on models and flat pieces, with names and a legend.

shown (which objects) -> object_drawing (arrays and names, kept in cache) -> draw_space, draw_screen (handlers).
"""

import bpy

from . import cache
from .draw_screen import draw_screen
from .draw_space import draw_space

_handlers: list[object] = []


def attach() -> None:
    cache.attach()
    for draw, stage in ((draw_space, "POST_VIEW"), (draw_screen, "POST_PIXEL")):
        _handlers.append(bpy.types.SpaceView3D.draw_handler_add(draw, (), "WINDOW", stage))


def detach() -> None:
    while _handlers:
        bpy.types.SpaceView3D.draw_handler_remove(_handlers.pop(), "WINDOW")
    cache.detach()
