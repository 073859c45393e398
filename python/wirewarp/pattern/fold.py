# SPDX-License-Identifier: GPL-3.0-or-later
"""Half of a symmetric piece, to be cut on the fold of the cloth."""

from dataclasses import replace

import numpy as np

from .model import Line, PatternPiece

ON_FOLD = 0.05  # millimeters: what lies so near to the fold is on it


def folded(piece: PatternPiece, fold: np.ndarray) -> PatternPiece:
    """What lies on the right of the fold (2,2), which is not cut; lines end at it."""
    along = (fold[1] - fold[0]) / np.linalg.norm(fold[1] - fold[0])
    outward = np.array([along[1], -along[0]])
    lines = [Line("fold", fold)]
    for line in piece.lines:
        if line.role != "grain":
            lines += [replace(line, points=part, closed=closed) for part, closed in _kept(line, fold[0], outward)]
    middle = fold.mean(axis=0)
    lines.append(Line("grain", middle + 0.7 * (fold - middle) + 15.0 * outward))
    points = [point for point in piece.points if (point.at - fold[0]) @ outward > -ON_FOLD]
    return replace(piece, lines=lines, points=points, texts=[], on_fold=True)


def _kept(line: Line, origin: np.ndarray, outward: np.ndarray) -> list[tuple[np.ndarray, bool]]:
    """The parts of a line on the outward side."""
    points = np.concatenate([line.points, line.points[:1]]) if line.closed else line.points
    height = (points - origin) @ outward
    if np.all(height > ON_FOLD):
        return [(line.points, line.closed)]
    if np.all(np.abs(height) <= ON_FOLD):  # a wire along the fold
        return [(line.points, line.closed)]
    height[np.abs(height) <= ON_FOLD] = 0.0
    parts: list[list[np.ndarray]] = [[]]
    for row in range(len(points)):
        if height[row] >= 0:
            parts[-1].append(points[row])
        if row + 1 < len(points) and (height[row] >= 0) != (height[row + 1] >= 0):
            share = height[row] / (height[row] - height[row + 1])
            parts[-1].append(points[row] + share * (points[row + 1] - points[row]))
            if height[row] >= 0:
                parts.append([])
    if line.closed and len(parts) > 1 and height[0] >= 0:  # it began in the middle of a part
        parts[0] = parts.pop() + parts[0][1:]
    kept = [np.array(part) for part in parts if len(part) > 1]
    return [(part, False) for part in kept if ((part - origin) @ outward).max() > ON_FOLD]
