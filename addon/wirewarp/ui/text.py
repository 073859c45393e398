# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences in a narrow sidebar."""

from functools import lru_cache

import blf
import bpy

from .tick import green_tick

WIDE = 330  # in Blender's own pixels; the sidebar starts at half of it
BESIDE_TEXT = 90  # of the region's width: icon, margins and the tabs
FONT = 0  # of the user interface


def is_wide(context: bpy.types.Context) -> bool:
    """Whether a table of four columns fits the region."""
    return context.region.width / context.preferences.system.ui_scale >= WIDE


def draw_cells(layout: bpy.types.UILayout, label: str, cells: list[str], label_share: float) -> None:
    """A line of a table: a label, and numbers in columns of equal width."""
    row = layout.row()
    row.scale_y = 0.8
    split = row.split(factor=label_share)
    split.label(text=label)
    columns = split.grid_flow(columns=len(cells), even_columns=True, row_major=True)
    for cell in cells:
        part = columns.row()
        part.alignment = "RIGHT"
        part.label(text=cell)


def broken(context: bpy.types.Context, text: str, spare: int = 0) -> list[str]:
    """The text in lines that fit the region beside an icon, no number apart from its %.

    spare: more of Blender's own pixels to leave free.
    """
    unit = context.preferences.system.ui_scale
    points = context.preferences.ui_styles[0].widget.points
    return _lines(text, context.region.width - (BESIDE_TEXT + spare) * unit, points * unit)


@lru_cache(maxsize=1000)
def _lines(text: str, width: float, size: float) -> list[str]:
    """Broken at spaces only; width and font size in pixels of the screen."""
    blf.size(FONT, size)
    first, *words = text.split(" ")
    lines = [first]
    for word in words:
        longer = f"{lines[-1]} {word}"
        if word == "%" or blf.dimensions(FONT, longer)[0] <= width:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines


def draw_sentence(
    context: bpy.types.Context, layout: bpy.types.UILayout, text: str, icon: str = "NONE", spare: int = 0
) -> None:
    """Blender cuts long labels off, so the sentence is broken into lines that fit the region less spare pixels.

    icon is a name of Blender's, or "TICK", which is green.
    """
    column = layout.column(align=True)
    column.scale_y = 0.8
    for number, line in enumerate(broken(context, text, spare)):
        if number == 0 and icon == "TICK":
            column.label(text=line, icon_value=green_tick())
        else:
            column.label(text=line, icon=icon if number == 0 or icon == "NONE" else "BLANK1")
