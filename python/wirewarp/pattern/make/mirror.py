# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds reflections and rotations that map one piece to another, or to itself."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..geometry import distances_to
from ..model import PatternPiece

# A unit vector with at most this rise counts as level. Rounding must not decide which half is drawn if a fold is level.
LEVEL = 1e-9
ALIKE = 0.1  # millimeters: largest distance between matching points, less than the width of a printed line
IN_PHASE = 1e-3  # share by which a match may be worse than the best match, because a piece may have several axes


@dataclass(frozen=True)
class Congruence:
    """A reflection or a rotation of points, which are complex numbers.

    A reflection is z -> turn * conj(z) + shift, and may also shift along its axis. A rotation is z -> turn * z + shift.
    """

    turn: complex
    shift: complex
    is_mirror: bool = True
    deviation: float = 0.0  # millimeters: largest distance between an image and the point that it should match

    @property
    def axis(self) -> tuple[np.ndarray, np.ndarray]:
        """Return a point (2,) of the axis of a reflection, and the direction (2,) of the axis."""
        along = np.sqrt(self.turn)
        point = self.shift / 2
        return np.array([point.real, point.imag]), np.array([along.real, along.imag])

    def direction(self, vector: np.ndarray) -> np.ndarray:
        """Return the image of a vector (2,), without the shift."""
        image = self.turn * complex(vector[0], -vector[1] if self.is_mirror else vector[1])
        return np.array([image.real, image.imag])

    def image(self, points: np.ndarray) -> np.ndarray:
        numbers = points @ (1, 1j)
        images = self.turn * (np.conj(numbers) if self.is_mirror else numbers) + self.shift
        return np.column_stack([images.real, images.imag])

    def of_outline(self, points: np.ndarray) -> np.ndarray:
        """Return the images of points (k,2) along an outline. A reflection also reverses their order, so that the piece
        stays on the left."""
        return self.image(points[::-1] if self.is_mirror else points)


def congruences(first: PatternPiece, second: PatternPiece, *, is_mirror: bool) -> Iterator[Congruence]:
    """Yield the reflections or rotations that map the second piece to the first, within ALIKE.

    The first reflection has the most upright axis, and the first rotation has the smallest angle. Outlines must have
    equal numbers of points.
    """
    outlines = [_outline_loops(piece) for piece in (first, second)]
    if not outlines[0] or [len(loop) for loop in outlines[0]] != [len(loop) for loop in outlines[1]]:
        return
    outer, image = outlines[0][0] @ (1, 1j), outlines[1][0] @ (1, 1j)
    if is_mirror:
        image = np.conj(image[::-1])
    steps, turned = np.roll(outer, -1) - outer, np.roll(image, -1) - image
    if abs(np.abs(steps).sum() - np.abs(turned).sum()) > ALIKE:
        return
    # Entry i of match correlates the steps of the first outline with the steps of the image, shifted by i rows. At the
    # largest entries, the outlines match, and the angles of these entries are the turns.
    match = np.fft.ifft(np.fft.fft(steps) * np.conj(np.fft.fft(turned)))
    best = np.flatnonzero(np.abs(match) >= (1 - IN_PHASE) * np.abs(match).max(initial=np.finfo(float).tiny))
    # Reflections are sorted by closeness to the turn -1 (a vertical axis), and rotations by closeness to 1 (no
    # rotation).
    sign = 1 if is_mirror else -1
    for phase in sorted(best.tolist(), key=lambda phase: round(sign * float(match[phase].real / abs(match[phase])), 6)):
        turn = complex(match[phase] / abs(match[phase]))
        shift = complex((outer - turn * np.roll(image, phase)).mean())
        deviation = float(np.abs(outer - turn * np.roll(image, phase) - shift).max())
        found = Congruence(turn, shift, is_mirror, deviation)
        if found.deviation <= ALIKE and _rest_fits(found, outlines, first, second):
            yield found


def fold_of(piece: PatternPiece, mirror: Congruence) -> np.ndarray | None:
    """Return the upward line (2,2) along which the piece can be folded onto itself. Return None if the reflection also
    shifts along its axis, or if the axis does not cross the piece."""
    point, along = mirror.axis
    if abs((mirror.shift * np.conj(np.sqrt(mirror.turn))).real) > ALIKE:
        return None
    is_upwards = along[1] > LEVEL or (along[1] > -LEVEL and along[0] > 0)
    along = along if is_upwards else -along
    crossings = _crossings(piece, point, along)
    return point + np.outer([crossings.min(), crossings.max()], along) if len(crossings) > 1 else None


def _outline_loops(piece: PatternPiece) -> list[np.ndarray]:
    """Return the closed outlines (k,2) that the stitching lines of a piece form."""
    loops: list[list[np.ndarray]] = []
    is_open = False
    for line in piece.of_role("sew"):
        if not is_open:
            loops.append([])
        loops[-1].append(line.points if line.closed else line.points[:-1])
        is_open = not line.closed and not np.array_equal(line.points[-1], loops[-1][0][0])
    return [np.concatenate(loop) for loop in loops]


def _rest_fits(found: Congruence, outlines: list[list[np.ndarray]], first: PatternPiece, second: PatternPiece) -> bool:
    """Return whether holes, cutting lines and wires match within ALIKE. outlines: outlines of both pieces."""
    if not _covers(outlines[0][1:], [found.image(loop) for loop in outlines[1][1:]]):
        return False
    kinds = {("cut", ""), ("inner_cut", ""), *(("wire", line.kind) for line in first.lines + second.lines)}
    for role, kind in kinds:
        own, others = ([line.points for line in piece.of_role(role) if line.kind == kind] for piece in (first, second))
        if not _covers(own, [found.image(line) for line in others]):
            return False
    return True


def _covers(lines: list[np.ndarray], others: list[np.ndarray]) -> bool:
    """Return whether each point of the lines is within ALIKE of the other lines, and the reverse."""
    if not lines or not others:
        return not lines and not others
    pairs = ((lines, others), (others, lines))
    return all(float(distances_to(np.concatenate(a), b).max()) <= ALIKE for a, b in pairs)


def _crossings(piece: PatternPiece, point: np.ndarray, along: np.ndarray) -> np.ndarray:
    """Return the lengths (n,) along a line, from `point` on this line to the places where it crosses the cutting
    lines."""
    aside = np.array([-along[1], along[0]])
    found = []
    for line in piece.of_role("cut"):
        a, b = line.points - point, np.roll(line.points, -1, axis=0) - point
        start, end = a @ aside, b @ aside
        for row in np.flatnonzero((start < 0) != (end < 0)):
            share = start[row] / (start[row] - end[row])
            found.append(float((a[row] + share * (b[row] - a[row])) @ along))
    return np.array([each for each in found if math.isfinite(each)])
