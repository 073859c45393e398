# SPDX-License-Identifier: GPL-3.0-or-later
"""What Flatten asks for, in the sidebar and after a run alike."""

import bpy

from ..properties import FlattenSettings

LINES_FIRST = {"WIREWARP_PLUS_PLUS", "WIREWARPING"}
WHOLE_WIDTH = {"fairness"}  # the method's too: their names do not fit half a narrow sidebar
ONLY_FOR = {"fairness": {"REFINED"}, "node_weight": LINES_FIRST, "helper_wires": LINES_FIRST}


def draw_settings(layout: bpy.types.UILayout, settings: FlattenSettings) -> None:
    """Every setting; those that the chosen method does not use are gray."""
    layout.prop(settings, "method", text="")
    for name in FlattenSettings.__annotations__:
        if name != "method":
            row = layout.row()
            row.use_property_split = name not in WHOLE_WIDTH
            row.use_property_decorate = False
            row.enabled = settings.method in ONLY_FOR.get(name, {settings.method})
            row.prop(settings, name)
