# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences in a narrow sidebar."""

import textwrap

import bpy


def draw_sentence(context: bpy.types.Context, layout: bpy.types.UILayout, text: str, icon: str = "NONE") -> None:
    """Blender cuts long labels off, so the sentence is broken into lines that fit the region."""
    scale = context.preferences.system.ui_scale
    width = max(20, int((context.region.width / scale - 60) / 6.2))
    column = layout.column(align=True)
    column.scale_y = 0.8
    for number, line in enumerate(textwrap.wrap(text, width)):
        column.label(text=line, icon=icon if number == 0 else ("BLANK1" if icon != "NONE" else "NONE"))
