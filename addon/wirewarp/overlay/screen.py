# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes names and the legend over a view."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import blf
import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from ..solve.maps import ColorMap
from .batches import blending
from .legend import Box, Text, lay_out
from .lines import STYLES
from .shown import Drawing, UvDrawing
from .surfaces import Extremes

FONT, FONT_SIZE, MARGIN = 0, 12, 16
MAX_NAMES = 150
NAME_TO_LINE = 1.3  # a name is at most so many times as long as its line
LABEL, NAME_COLOR, LEGEND_COLOR = (0.08, 0.08, 0.08, 0.65), (1.0, 1.0, 1.0), (0.9, 0.9, 0.9)
TEXT_MARGIN = 0.3  # around each text, in its heights
ABOVE, BELOW = 0.5, -1.5  # its lower edge from the point where it stands, in its heights
Corner = tuple[float, float]


class PlacedName(NamedTuple):
    """In pixels of the region."""

    text: str
    points: np.ndarray  # (c,2) where it may stand, the best first
    reach: float  # of the line that is named


def write_over(
    context: bpy.types.Context,
    shown: Sequence[Drawing | UvDrawing],
    names: Iterable[PlacedName],
    notes: Sequence[str] = (),
    color_map: ColorMap | None = None,
    extremes: Extremes | None = None,
) -> None:
    """Names and legend of what is drawn in a view."""
    unit = context.preferences.system.ui_scale
    if context.scene.wirewarp.show_names:
        write_names(names, unit)
    kinds = {kind for each in shown if each.lines for kind in each.lines.places}
    kinds |= {kind for each in shown if each.failures for kind in each.failures.kinds}
    write_legend(context, kinds, unit, notes, color_map, extremes)


def write_names(names: Iterable[PlacedName], unit: float) -> None:
    """As many as fit, and none much longer than what it names. unit: see draw_lines."""
    blf.size(FONT, FONT_SIZE * unit)
    found = [name for name in names if blf.dimensions(FONT, name.text)[0] < NAME_TO_LINE * 2 * name.reach][:MAX_NAMES]
    sizes = [blf.dimensions(FONT, name.text) for name in found]
    texts, boxes = [], []
    for name, size, corner in zip(found, sizes, spread([name.points for name in found], sizes), strict=True):
        if corner is not None:
            texts.append(Text(name.text, *corner))
            boxes.append(_label(texts[-1], size))
    _fill(boxes)
    _write(texts, NAME_COLOR)


def write_legend(
    context: bpy.types.Context,
    kinds: set[str],
    unit: float,
    notes: Sequence[str],
    color_map: ColorMap | None,
    extremes: Extremes | None,
) -> None:
    """Of these kinds of line, in the lower right corner."""
    blf.size(FONT, FONT_SIZE * unit)
    legend = lay_out(
        [style for kind, style in reversed(STYLES.items()) if kind in kinds],
        notes,
        color_map,
        extremes,
        _corner(context, unit),
        unit,
        lambda text: blf.dimensions(FONT, text)[0],
    )
    _fill(legend.boxes)
    _write(legend.texts, LEGEND_COLOR)


def _corner(context: bpy.types.Context, unit: float) -> tuple[float, float]:
    """Left of the sidebar, where it lies over the view."""
    sidebar = next(region for region in context.area.regions if region.type == "UI")
    over = context.preferences.system.use_region_overlap and sidebar.width > 1
    return context.region.width - (sidebar.width if over else 0) - MARGIN * unit, MARGIN * unit


def _label(text: Text, size: tuple[float, float]) -> Box:
    """Dark ground, on which a name can be read whatever is below."""
    (width, height), aside = size, 0.3 * size[1]
    return Box(text.left - aside, text.base - aside, text.left + width + aside, text.base + height + aside, LABEL)


def _fill(boxes: list[Box]) -> None:
    if not boxes:
        return
    left, bottom, right, top = np.array([(box.left, box.bottom, box.right, box.top) for box in boxes], np.float32).T
    corners = np.array([(left, bottom), (right, bottom), (right, top), (left, bottom), (right, top), (left, top)])
    places = np.ascontiguousarray(corners.transpose(2, 0, 1).reshape(-1, 2))
    colors = np.array([(*box.color, 1.0)[:4] for box in boxes], np.float32).repeat(6, axis=0)
    shader = gpu.shader.from_builtin("SMOOTH_COLOR")
    with blending():
        batch_for_shader(shader, "TRIS", {"pos": places, "color": colors}).draw(shader)


def _write(texts: list[Text], color: tuple[float, float, float]) -> None:
    blf.color(FONT, *color, 1.0)
    for text in texts:
        blf.position(FONT, round(text.left), round(text.base), 0)
        blf.draw(FONT, text.text)


def spread(points: Sequence[np.ndarray], sizes: Sequence[tuple[float, float]]) -> list[Corner | None]:
    """The lower left corner of each text, earlier ones before later ones; None where there is no room for it.

    points: for each text those (c,2) above or below the middle of which it may stand, the best first; sizes: the
    widths and heights.
    """
    corners: list[Corner | None] = []
    taken = np.empty((0, 4))  # left, bottom, right, top
    for own, (width, height) in zip(points, sizes, strict=True):
        room = TEXT_MARGIN * height
        left, bottom = own[:, 0].repeat(2) - width / 2, (own[:, 1:] + [ABOVE * height, BELOW * height]).ravel()
        boxes = np.column_stack([left - room, bottom - room, left + width + room, bottom + height + room])
        overlap = (boxes[:, None, :2] < taken[:, 2:]) & (taken[:, :2] < boxes[:, None, 2:])
        free = np.flatnonzero(~np.any(np.all(overlap, axis=2), axis=1))
        if len(free):
            taken = np.vstack([taken, boxes[free[0]]])
            corners.append((float(left[free[0]]), float(bottom[free[0]])))
        else:
            corners.append(None)
    return corners
