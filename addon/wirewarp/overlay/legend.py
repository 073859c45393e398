# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the parts of the legend stand: all in pixels of the region, from its lower left corner."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from ..solve.maps import ColorMap
from .lines import RIM, RIM_ALPHA, LineStyle
from .surfaces import Extremes, screen_colors

SCALE_WIDTH, SCALE_HEIGHT, SAMPLE = 200, 12, 28  # pixels at interface scale 1
ROW, PADDING = 18, 10
SCALE_STEPS, TICKS = 64, 5
BACKGROUND = (0.33, 0.33, 0.33, 0.9)  # light enough for black lines, dark enough for white letters


@dataclass(frozen=True)
class Box:
    left: float
    bottom: float
    right: float
    top: float
    color: tuple[float, ...]  # sRGB, with or without alpha


@dataclass(frozen=True)
class Text:
    text: str
    left: float
    base: float


@dataclass
class Legend:
    boxes: list[Box] = field(default_factory=list)  # in the order to draw them, the background first
    texts: list[Text] = field(default_factory=list)


def lay_out(
    styles: Sequence[LineStyle],
    notes: Sequence[str],
    color_map: ColorMap | None,
    extremes: Extremes | None,
    corner: tuple[float, float],
    unit: float,
    text_width: Callable[[str], float],
) -> Legend:
    """The legend with its lower right corner at `corner`; unit: pixels in a pixel at interface scale 1.

    From top to bottom: a sample of each line, the notes, the scale of colors.
    """
    right, bottom = corner
    labels = [style.label for style in styles]
    widths = [(SAMPLE + 8) * unit + text_width(label) for label in labels] + [text_width(note) for note in notes]
    if color_map:
        beside = text_width(f"≥ {color_map.number(color_map.high)}")  # half of the outermost numbers, left and right
        widths += [SCALE_WIDTH * unit + beside, text_width(_title(color_map, extremes))]
    if not widths:
        return Legend()
    left = right - max(widths) - 2 * PADDING * unit
    legend = Legend()
    base = bottom + PADDING * unit
    if color_map:
        title = Text(_title(color_map, extremes), left + PADDING * unit, base + (ROW + SCALE_HEIGHT + 6) * unit)
        legend.texts.append(title)
        base = _add_scale(legend, color_map, (left + right) / 2 - SCALE_WIDTH * unit / 2, base, unit, text_width)
    for note in reversed(notes):
        legend.texts.append(Text(note, left + PADDING * unit, base + 4 * unit))
        base += ROW * unit
    for style in reversed(styles):
        _add_sample(legend, style, left + PADDING * unit, base, unit)
        base += ROW * unit
    legend.boxes.insert(0, Box(left, bottom, right, base + PADDING * unit / 2, BACKGROUND))
    return legend


def _title(color_map: ColorMap, extremes: Extremes | None) -> str:
    """With the true extremes: the scale may end before them."""
    if extremes is None:
        return color_map.label
    low, high = (color_map.number(value, digits=3) for value in extremes)
    return f"{color_map.label}: {low} to {high}" if color_map.low < 0 else f"{color_map.label}: up to {high}"


def _add_sample(legend: Legend, style: LineStyle, left: float, base: float, unit: float) -> None:
    middle, end = base + ROW * unit / 2, left + SAMPLE * unit
    parts = [(left, end, style.line_width)]
    if style.dash:
        dash, gap = style.dash
        begins = np.arange(0, SAMPLE, dash + gap) * unit + left
        parts += [(begin, min(begin + dash * unit, end), style.width) for begin in begins.tolist()]
    for color, rim in (((*style.rim, RIM_ALPHA), RIM), (style.color, 0)):
        for begin, stop, width in parts:
            half = (width + rim) * unit / 2
            legend.boxes.append(Box(begin, middle - half, stop, middle + half, color))
    legend.texts.append(Text(style.label, end + 8 * unit, base + 4 * unit))


def _add_scale(
    legend: Legend, color_map: ColorMap, left: float, base: float, unit: float, text_width: Callable[[str], float]
) -> float:
    """The colors with numbers below, and room for a title above; returns where the next row begins."""
    bar, width = base + ROW * unit, SCALE_WIDTH * unit
    values = np.linspace(color_map.low, color_map.high, SCALE_STEPS)
    colors = screen_colors(color_map.colors(values))[:, :3].tolist()
    for step, color in enumerate(colors):
        begin, end = left + width * step / SCALE_STEPS, left + width * (step + 1) / SCALE_STEPS
        legend.boxes.append(Box(begin, bar, end, bar + SCALE_HEIGHT * unit, tuple(color)))
    for share in np.linspace(0, 1, TICKS):
        number = color_map.number(color_map.low + share * (color_map.high - color_map.low))
        beyond = "≥ " if share == 1 else "≤ " if share == 0 and color_map.low < 0 else ""  # what is off the scale
        text = beyond + number
        legend.texts.append(Text(text, left + share * width - text_width(text) / 2, base + 3 * unit))
    return bar + (SCALE_HEIGHT + 4) * unit + ROW * unit
