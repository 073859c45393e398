# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws sentences, tables, marks and progress in a narrow sidebar."""

from collections.abc import Callable
from functools import lru_cache
from itertools import pairwise

import blf
import bpy
import bpy.utils.previews
import numpy as np

from ..core import Level
from .window_run import Task, shown_progress

WIDE = 330  # width of a wide sidebar, in pixels at interface scale 1; a new sidebar is half as wide
BESIDE_TEXT = 90  # pixels of the sidebar's width that icon, margins and tabs need
FONT = 0  # Blender's number of the interface font
SIZE, THICKNESS = 64, 0.08  # size of a mark in pixels; half the width of its strokes, as a share of the size
Stroke = list[tuple[float, float]]  # points from 0 to 1, with y upward
# These are the strokes and colors of the marks in verdicts. Blender has such marks in gray only.
MARKS: dict[str, tuple[list[Stroke], tuple[float, float, float]]] = {
    "TICK": ([[(0.16, 0.50), (0.40, 0.25), (0.86, 0.76)]], (0.30, 0.78, 0.33)),
    "AMBER": (
        [
            [(0.13, 0.15), (0.5, 0.85), (0.87, 0.15), (0.13, 0.15)],
            [(0.5, 0.58), (0.5, 0.42)],
            [(0.5, 0.27), (0.5, 0.26)],
        ],
        (1.0, 0.65, 0.10),
    ),
}
LEVEL_ICONS = {Level.GOOD: "TICK", Level.CAUTION: "AMBER", Level.BAD: "CANCEL"}  # icons for lines of a verdict
_previews: bpy.utils.previews.ImagePreviewCollection | None = None


class SidebarPanel:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "WireWarp"


def is_wide(context: bpy.types.Context) -> bool:
    """Return whether a table of four columns fits the region."""
    return context.region.width / context.preferences.system.ui_scale >= WIDE


def draw_cells(layout: bpy.types.UILayout, label: str, cells: list[str], label_share: float) -> None:
    """Draw a line of a table: a label, and numbers in columns of equal width."""
    row = layout.row()
    row.scale_y = 0.8
    split = row.split(factor=label_share)
    split.label(text=label)
    columns = split.grid_flow(columns=len(cells), even_columns=True, row_major=True)
    for cell in cells:
        part = columns.row()
        part.alignment = "RIGHT"
        part.label(text=cell)


def broken(context: bpy.types.Context, text: str, reserved: int = 0) -> list[str]:
    """Return the text in lines that fit the region beside an icon. reserved: pixels to leave free besides the icon, at
    interface scale 1."""
    unit = context.preferences.system.ui_scale
    points = context.preferences.ui_styles[0].widget.points
    return _lines(text, context.region.width - (BESIDE_TEXT + reserved) * unit, points * unit)


@lru_cache(maxsize=1000)
def _lines(text: str, width: float, size: float) -> list[str]:
    """Return the lines of the text, which is broken only at spaces. width, size: width of the lines and size of the
    font, in pixels of the screen."""
    blf.size(FONT, size)
    first, *words = text.split(" ")
    lines = [first]
    for word in words:
        longer = f"{lines[-1]} {word}"
        if blf.dimensions(FONT, longer)[0] <= width:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines


def draw_sentence(
    context: bpy.types.Context,
    layout: bpy.types.UILayout,
    text: str,
    icon: str = "NONE",
    reserved: int = 0,
    as_high_as: str = "",
) -> None:
    """Draw a sentence in lines that fit the region, because Blender cuts long labels off.

    icon: name of a Blender icon, or of a mark in MARKS
    reserved: see broken()
    as_high_as: another text; the sentence gets at least as many lines as this text needs
    """
    column = layout.column(align=True)
    column.scale_y = 0.8
    lines = broken(context, text, reserved)
    lines += [""] * (len(broken(context, as_high_as, reserved)) - len(lines))
    for number, line in enumerate(lines):
        if number == 0 and icon in MARKS:
            column.label(text=line, icon_value=mark_icon(icon))
        else:
            column.label(text=line, icon=icon if number == 0 or icon == "NONE" else "BLANK1")


def mark_icon(name: str) -> int:
    """Return the icon_value of the mark; 0 (no icon) if the add-on is not registered or Blender has no window."""
    return _previews[name].icon_id if _previews else 0


def mark_of(ok: bool, is_strained: bool = False) -> dict:
    """Return label arguments for a mark: a cross for a failure, a warning sign for strained fabric, otherwise a
    tick."""
    if not ok:
        return {"icon": "CANCEL"}
    return {"icon_value": mark_icon("AMBER" if is_strained else "TICK")}


def attach() -> Callable[[], None]:
    global _previews
    _previews = bpy.utils.previews.new()
    for name, (strokes, color) in MARKS.items():
        mark = _previews.new(name)
        mark.icon_size = (SIZE, SIZE)
        mark.icon_pixels_float = _pixels(strokes, color).ravel().tolist()
    return _detach


def _detach() -> None:
    global _previews
    bpy.utils.previews.remove(_previews)
    _previews = None


def _pixels(strokes: list[Stroke], color: tuple[float, float, float]) -> np.ndarray:
    """Return the pixels (SIZE, SIZE, 4) of a mark, the lowest row first. As in Blender's icons, colors are multiplied
    by alpha."""
    x, y = np.meshgrid(*2 * [(np.arange(SIZE) + 0.5) / SIZE])
    points = np.stack([x, y], axis=-1)
    lines = [np.array(line) for stroke in strokes for line in pairwise(stroke)]
    distance = np.min([_distance(points, a, b) for a, b in lines], axis=0)
    alpha = np.clip((THICKNESS - distance) * SIZE + 0.5, 0, 1)
    return alpha[..., None] * np.array([*color, 1.0])


def _distance(points: np.ndarray, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return the distances of points (..., 2) from the segment between a and b."""
    share = np.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
    return np.linalg.norm(points - a - share[..., None] * (b - a), axis=-1)


def draw_progress(row: bpy.types.UILayout, task: Task, operator: str) -> bool:
    """Draw the progress of a run of this kind, and return whether there is such a run. operator: operator that started
    the run; before Blender 4.0, there are no progress bars, so its gray button shows the progress."""
    done = shown_progress(task)
    if done is None:
        return False
    text = f"{task.doing} {100 * done:.0f}%" if done < 1 else f"{task.finishing}..."
    if hasattr(row, "progress"):
        row.progress(factor=done, text=text)
    else:
        bar = row.row(align=True)
        bar.enabled = False
        bar.operator(operator, text=text)
    row.operator("object.wirewarp_cancel", text="", icon="X")
    return True
