# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws names and the legend over a view."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import blf
import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from ..blender.views import covered_above, note_legend
from ..solve.maps import ColorMap
from .batches import blending
from .gather import screen_colors
from .lines import RIM, RIM_ALPHA, STYLES, LineStyle
from .shown import Drawing, UvDrawing

# Sizes in pixels at interface scale 1. A color scale has room for TICKS numbers, and is as high as FONT_SIZE. A line
# sample is longer than the longest dash and its gap.
SCALE_WIDTH, SCALE_HEIGHT, SAMPLE = 200, 12, 28
ROW, PADDING = 18, 10  # pixels at interface scale 1; a row is 1.5 times as high as FONT_SIZE
SCALE_STEPS, TICKS = 64, 5  # steps of 3 pixels look continuous; numbers at 9 ticks would touch each other
BACKGROUND = (0.33, 0.33, 0.33, 0.9)  # light enough for black lines, dark enough for white letters


@dataclass(frozen=True)
class Box:
    left: float
    bottom: float
    right: float
    top: float
    color: tuple[float, ...]  # sRGB, with optional alpha


@dataclass(frozen=True)
class Text:
    text: str
    left: float
    base: float


@dataclass
class Legend:
    boxes: list[Box] = field(default_factory=list)  # in drawing order, the background first
    texts: list[Text] = field(default_factory=list)


def lay_out(
    styles: Sequence[LineStyle],
    notes: Sequence[str],
    color_map: ColorMap | None,
    highest: float | None,
    corner: tuple[float, float],
    unit: float,
    text_width: Callable[[str], float],
) -> Legend:
    """Return the legend with its lower right corner at `corner`: lines, notes and color scale, from top to bottom.

    highest: largest value of the map, for the title of the scale; None: not shown
    unit: pixels of the screen per pixel at interface scale 1
    """
    right, bottom = corner
    labels = [style.label for style in styles]
    widths = [(SAMPLE + 8) * unit + text_width(label) for label in labels] + [text_width(note) for note in notes]
    if color_map:
        beside = text_width(f"≥ {color_map.number(color_map.high)}")  # room for half of the number at each end
        widths += [SCALE_WIDTH * unit + beside, text_width(_title(color_map, highest))]
    if not widths:
        return Legend()
    left = right - max(widths) - 2 * PADDING * unit
    legend = Legend()
    base = bottom + PADDING * unit
    if color_map:
        title = Text(_title(color_map, highest), left + PADDING * unit, base + (ROW + SCALE_HEIGHT + 6) * unit)
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


def _title(color_map: ColorMap, highest: float | None) -> str:
    return color_map.label if highest is None else f"{color_map.label}: up to {color_map.number(highest, digits=3)}"


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
    """Add the color scale with numbers below and room for a title above. Return the y of the next row."""
    bar, width = base + ROW * unit, SCALE_WIDTH * unit
    values = np.linspace(color_map.low, color_map.high, SCALE_STEPS)
    colors = screen_colors(color_map.colors(values))[:, :3].tolist()
    for step, color in enumerate(colors):
        begin, end = left + width * step / SCALE_STEPS, left + width * (step + 1) / SCALE_STEPS
        legend.boxes.append(Box(begin, bar, end, bar + SCALE_HEIGHT * unit, tuple(color)))
    for share in np.linspace(0, 1, TICKS):
        number = color_map.number(color_map.low + share * (color_map.high - color_map.low))
        # Values beyond the scale have the color of its end, so the numbers at its ends begin with a sign.
        beyond = "≥ " if share == 1 else "≤ " if share == 0 and color_map.low < 0 else ""
        text = beyond + number
        legend.texts.append(Text(text, left + share * width - text_width(text) / 2, base + 3 * unit))
    return bar + (SCALE_HEIGHT + 4) * unit + ROW * unit


FONT, FONT_SIZE, MARGIN = 0, 12, 16  # Blender's interface font; its size and the legend's margin, in pixels at scale 1
MAX_NAMES = 150  # names of 100 x 19 pixels then cover a fifth of a view of 1600 x 900 pixels
NAME_TO_LINE = 1.3  # largest length of a name, as a multiple of the length of its line, so that the line is recognized
SAME = 1.0  # pixels: points this close to the outermost point on a side count as outermost
COVERED = 0.25  # maximum share of a piece that all its labels together may hide: most of the piece stays visible
LONG_COVERED = 0.03  # maximum share that one label may hide if a shorter text is possible: COVERED then has room for 8
LABEL, NAME_COLOR, LEGEND_COLOR = (0.08, 0.08, 0.08, 0.65), (1.0, 1.0, 1.0), (0.9, 0.9, 0.9)
LABEL_MARGIN = 0.3  # margin around each text, in text heights
# Distance from a point to the lower edge of its text, in text heights. Half a height is free between point and text.
ABOVE, BELOW = 0.5, -1.5
Corner = tuple[float, float]
Size = tuple[float, float]  # width and height
Span = tuple[float, float]
EVERYWHERE = (-np.inf, np.inf)
NO_LINES = np.empty((0, 2, 2))
# These are the heights of the panel Adjust Last Operation (lower left) and of the navigation gizmos (upper right), in
# pixels at interface scale 1.
REDO, NAVIGATION = 45, 230


