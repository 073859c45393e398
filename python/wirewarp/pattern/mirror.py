# SPDX-License-Identifier: GPL-3.0-or-later
"""Mirror images among pieces, found by their outlines alone: lengths are exact, so mirror images fit to rounding."""

import math
from dataclasses import dataclass

import numpy as np

from .geometry import distances_to
from .model import PatternPiece

ALIKE = 0.1  # millimeters between a point and the image of its twin: less than a line is wide


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
    """The closed outlines (k,2) that the sew lines of a piece form, one after the other."""
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
    along = along if along[1] > 0 or (along[1] == 0 and along[0] > 0) else -along
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
