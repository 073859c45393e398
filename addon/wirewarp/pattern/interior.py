# SPDX-License-Identifier: GPL-3.0-or-later
"""Room for text inside an outline."""

import math

import numpy as np

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
    a, b = (np.concatenate([points[side] for points in closed]) for side in (slice(-1), slice(1, None)))
    low, high = a.min(axis=0), a.max(axis=0)
    center, reach = (low + high) / 2, (high - low) / 2
    best = -math.inf
    for _ in range(ROUNDS):
        offsets = np.linspace(-1, 1, STEPS + 1)
        x, y = np.meshgrid(center[0] + reach[0] * offsets, center[1] + reach[1] * offsets)
        points = np.column_stack([x.ravel(), y.ravel()])
        depths = _depths(points, a, b)
        for line in lines_inside:
            depths = np.minimum(depths, np.abs(_depths(points, line[:-1], line[1:])))
        if depths.max() > best:
            best, center = float(depths.max()), points[np.argmax(depths)]
        reach = reach * 3 / STEPS
    return center, best


def _depths(points: np.ndarray, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """(p,) the distance of points (p,2) from the nearest of the segments a to b (s,2); negative outside of them."""
    nearest = np.full(len(points), np.inf)
    inside = np.zeros(len(points), dtype=bool)
    for start in range(0, len(a), 512):  # not all at once, for memory's sake
        p, q = a[start : start + 512], b[start : start + 512]
        along, to = q - p, points[:, None] - p
        share = np.clip((to * along).sum(axis=2) / np.maximum((along**2).sum(axis=1), np.finfo(float).tiny), 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(to - share[..., None] * along, axis=2).min(axis=1))
        crosses = (p[:, 1] > points[:, 1:]) != (q[:, 1] > points[:, 1:])
        with np.errstate(divide="ignore", invalid="ignore"):
            at = p[:, 0] + (points[:, 1:] - p[:, 1]) / along[:, 1] * along[:, 0]
        inside ^= (crosses & (points[:, :1] < at)).sum(axis=1) % 2 == 1
    return np.where(inside, nearest, -nearest)
