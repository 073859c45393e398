# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws seams, wires, failures, names, a legend and maps on models, on flat pieces and in the UV editor.

- `shown` finds the objects to draw.
- `objects` and `failures` make arrays and names, which state.drawings keeps.
- `view3d` draws.

May import: export, ui, state, solve, blender, core, issues, names.
"""

from collections.abc import Callable

import bpy

from . import panel
from .view3d import draw_map, draw_map_names, draw_screen, draw_space

MODULES = (panel,)
_HANDLERS = (
    (bpy.types.SpaceView3D, draw_space, "POST_VIEW"),
    (bpy.types.SpaceView3D, draw_screen, "POST_PIXEL"),
    (bpy.types.SpaceImageEditor, draw_map, "POST_VIEW"),
    (bpy.types.SpaceImageEditor, draw_map_names, "POST_PIXEL"),
)


def attach() -> Callable[[], None]:
    added = [(space, space.draw_handler_add(draw, (), "WINDOW", stage)) for space, draw, stage in _HANDLERS]

    def detach() -> None:
        for space, handler in added:
            space.draw_handler_remove(handler, "WINDOW")

    return detach
