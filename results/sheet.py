# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws a picture of the model, and below it a column for each flattening and a row for each map, at one scale."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from textwrap import fill

import matplotlib.pyplot as plt
import numpy as np
import wirewarp
from arrange import arrange
from maps import Map, draw_piece, draw_scale, scale_of
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from measures import summarize
from model_view import draw_model, frame
from palette import ELASTIC, FAINT_INK, INK, RIGID, TURNED_OVER, percent
from save_picture import save
from shapes import Shape

# inches; if a picture of this width fills the page of the site, text of 8 points is readable
PAGE_WIDTH = 9.0
MODEL_WIDTH, MODEL_HEIGHT, KEY_WIDTH, SCALE_WIDTH = 2.8, 2.4, 1.4, 1.15
TITLE_MARGIN, TITLE_LINE, FOOT_HEIGHT = 0.23, 0.17, 0.55
WIDEST_CELL = 2.7
LEAST_ROW = 1.2  # least height of a row, so that the title of a scale has room
LETTERS = 13  # number of letters of a title in an inch


@dataclass(frozen=True)
class Column:
    """A flattening and the text above it."""

    title: str
    shape: Shape  # with the tolerances of the flattening
    result: wirewarp.FlattenResult


def draw_sheet(
    path: Path,
    columns: Sequence[Column],
    maps: Sequence[Map],
    view: tuple[float, float],
    aspect: float = 1.0,
    label_wires: bool = False,
) -> None:
    """Draw the picture.

    view: rotation and tilt of the model in degrees; aspect: preferred width over height of a flattening; label_wires:
    write the change of length at each wire, for surfaces of one piece.
    """
    results = [column.result for column in columns]
    arrangement = arrange(columns[-1].shape.vertices, results, aspect)
    cell_width = min((PAGE_WIDTH - SCALE_WIDTH) / len(columns), WIDEST_CELL)
    cell_height = cell_width * arrangement.size[1] / arrangement.size[0]
    letters = round(LETTERS * cell_width)
    titles = ["\n".join(fill(line, letters) for line in column.title.split("\n")) for column in columns]
    title_height = TITLE_MARGIN + TITLE_LINE * max(title.count("\n") + 1 for title in titles)
    row_height = max(cell_height, LEAST_ROW)
    top = FOOT_HEIGHT + len(maps) * row_height  # upper edge of the maps
    size = np.array([len(columns) * cell_width + SCALE_WIDTH, top + title_height + MODEL_HEIGHT])
    figure = plt.figure(figsize=size)

    def panel(x: float, y: float, width: float, height: float) -> Axes:
        """Return axes of this size at this place, in inches from the lower left corner."""
        return figure.add_axes((x / size[0], y / size[1], width / size[0], height / size[1]))

    left = (len(columns) * cell_width - MODEL_WIDTH - KEY_WIDTH) / 2  # model and key are above the middle of the maps
    model = panel(left, size[1] - MODEL_HEIGHT + 0.1, MODEL_WIDTH, MODEL_HEIGHT - 0.2)
    draw_model(model, columns[-1].shape, *view)
    _draw_key(figure, columns, (left + MODEL_WIDTH) / size[0], 1 - MODEL_HEIGHT / 2 / size[1])
    for row, quantity in enumerate(maps):
        scale = scale_of(quantity, columns[-1].shape, results)
        y = top - (row + 1) * row_height
        for k, column in enumerate(columns):
            axes = panel(k * cell_width, y + (row_height - cell_height) / 2, cell_width, cell_height)
            positions = arrangement.positions(k)
            for piece, uv in zip(column.result.pieces, positions, strict=True):
                draw_piece(axes, quantity, scale, column.shape, piece, uv)
            frame(axes, np.zeros(2), arrangement.size)
            if label_wires and row == 0:
                _label_wires(axes, column, positions[0])
        bar = panel(size[0] - SCALE_WIDTH + 0.15, y + 0.06 * row_height, 0.13, 0.88 * row_height)
        draw_scale(bar, quantity, scale, _exceeds(quantity, scale, columns))
    for k, column in enumerate(columns):
        middle = (k + 0.5) * cell_width / size[0]
        figure.text(middle, (top + title_height - 0.12) / size[1], titles[k], ha="center", va="top", fontsize=10)
        figure.text(middle, (FOOT_HEIGHT - 0.05) / size[1], _summary(column), ha="center", va="top", fontsize=8)
    save(figure, path)


def _exceeds(quantity: Map, scale: plt.Normalize, columns: Sequence[Column]) -> bool:
    values = [quantity.values(c.shape, piece) for c in columns for piece in c.result.pieces]
    return bool(max(np.abs(v - quantity.base).max() for v in values) > scale.vmax - quantity.base)


def _label_wires(axes: Axes, column: Column, uv: np.ndarray) -> None:
    """Write the change of length on each wire, at the place farthest from other wires and earlier labels."""
    piece = column.result.pieces[0]
    of_source = {int(v): k for k, v in enumerate(piece.source_vertex)}
    lines = [uv[[of_source[vertex] for vertex in wire.vertices]] for wire in column.shape.wires]
    labels = np.empty((0, 2))
    for index, report in enumerate(column.result.wires):
        count = len(lines[index])
        # no labels at the ends, which are on outlines
        inner = lines[index][round(0.15 * count) : max(round(0.85 * count), 1)]
        taken = np.concatenate([labels, *lines[:index], *lines[index + 1 :]])
        gaps = np.linalg.norm(inner[:, None] - taken, axis=2).min(axis=1, initial=np.inf)
        place = inner[np.argmax(gaps)] if len(taken) else inner[len(inner) // 2]
        labels = np.concatenate([labels, [place]])
        text = percent(report.length_2d / report.length_3d - 1)
        box = {"boxstyle": "round,pad=0.2", "facecolor": "white", "edgecolor": FAINT_INK, "linewidth": 0.5}
        axes.text(*place, text, fontsize=8, ha="center", va="center", bbox=box, zorder=5)


def _summary(column: Column) -> str:
    found = summarize(column.shape.vertices, column.result)
    return (
        f"$E$ {found.energy:.4f}   flipped: {found.flipped}\n"
        f"$E_r$ mean {found.mean_aspect_ratio:.3f}, max {found.max_aspect_ratio:.2f}\n"
        f"$E_A$ max {found.max_face_energy:.3g}"
    )


def _draw_key(figure: Figure, columns: Sequence[Column], x: float, y: float) -> None:
    """Draw the key of lines beside the model. x, y: middle of its left side, as fractions of the figure."""
    wires = columns[-1].shape.wires
    handles = [Line2D([], [], color=INK, linewidth=1.0, label="outline or seam")]
    if any(wire.tolerance == 0 for wire in wires):
        handles.append(Line2D([], [], color=RIGID, linewidth=2.2, label="rigid wire"))
    if any(wire.tolerance > 0 for wire in wires):
        handles.append(Line2D([], [], color=ELASTIC, linewidth=2.2, label="elastic wire"))
    if any(len(p.metrics.flipped_faces) for c in columns for p in c.result.pieces):
        handles.append(Patch(color=TURNED_OVER, label="flipped"))
    figure.legend(handles=handles, loc="center left", bbox_to_anchor=(x, y), fontsize=8, frameon=False)
