# SPDX-License-Identifier: GPL-3.0-or-later
"""Mirrored pairs and symmetric pieces: how they are found, and half of a piece that is cut on the fold."""

import math
from dataclasses import dataclass, replace

import numpy as np

from ..checks import problem
from ..geometry import Motion, distances_to
from ..model import Line, PatternPiece

LEVEL = 1e-9  # rise of a unit vector: rounding must not say which half of a piece with a level fold is drawn
ALIKE = 0.1  # millimeters between a point and its mirror image: less than a line is wide


@dataclass(frozen=True)
class Mirror:
    """z -> turn * conj(z) + shift, a reflection, maybe with a shift along its axis; points as complex numbers."""

    turn: complex
    shift: complex

    @property
    def axis(self) -> tuple[np.ndarray, np.ndarray]:
        """A point (2,) of the axis and its direction (2,)."""
        along = np.sqrt(self.turn)
        point = self.shift / 2
        return np.array([point.real, point.imag]), np.array([along.real, along.imag])


def outline_loops(piece: PatternPiece) -> list[np.ndarray]:
    """The closed outlines (k,2) that the stitching lines of a piece form, one after the other."""
    loops: list[list[np.ndarray]] = []
    is_open = False
    for line in piece.of_role("sew"):
        if not is_open:
            loops.append([])
        loops[-1].append(line.points if line.closed else line.points[:-1])
        is_open = not line.closed and not np.array_equal(line.points[-1], loops[-1][0][0])
    return [np.concatenate(loop) for loop in loops]


def mirror_between(first: PatternPiece, second: PatternPiece) -> Mirror | None:
    """What maps the outline of the second onto that of the first; None where no reflection does."""
    outlines = [outline_loops(piece) for piece in (first, second)]
    if [len(loop) for loop in outlines[0]] != [len(loop) for loop in outlines[1]]:
        return None
    onto, own = (np.concatenate([loop @ (1, 1j) for loop in loops]) for loops in outlines)
    outer, image = outlines[0][0] @ (1, 1j), np.conj(outlines[1][0][::-1] @ (1, 1j))
    steps, turned = np.roll(outer, -1) - outer, np.roll(image, -1) - image
    if abs(np.abs(steps).sum() - np.abs(turned).sum()) > ALIKE:
        return None
    # The sum of steps times conjugate steps is largest, and its angle that of the turn, where they are in phase.
    match = np.fft.ifft(np.fft.fft(steps) * np.conj(np.fft.fft(turned)))
    best = int(np.argmax(np.abs(match)))
    if abs(match[best]) == 0:
        return None
    turn = complex(match[best] / abs(match[best]))
    shift = complex((outer - turn * np.roll(image, best)).mean())
    found = Mirror(turn, shift)
    gaps = np.abs(outer - turn * np.roll(image, best) - shift)
    rest = turn * np.conj(own) + shift
    holes_fit = len(outlines[0]) == 1 or _covers(rest, onto)
    return found if gaps.max() <= ALIKE and holes_fit and _cut_lines_fit(found, first, second) else None


def _cut_lines_fit(mirror: Mirror, first: PatternPiece, second: PatternPiece) -> bool:
    """Allowances may differ where outlines do not."""
    own, others = ([line.points for line in piece.of_role("cut", "inner_cut")] for piece in (first, second))
    images = [mirror.turn * np.conj(line @ (1, 1j)) + mirror.shift for line in others]
    turned = [np.column_stack([image.real, image.imag]) for image in images]
    gaps = [distances_to(np.concatenate(points), lines).max() for lines, points in ((own, turned), (turned, own))]
    return bool(max(gaps) <= ALIKE)


def _covers(points: np.ndarray, others: np.ndarray) -> bool:
    """Whether each point has one of the others beside it."""
    return all(float(np.abs(others - point).min()) <= ALIKE for point in points)


def fold_of(piece: PatternPiece) -> np.ndarray | None:
    """(2,2) the line, upwards, on which a piece can be folded onto itself; None where it is not symmetric."""
    mirror = mirror_between(piece, piece)
    if mirror is None:
        return None
    point, along = mirror.axis
    if abs((mirror.shift * np.conj(np.sqrt(mirror.turn))).real) > ALIKE:  # it also slides along its axis
        return None
    is_upwards = along[1] > LEVEL or (along[1] > -LEVEL and along[0] > 0)
    along = along if is_upwards else -along
    crossings = _crossings(piece, point, along)
    return point + np.outer([crossings.min(), crossings.max()], along) if len(crossings) > 1 else None


def _crossings(piece: PatternPiece, point: np.ndarray, along: np.ndarray) -> np.ndarray:
    """Where the line through the point crosses the cut line, as lengths along it."""
    aside = np.array([-along[1], along[0]])
    found = []
    for line in piece.of_role("cut"):
        a, b = line.points - point, np.roll(line.points, -1, axis=0) - point
        start, end = a @ aside, b @ aside
        for row in np.flatnonzero((start < 0) != (end < 0)):
            share = start[row] / (start[row] - end[row])
            found.append(float((a[row] + share * (b[row] - a[row])) @ along))
    return np.array([each for each in found if math.isfinite(each)])


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


def unfolded(piece: PatternPiece) -> PatternPiece:
    """The whole of a piece that is cut on the fold. Raises FlattenError if it has several folds.

    The fold is taken to be straight from end to end; texts stay where they are, and the fold itself is left out.
    """
    folds = piece.of_role("fold")
    if len(folds) != 1:
        raise problem(f'"{piece.name}" has {len(folds)} folds, and only a piece with one can be opened.')
    start, end = folds[0].points[0], folds[0].points[-1]
    along = (end - start) / np.linalg.norm(end - start)
    outward = np.array([along[1], -along[0]])
    (cut,) = piece.of_role("cut")
    if (cut.points.mean(axis=0) - start) @ outward < 0:
        outward = -outward
    # Mirrored in the y axis, turned, and moved so that the fold stays where it is.
    turn = Motion(np.zeros(2), float(np.degrees(2 * np.arctan2(outward[1], outward[0]))), mirrored=True)
    image = Motion(start - turn.points(start), turn.angle, mirrored=True)
    half = cut.points
    if cut.closed:
        crooked = float(np.abs((folds[0].points - start) @ outward).max())
        half = _without_fold(cut.points, np.abs((cut.points - start) @ outward) <= crooked + ON_FOLD)
    whole = np.concatenate([half, image.points(half)[-2:0:-1]])
    lines = [replace(cut, points=whole, closed=True)]
    for line in piece.lines:
        if line.role == "grain":
            lines.append(line)
        elif line.role not in ("cut", "fold"):
            is_on_fold = np.abs((line.points - start) @ outward).max() <= ON_FOLD
            # Turned round, for names stand on the left of a line, where the piece is.
            lines += [line] if is_on_fold else [line, replace(line, points=image.points(line.points)[::-1])]
    points = []
    for point in piece.points:
        is_on_fold = abs((point.at - start) @ outward) <= ON_FOLD
        points += [point] if is_on_fold else [point, point.placed(image)]
    return replace(piece, lines=lines, points=points, on_fold=False)


def _without_fold(outline: np.ndarray, is_on_fold: np.ndarray) -> np.ndarray:
    """The open line that is left of a closed one (k,2) without its one part along the fold."""
    first = int(np.flatnonzero(is_on_fold & ~np.roll(is_on_fold, -1))[0])  # where the outline leaves the fold
    turned, is_on_fold = np.roll(outline, -first, axis=0), np.roll(is_on_fold, -first)
    return turned[: int(np.flatnonzero(is_on_fold[1:])[0]) + 2]
