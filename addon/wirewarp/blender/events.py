# SPDX-License-Identifier: GPL-3.0-or-later
"""Events that Blender sends by itself."""

import bpy


def send_mouse_move(window: bpy.types.Window) -> None:
    """Makes Blender send a movement of the mouse to where it is, so that handlers get one as if a user had moved it.

    After a region is scrolled Blender does so, because another button may lie under the mouse. So one is scrolled by
    nothing.
    """
    for area in window.screen.areas:
        for region in area.regions:
            with bpy.context.temp_override(window=window, area=area, region=region):
                if region.height > 1 and bpy.ops.view2d.pan.poll():
                    bpy.ops.view2d.pan("EXEC_DEFAULT", deltax=0, deltay=0)
                    return