class PlacedName(NamedTuple):
    """A name with its possible places, in pixels of the region."""

    texts: tuple[str, ...]  # alternatives: the first text that fits is written
    points: np.ndarray  # (c,2) possible places, the best first
    reach: float  # like reach of lines.Name, in pixels
    owner: tuple[str, int]  # object and piece on which the name needs room
    room: float  # like room of lines.Name, in pixels
    around: np.ndarray | None  # (c,2) outermost points of the piece, for a name that fits only beside it
    is_selected: bool  # a name of selected edges is always written


def write_over(
    context: bpy.types.Context,
    shown: Sequence[Drawing | UvDrawing],
    names: Iterable[PlacedName],
    notes: Sequence[str] = (),
    color_map: ColorMap | None = None,
    highest: float | None = None,
    lines: np.ndarray = NO_LINES,
) -> None:
    """Draw names and the legend of the objects in a view. highest: see lay_out; lines: see free_corner."""
    unit = context.preferences.system.ui_scale
    if context.scene.wirewarp.show_names:
        write_names(names, unit, _free_span(context))
    kinds = {kind for each in shown if each.lines for kind in each.lines.places}
    kinds |= {kind for each in shown if each.failures for kind in each.failures.kinds}
    write_legend(context, kinds, unit, notes, color_map, highest, lines)


def write_names(names: Iterable[PlacedName], unit: float, span: Span = EVERYWHERE) -> None:
    """Draw the names that fit. unit: see draw_lines; span: see arrange."""
    blf.size(FONT, FONT_SIZE * unit)

    def size_of(text: str) -> Size:
        return blf.dimensions(FONT, text)

    texts = arrange(names, size_of, span)
    _fill([_label(text, size_of(text.text)) for text in texts])
    _write(texts, NAME_COLOR)


def arrange(names: Iterable[PlacedName], size_of: Callable[[str], Size], span: Span = EVERYWHERE) -> list[Text]:
    """Return the texts of the names that fit and touch no other name, with their places.

    span: columns of pixels that no sidebar covers; names with a point in the span stay in it
    """
    wanted = list(names)
    boxes = [_box(name.around).ravel() for name in wanted if name.around is not None]
    placed: list[Text] = []
    taken, covered = Taken(np.array(boxes).reshape(-1, 4), span), dict[tuple[str, int], float]()
    for name in wanted:
        for text in _that_fit(name, covered.get(name.owner, 0.0), size_of):
            corner = taken.place(name.points, size_of(text))
            if corner is not None:
                placed.append(Text(text, *corner))
                covered[name.owner] = covered.get(name.owner, 0.0) + _area(size_of(text))
                break
        else:
            corner = None if name.around is None else taken.place_beside(name.around, size_of(name.texts[-1]))
            if corner is not None:
                placed.append(Text(name.texts[-1], *corner))
        if len(placed) == MAX_NAMES:
            break
    return placed


def _box(points: np.ndarray) -> np.ndarray:
    return np.array([points.min(axis=0), points.max(axis=0)])


def _that_fit(name: PlacedName, covered: float, size_of: Callable[[str], Size]) -> Iterator[str]:
    """Yield the texts of the name that fit on its line and piece. covered: area of the piece that labels already
    hide, in square pixels."""
    for text in name.texts:
        size = size_of(text)
        is_last = text == name.texts[-1]
        fits_line = size[0] < NAME_TO_LINE * 2 * name.reach
        fits_piece = covered + _area(size) <= COVERED * name.room**2 and (
            is_last or _area(size) <= LONG_COVERED * name.room**2
        )
        if name.is_selected or (fits_line and fits_piece):
            yield text


def _area(size: Size) -> float:
    """Return the area of a label with a text of this size, including its margin."""
    return (size[0] + 2 * LABEL_MARGIN * size[1]) * (1 + 2 * LABEL_MARGIN) * size[1]


def write_legend(
    context: bpy.types.Context,
    kinds: set[str],
    unit: float,
    notes: Sequence[str],
    color_map: ColorMap | None,
    highest: float | None,
    lines: np.ndarray,
) -> None:
    """Draw the legend in a corner where it covers no line. kinds: kinds of line to explain."""
    blf.size(FONT, FONT_SIZE * unit)
    styles = [style for kind, style in reversed(STYLES.items()) if kind in kinds]

    def at(corner: Corner) -> Legend:
        return lay_out(styles, notes, color_map, highest, corner, unit, lambda text: blf.dimensions(FONT, text)[0])

    legend = at((0.0, 0.0))
    if legend.boxes:
        box = legend.boxes[0]
        legend = at(free_corner(_corners(context, unit, (box.right - box.left, box.top)), box, lines))
        if context.area.type == "VIEW_3D":
            note_legend(box.right - box.left + MARGIN * unit)
    _fill(legend.boxes)
    _write(legend.texts, LEGEND_COLOR)


