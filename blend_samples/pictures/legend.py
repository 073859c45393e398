# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the legend at the bottom of a picture: kinds of lines, a scale of length, and colors."""

from __future__ import annotations

import numpy as np

from .drawing import Sheet
from .palette import FAINT_INK, INK, SEAM, stretch_colors
from .wire_kinds import WireKind

TEXT, SMALL_TEXT = 0.17, 0.16


def draw_line_key(sheet: Sheet, x: float, y: float, width: float, kinds: list[WireKind]) -> None:
    """Draw a line with its name for seams and for each kind of wire, two in a row."""
    for number, kind in enumerate((None, *kinds)):
        left, base = x + 2.3 * (number % 2), y - 0.23 * (number // 2)
        sample = [_line((left, base + 0.06), (left + 0.45, base + 0.06))]
        if kind is None:
            sheet.add_lines(sample, width, SEAM)
        else:
            sheet.add_rimmed_lines(sample, width, kind.color, kind.rim)
        sheet.add_text(kind.name if kind else "seam or edge", left + 0.57, base, TEXT, INK)


def draw_length_scale(sheet: Sheet, x: float, y: float, inches_per_meter: float) -> None:
    """Draw the longest of a few round lengths that fits into two inches."""
    meters = next(step for step in (0.5, 0.2, 0.1, 0.05, 0.02, 0.01) if step * inches_per_meter < 2)
    end = x + meters * inches_per_meter
    ticks = [_line((at, y - 0.02), (at, y + 0.14)) for at in (x, end)]
    sheet.add_lines([_line((x, y + 0.06), (end, y + 0.06)), *ticks], 0.025, INK)
    sheet.add_text(f"{1000 * meters:.0f} mm", end + 0.12, y, TEXT, INK)


def draw_color_scale(sheet: Sheet, begin: float, end: float, y: float, limit: float, largest: float) -> None:
    """Draw the colors of the values from -limit to limit with numbers. largest: the largest value in the picture."""
    steps = 128
    edges = np.linspace(begin, end, steps + 1)
    low, high = np.full(steps, y - 0.02), np.full(steps, y + 0.18)
    a, b = edges[:-1], edges[1:]
    corners = np.stack([[a, low], [b, low], [b, high], [a, low], [b, high], [a, high]]).transpose(2, 0, 1)
    corners = np.concatenate([corners, np.zeros((steps, 6, 1))], axis=-1).reshape(-1, 3, 3)
    colors = stretch_colors(limit * (2 * (np.arange(steps) + 0.5) / steps - 1), limit)
    sheet.add_triangles(corners, np.repeat(colors, 6, axis=0).reshape(-1, 3, 4))
    for share in (-1, -0.5, 0, 0.5, 1):
        x = (begin + end + share * (end - begin)) / 2
        beyond = {-1: "≤ ", 1: "≥ "}.get(share, "") if largest > limit else ""
        number = f"{100 * share * limit:+.4g}%".replace("-", "\N{MINUS SIGN}") if share else "0"
        sheet.add_text(beyond + number, x, y - 0.24, SMALL_TEXT, INK, "CENTER")
    sheet.add_text("fabric compressed", begin, y + 0.26, SMALL_TEXT, FAINT_INK)
    sheet.add_text("fabric stretched", end, y + 0.26, SMALL_TEXT, FAINT_INK, "RIGHT")


def _line(*points: tuple[float, float]) -> np.ndarray:
    return np.array([(x, y, 0.0) for x, y in points])
