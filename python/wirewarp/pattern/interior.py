# SPDX-License-Identifier: GPL-3.0-or-later
"""Room for text and grain lines inside a piece."""

import math
import unicodedata
from collections.abc import Sequence

import numpy as np

from .geometry import are_inside, lengths_along, sampled
from .model import Text

WIDE = 3.0  # room for text is sought this much wider than high
LETTER, LINE = 0.62, 1.35  # width of a letter and distance of lines, by the height of the text
WIDE_LETTER = 1.0  # of Chinese and the like, and of emoji
NEARLY = 0.6  # as high as upright: level text is easier to read
SMALL = 0.3125  # of the largest height, 2.5 of 8 mm: rather than smaller, text is written over lines
STEPS, ROUNDS = 8, 3
SAMPLES = 100  # points on the outline from which distances are measured: text need not fit to the last


def place_text(
    lines: tuple[str, ...], outlines: Sequence[np.ndarray], lines_inside: Sequence[np.ndarray], largest: float
) -> Text:
    """As large as fits, up to the height `largest`; upright where the piece is too narrow for it otherwise.

    outlines, closed, and lines_inside (k,2) are not written over; the latter only where there is no room beside them.
    """
    clear = _place(lines, outlines, lines_inside, largest)
    return clear if clear.height >= SMALL * largest else _place(lines, outlines, [], largest)


def _place(
    lines: tuple[str, ...], outlines: Sequence[np.ndarray], lines_inside: Sequence[np.ndarray], largest: float
) -> Text:
    level = _turned(lines, outlines, lines_inside, largest, 0.0)
    if level.height >= NEARLY * largest:
        return level
    upright = _turned(lines, outlines, lines_inside, largest, 90.0)
    return level if level.height >= NEARLY * upright.height else upright


def _turned(
    lines: tuple[str, ...],
    outlines: Sequence[np.ndarray],
    lines_inside: Sequence[np.ndarray],
    largest: float,
    angle: float,
) -> Text:
    cosine, sine = round(math.cos(math.radians(angle))), round(math.sin(math.radians(angle)))
    turn = np.array([[cosine, -sine], [sine, cosine]])  # from the text's directions to the piece's
    squeezed = [[points @ turn / (WIDE, 1) for points in group] for group in (outlines, lines_inside)]
    center, radius = innermost_point(*squeezed)
    half_width, half_height = max(text_width(line, 1.0) for line in lines) / (2 * WIDE), LINE * len(lines) / 2
    height = 0.9 * radius / math.hypot(half_width, half_height)  # the text's corners stay inside the ellipse
    return Text(lines, turn @ (center * (WIDE, 1)), min(height, largest), angle)


def text_width(text: str, height: float) -> float:
    """About as wide as any font has it."""
    return height * sum(WIDE_LETTER if unicodedata.east_asian_width(letter) in "FW" else LETTER for letter in text)


def innermost_point(outlines: Sequence[np.ndarray], lines_inside: Sequence[np.ndarray]) -> tuple[np.ndarray, float]:
    """About the point (2,) inside closed outlines (k,2) that is farthest from all lines, and its distance."""
    closed = [np.concatenate([outline, outline[:1]]) for outline in outlines]
    spacing = sum(float(lengths_along(outline)[-1]) for outline in closed) / SAMPLES
    around = [sampled(outline, spacing) for outline in closed]
    obstacles = np.concatenate([*around, *(sampled(line, spacing) for line in lines_inside)])
    low, high = np.concatenate(around).min(axis=0), np.concatenate(around).max(axis=0)
    center, reach = (low + high) / 2, (high - low) / 2
    best = -math.inf
    for _ in range(ROUNDS):
        offsets = np.linspace(-1, 1, STEPS + 1)
        x, y = np.meshgrid(center[0] + reach[0] * offsets, center[1] + reach[1] * offsets)
        points = np.column_stack([x.ravel(), y.ravel()])
        points = points[are_inside(points, around)]
        if len(points):
            depths = _distances(points, obstacles)
            if depths.max() > best:
                best, center = float(depths.max()), points[np.argmax(depths)]
        reach = reach * 3 / STEPS
    return center, math.sqrt(max(best**2 - (spacing / 2) ** 2, 0.0))  # between two samples the line may be nearer


def _distances(points: np.ndarray, obstacles: np.ndarray) -> np.ndarray:
    """(p,) of points (p,2) from the nearest of the obstacles (o,2)."""
    x, y = (points[:, axis, None] - obstacles[:, axis] for axis in (0, 1))
    return np.sqrt((x * x + y * y).min(axis=1))
