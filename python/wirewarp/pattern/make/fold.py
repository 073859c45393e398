# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a half from a piece that is cut on the fold, and opens a half to the whole piece."""

import math
from dataclasses import replace

import numpy as np

from ..checks import problem
from ..geometry import Motion
from ..grain import GRAIN, grain_line
from ..model import Line, PatternPiece
from .pieces import FOLD_NAME

ON_FOLD = 0.05  # millimeters; a point nearer to the fold is on the fold
BESIDE_FOLD = 15.0  # millimeters between the fold and a grain arrow along it
# A grain at a smaller angle to the fold counts as parallel, because nobody aligns fabric better. This is the sine of
# the angle.
ALONG = math.sin(math.radians(0.5))


def folded(piece: PatternPiece, fold: np.ndarray) -> PatternPiece:
    """Return the half of the piece to the right of the fold (2,2). Lines end at the fold, and the fold is not cut."""
    along = (fold[1] - fold[0]) / np.linalg.norm(fold[1] - fold[0])
    outward = np.array([along[1], -along[0]])
    lines = [Line("fold", fold, name=FOLD_NAME)]
    for line in piece.lines:
        if line.role == "grain":
            lines.append(_grain(piece, line, fold, outward))
        else:
            lines += [replace(line, points=part, closed=closed) for part, closed in _kept(line, fold[0], outward)]
    points = [point for point in piece.points if (point.at - fold[0]) @ outward > -ON_FOLD]
    return replace(piece, lines=lines, points=points, texts=[], on_fold=True)


def _grain(piece: PatternPiece, grain: Line, fold: np.ndarray, outward: np.ndarray) -> Line:
    """Return the grain arrow. If the grain is parallel to the fold, the arrow is beside the fold, otherwise it is where
    the half has most room."""
    along = (grain.points[1] - grain.points[0]) / np.linalg.norm(grain.points[1] - grain.points[0])
    if abs(along @ outward) < ALONG:
        middle = fold.mean(axis=0)
        return Line("grain", middle + GRAIN * (fold - middle) + BESIDE_FOLD * outward)
    halves = [part for line in piece.of_role("cut") for part, _ in _kept(line, fold[0], outward)]
    return grain_line(halves, [], along)


def _kept(line: Line, origin: np.ndarray, outward: np.ndarray) -> list[tuple[np.ndarray, bool]]:
    """Return the parts of a line on the side of the fold to which `outward` points, and whether each is closed.

    origin (2,): a point of the fold; outward (2,): unit vector square to the fold.
    """
    points = line.path
    height = (points - origin) @ outward
    is_along_fold = np.all(np.abs(height) <= ON_FOLD)  # true for a wire along the fold
    if is_along_fold or np.all(height > ON_FOLD):
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
    if line.closed and len(parts) > 1 and height[0] >= 0:  # true if the line begins in the middle of a part
        parts[0] = parts.pop() + parts[0][1:]
    kept = [np.array(part) for part in parts if part]
    return [(part, False) for part in kept if ((part - origin) @ outward).max() > ON_FOLD]


def unfolded(piece: PatternPiece) -> PatternPiece:
    """Return the whole of a piece that is cut on the fold, without the fold line. Texts keep their places.

    Raises FlattenError if the piece has several folds or none.
    """
    folds = piece.of_role("fold")
    if len(folds) != 1:
        raise problem(f'"{piece.name}" has {len(folds)} folds, but only a piece with one fold can be opened.')
    start, end = folds[0].points[0], folds[0].points[-1]
    along = (end - start) / np.linalg.norm(end - start)
    normal = np.array([along[1], -along[0]])
    (cut,) = piece.of_role("cut")
    # The motion mirrors at the y axis, turns, and shifts, so that the fold is mapped to itself.
    turn = Motion(np.zeros(2), float(np.degrees(2 * np.arctan2(normal[1], normal[0]))), mirrored=True)
    image = Motion(start - turn.points(start), turn.angle, mirrored=True)
    half = cut.points
    if cut.closed:
        crooked = float(np.abs((folds[0].points - start) @ normal).max())
        half = _without_fold(cut.points, np.abs((cut.points - start) @ normal) <= crooked + ON_FOLD)
    whole = np.concatenate([half, image.points(half)[-2:0:-1]])
    lines = [replace(cut, points=whole, closed=True)]
    for line in piece.lines:
        if line.role == "grain":
            lines.append(line)
        elif line.role not in ("cut", "fold"):
            is_on_fold = np.abs((line.points - start) @ normal).max() <= ON_FOLD
            # The image is reversed, so that the piece is to the left of the line. The name of a line is on this side.
            lines += [line] if is_on_fold else [line, replace(line, points=image.points(line.points)[::-1])]
    points = []
    for point in piece.points:
        is_on_fold = abs((point.at - start) @ normal) <= ON_FOLD
        points += [point] if is_on_fold else [point, point.placed(image)]
    return replace(piece, lines=lines, points=points, on_fold=False)


def _without_fold(outline: np.ndarray, is_on_fold: np.ndarray) -> np.ndarray:
    """Return a closed line (k,2) as an open line without its part along the fold. The line must have exactly one such
    part."""
    first = int(np.flatnonzero(is_on_fold & ~np.roll(is_on_fold, -1))[0])  # row at which the outline leaves the fold
    turned, is_on_fold = np.roll(outline, -first, axis=0), np.roll(is_on_fold, -first)
    return turned[: int(np.flatnonzero(is_on_fold[1:])[0]) + 2]
