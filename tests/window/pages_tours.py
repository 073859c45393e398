# SPDX-License-Identifier: GPL-3.0-or-later
"""A tour through the preview of pages."""

import bpy
import drive
from overlay_tours import kinds_seen, look_from_above, marked
from surfaces import flat_of, select_only


def pages_are_on_the_screen() -> drive.Tour:
    """Pages are drawn over the pieces, but not in Edit Mode, where the user moves the pieces."""
    bpy.context.scene.unit_settings.scale_length = 0.1
    source = marked()
    bpy.ops.object.wirewarp_flatten()
    source.hide_set(True)
    select_only(flat_of(source))
    settings = bpy.context.scene.wirewarp
    settings.arrangement = "AS_LAID_OUT"
    yield from look_from_above()
    assert "page" not in kinds_seen("without pages", "VIEW_3D")
    settings.show_pages = True
    yield from drive.ticks(20)
    assert "page" in kinds_seen("pages", "VIEW_3D")
    settings.arrangement = "IN_ROWS"
    yield from drive.ticks(20)
    drive.screenshot("pages beside")
    settings.arrangement = "AS_LAID_OUT"
    yield from drive.open_tab(bpy.types.VIEW3D_PT_wirewarp_pieces)
    yield from drive.ticks(20)
    drive.screenshot("panel")
    bpy.ops.object.mode_set(mode="EDIT")
    yield from drive.ticks(20)
    assert "page" not in kinds_seen("edited pieces", "VIEW_3D")
