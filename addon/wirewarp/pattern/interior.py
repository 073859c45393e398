# SPDX-License-Identifier: GPL-3.0-or-later
"""Room for text inside an outline."""

import math

import numpy as np

from ..polygons import AT_ONCE, Segments, are_inside
from .pattern import PieceText

WIDE = 3.0  # room for text is sought this much wider than high
LETTER, LINE = 0.62, 1.35  # width of a letter and distance of lines, by the height of the text
SMALL = 0.4  # of the largest height: rather than smaller, text is written over lines
STEPS, ROUNDS = 24, 5


def place_text(
    lines: tuple[str, ...], outlines: list[np.ndarray], lines_inside: list[np.ndarray], largest: float
) -> PieceText:
    """As large as fits, up to the height `largest`; upright where the piece is too narrow for it otherwise.

    outlines, closed, and lines_inside (k,2) are not written over; the latter only where there is no room beside them.
    """
    clear = _place(lines, outlines, lines_inside, largest)
    return clear if clear.height >= SMALL * largest else _place(lines, outlines, [], largest)


def _place(
    lines: tuple[str, ...], outlines: list[np.ndarray], lines_inside: list[np.ndarray], largest: float
) -> PieceText:
    candidates = [_turned(lines, outlines, lines_inside, largest, angle) for angle in (0.0, 90.0)]
    return max(candidates, key=lambda text: text.height)


def _turned(
    lines: tuple[str, ...], outlines: list[np.ndarray], lines_inside: list[np.ndarray], largest: float, angle: float
) -> PieceText:
    cosine, sine = round(math.cos(math.radians(angle))), round(math.sin(math.radians(angle)))
    turn = np.array([[cosine, -sine], [sine, cosine]])  # from the text's directions to the piece's
    squeezed = [[points @ turn / (WIDE, 1) for points in group] for group in (outlines, lines_inside)]
    center, radius = innermost_point(*squeezed)
    half_width, half_height = LETTER * max(map(len, lines)) / (2 * WIDE), LINE * len(lines) / 2
    height = 0.9 * radius / math.hypot(half_width, half_height)  # the text's corners stay inside the ellipse
    return PieceText(lines, turn @ (center * (WIDE, 1)), min(height, largest), angle)


def innermost_point(outlines: list[np.ndarray], lines_inside: list[np.ndarray]) -> tuple[np.ndarray, float]:
    """About the point (2,) inside closed outlines (k,2) that is farthest from all lines, and its distance."""
    closed = [np.concatenate([outline, outline[:1]]) for outline in outlines]
    outline, inside = _segments(closed), _segments(lines_inside)
    low, high = outline.box
    center, reach = (low + high) / 2, (high - low) / 2
    best = -math.inf
    for _ in range(ROUNDS):
        offsets = np.linspace(-1, 1, STEPS + 1)
        x, y = np.meshgrid(center[0] + reach[0] * offsets, center[1] + reach[1] * offsets)
        points = np.column_stack([x.ravel(), y.ravel()])
        depths = np.minimum(_depths(points, outline), _distances(points, inside))
        if depths.max() > best:
            best, center = float(depths.max()), points[np.argmax(depths)]
        reach = reach * 3 / STEPS
    return center, best


def _segments(lines: list[np.ndarray]) -> Segments:
    """Of lines (k,2) from point to point."""
    nothing = np.empty((0, 2))
    starts, ends = [line[:-1] for line in lines], [line[1:] for line in lines]
    return Segments(np.concatenate([nothing, *starts]), np.concatenate([nothing, *ends]))


def _depths(points: np.ndarray, outline: Segments) -> np.ndarray:
    """(p,) the distance of points (p,2) from the nearest segment; negative outside of the outline."""
    nearest = _distances(points, outline)
    return np.where(are_inside(points, outline), nearest, -nearest)


def _distances(points: np.ndarray, segments: Segments) -> np.ndarray:
    nearest = np.full(len(points), np.inf)
    step = AT_ONCE // len(points)
    for start in range(0, len(segments.a), step):
        a, b = (ends[start : start + step] for ends in segments)
        along, to = b - a, points[:, None] - a
        share = np.clip((to * along).sum(axis=2) / np.maximum((along**2).sum(axis=1), np.finfo(float).tiny), 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(to - share[..., None] * along, axis=2).min(axis=1))
    return nearest