def free_corner(corners: Sequence[Corner], box: Box, lines: np.ndarray) -> Corner:
    """Return the first corner at which no line crosses the box, or else the first corner.

    corners: places for the lower right corner of the box; lines (k,2,2): ends in pixels
    """
    begins, ways = lines[:, 0], lines[:, 1] - lines[:, 0]
    for right, bottom in corners:
        low, high = (right + box.left - box.right, bottom), (right, bottom + box.top - box.bottom)
        with np.errstate(divide="ignore", invalid="ignore"):
            shares = np.stack([(low - begins) / ways, (high - begins) / ways])  # where a line meets the box's sides
        enters, leaves = shares.min(axis=0).max(axis=1), shares.max(axis=0).min(axis=1)
        if not ((enters <= leaves) & (leaves >= 0) & (enters <= 1)).any():
            return right, bottom
    return corners[0]


def _corners(context: bpy.types.Context, unit: float, size: Size) -> list[Corner]:
    """Return places of the legend's lower right corner beside Blender's own texts and gizmos, the usual place first."""
    (left, right), (width, height), margin = _free_span(context), size, MARGIN * unit
    left, right = left + margin + width, right - margin
    if context.area.type != "VIEW_3D":
        return [(right, margin)]
    top = context.region.height - covered_above(context, context.area) - height
    return [(right, margin), (left, margin + REDO * unit), (right, top - NAVIGATION * unit), (left, top)]


def _free_span(context: bpy.types.Context) -> Span:
    """Return the columns of pixels that toolbar and sidebar do not cover."""
    covered = {"TOOLS": 0, "UI": 0}
    if context.preferences.system.use_region_overlap:
        covered |= {region.type: region.width for region in context.area.regions if region.width > 1}
    return float(covered["TOOLS"]), float(context.region.width - covered["UI"])


def _label(text: Text, size: tuple[float, float]) -> Box:
    """Return a dark background, on which a name is readable over anything."""
    (width, height), aside = size, LABEL_MARGIN * size[1]
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


class Taken:
    """The boxes of the texts that have a place."""

    def __init__(self, pieces: np.ndarray, span: Span = EVERYWHERE) -> None:
        """pieces (p,4): boxes around flat pieces (left, bottom, right, top), which names beside other pieces must not
        cover."""
        self._pieces, self._texts, self._span = pieces, np.empty((0, 4)), span

    def place(self, points: np.ndarray, size: Size) -> Corner | None:
        """Return the lower left corner of a text and reserve its place; None if there is no room. points (c,2): points
        above or below which the text may be, the best first."""
        width, height = size
        left, bottom = (
            self._within(points[:, 0], size).repeat(2),
            (points[:, 1:] + [ABOVE * height, BELOW * height]).ravel(),
        )
        return self._take(np.column_stack([left, bottom]), size, self._texts)

    def _within(self, middles: np.ndarray, size: Size) -> np.ndarray:
        """Return the left ends of texts centered on these middles. Texts whose middle is in the span are moved into
        it."""
        (width, height), (low, high) = size, self._span
        aside = LABEL_MARGIN * height
        pushed = np.clip(middles - width / 2, low + aside, max(low, high - width) - aside)
        return np.where((middles >= low) & (middles <= high), pushed, middles - width / 2)

    def place_beside(self, around: np.ndarray, size: Size) -> Corner | None:
        """Return the lower left corner of a text beside a piece, and reserve its place; None if there is no room.

        around (c,2): outermost points of the piece
        """
        (width, height), room = size, LABEL_MARGIN * size[1]
        low, high = _box(around)
        across, upward = around[:, 0] - width / 2, around[:, 1] - height / 2
        # The text is below, above, right or left of the outermost points. It is not at the middle of a side of the box,
        # because the middle may be far from a slanted piece.
        corners = [
            (across[around[:, 1] <= low[1] + SAME].mean(), low[1] - height - room),
            (across[around[:, 1] >= high[1] - SAME].mean(), high[1] + room),
            (high[0] + room, upward[around[:, 0] >= high[0] - SAME].mean()),
            (low[0] - width - room, upward[around[:, 0] <= low[0] + SAME].mean()),
        ]
        return self._take(np.array(corners), size, np.concatenate([self._texts, self._pieces]))

    def _take(self, corners: np.ndarray, size: Size, others: np.ndarray) -> Corner | None:
        """Return the first of the lower left corners (c,2) at which the text does not touch the boxes (k,4) in
        `others`, and reserve the place; None if there is no room."""
        room = LABEL_MARGIN * size[1] * (1 - 1e-9)  # so that a text right beside a piece does not touch it
        boxes = np.column_stack([corners - room, corners + size + room])
        overlap = (boxes[:, None, :2] < others[:, 2:]) & (others[:, :2] < boxes[:, None, 2:])
        free = np.flatnonzero(~np.any(np.all(overlap, axis=2), axis=1))
        if not len(free):
            return None
        self._texts = np.vstack([self._texts, boxes[free[0]]])
        left, bottom = corners[free[0]].tolist()
        return left, bottom
