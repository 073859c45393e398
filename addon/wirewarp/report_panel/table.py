# SPDX-License-Identifier: GPL-3.0-or-later
"""A table of lengths: four columns where the sidebar is wide, one number a line where it is narrow."""

from collections.abc import Mapping, Sequence

import bpy

from ..blender.units import length_text, meters_per_blender_unit
from ..core import ReportRow, Side, merged, pattern
from ..ui.layout import broken, draw_cells, is_wide, mark_of
from ..words import LengthText

SHOWN_ROWS = 8
MOST_ROWS = 100  # more make Blender slow to draw


def draw_table(
    context: bpy.types.Context,
    layout: bpy.types.UILayout,
    rows: list[ReportRow],
    names: Mapping[int, bpy.types.PropertyGroup],
) -> None:
    """names: what has the name of each seam, by its id; there it can be changed."""
    text, meters = length_text(context.scene), meters_per_blender_unit(context.scene)
    column = layout.column(align=True)
    wide = is_wide(context)
    if wide:
        draw_cells(column, "", [f"Model {text.unit}", f"Flat {text.unit}", "Diff.", "%"], 0.2)
    for row in rows[: shown_rows(context)]:
        if row.seam_id in names:
            _draw_name(column, row, names[row.seam_id])
        else:
            draw_heading(context, column, row.name, mark_of(row.ok), row.what, row.index)
        if row.note:
            draw_note(context, column, row.note, "INFO" if row.at_limit else "BLANK1")
        for longer in longer_sides(row.sides, text, meters):
            draw_note(context, column, longer, "INFO")
        (_draw_wide if wide else _draw_narrow)(column, row, text)
        column.separator(factor=0.7)
    draw_more(context, layout, len(rows))


def shown_rows(context: bpy.types.Context) -> int:
    return MOST_ROWS if context.scene.wirewarp.show_all else SHOWN_ROWS


def draw_more(context: bpy.types.Context, layout: bpy.types.UILayout, count: int) -> None:
    """The switch that shows more of a long list."""
    if count > SHOWN_ROWS:
        text = f"Show all {count}" if count <= MOST_ROWS else f"Show {MOST_ROWS} of {count}"
        layout.prop(context.scene.wirewarp, "show_all", text=text)


def draw_heading(
    context: bpy.types.Context, layout: bpy.types.UILayout, name: str, mark: dict, what: str | None, index: int
) -> None:
    """A name with its mark (see mark_of) and, where there is something to select, the button for it."""
    row = layout.row(align=True)
    text = row.column(align=True)
    lines = broken(context, name, reserved=22 if what else 0)
    text.scale_y = 1 if len(lines) == 1 else 0.8
    for number, line in enumerate(lines):
        text.label(text=line, **({"icon": "BLANK1"} if number else mark))
    if what:
        draw_select(row, what, index)


def _draw_name(layout: bpy.types.UILayout, row: ReportRow, entry: bpy.types.PropertyGroup) -> None:
    line = layout.row(align=True)
    line.prop(entry, "name", text="", **mark_of(row.ok))
    draw_select(line, row.what, row.index)


def draw_note(context: bpy.types.Context, layout: bpy.types.UILayout, note: str, icon: str) -> None:
    column = layout.column(align=True)
    column.scale_y = 0.8
    for number, line in enumerate(broken(context, note)):
        column.label(text=line, icon="BLANK1" if number else icon)


def draw_select(row: bpy.types.UILayout, what: str, index: int) -> None:
    button = row.operator("mesh.wirewarp_select_result", text="", icon="RESTRICT_SELECT_OFF", emboss=False)
    button.what, button.index = what, index


def _draw_wide(column: bpy.types.UILayout, row: ReportRow, text: LengthText) -> None:
    for label, numbers in _flat_lines(row, text):
        draw_cells(column, label, [text.number(row.sides[0].length_3d), *numbers], 0.2)


def _draw_narrow(column: bpy.types.UILayout, row: ReportRow, text: LengthText) -> None:
    draw_cells(column, "Model", [text(row.sides[0].length_3d)], 0.4)
    for label, (flat, difference, percent) in _flat_lines(row, text):
        draw_cells(column, label, [f"{flat} {text.unit}" if percent else flat], 0.4)
        if percent:
            draw_cells(column, " diff.", [f"{difference} {text.unit}  {percent}%"], 0.25)


def _flat_lines(row: ReportRow, text: LengthText) -> list[tuple[str, tuple[str, ...]]]:
    return merged(row.sides, [_flat_numbers(side, text) for side in row.sides])


def _flat_numbers(side: Side, text: LengthText) -> tuple[str, str, str]:
    """Flat length, difference and percent; no percent without a layout."""
    if side.length_2d is None:
        return "not laid flat", "", ""
    percent = f"{abs(side.percent):.3f}" if abs(side.percent) < 5e-4 else f"{side.percent:+.3f}"
    return text.number(side.length_2d), text.difference(side.difference), percent


def longer_sides(sides: Sequence[Side], units: LengthText, meters: float) -> list[str]:
    """ "Sleeve 12 mm longer, ease between notches", as it stands on the paper; of the sides of a seam.

    meters: in a Blender unit.
    """
    asked = {side.label: side.length_asked for side in sides if side.length_2d is not None and side.length_asked}
    millimeters = 1000 * meters
    texts = {
        label: pattern.longer_text(
            length * millimeters, min(asked.values()) * millimeters, lambda more: units.rough(more / millimeters)
        )
        for label, length in asked.items()
    }
    return [f"{label} {text}" for label, text in texts.items() if text]
