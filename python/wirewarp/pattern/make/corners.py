# SPDX-License-Identifier: GPL-3.0-or-later
"""The cut line around a corner of the outline, between the allowances of the two sections that meet there.

The corner's point is the origin. The first section arrives along +x with the piece above it, and the outline turns left
by `turn`, between 0 and pi. The first allowance, `a` wide, is cut along y = -a. The second, `b` wide, continues in the
direction (cos turn, sin turn). A path leads from one cut line to the other.
"""

import math
from collections.abc import Callable
from typing import Literal, get_args

import numpy as np

CornerType = Literal["mitre", "right angle", "fold-back", "extend", "step", "round"]
CORNER_TYPES: tuple[str, ...] = get_args(CornerType)
MITRE_LIMIT = 2.5  # multiple of the width; a corner that extends farther is cut off square
STRAIGHT = 1e-7  # radians; at a smaller turn, the wedge between even the widest strips is finer than the grid
SHARP = math.radians(30)  # a smaller turn can hardly be seen on fabric, and its allowance needs no end of its own
# multiple of the larger width; if the difference of widths over the sine of the turn is larger, mitres become steps
STEEP = 1.5
SAGITTA = 0.02  # millimeters, of the chords of a round corner


def corner_path(kind: CornerType, turn: float, a: float, b: float) -> np.ndarray | None:
    """Return the path (k,2) of the cut line from y = -a to the second cut line; None if the corner needs none.

    "right angle", "fold-back" and "extend" end the allowance of the first section. Mirror the corner to end the
    allowance of the second. A path beyond the limit is replaced by a mitre.
    """
    if turn < STRAIGHT or (a == 0 and b == 0):
        return None
    if turn < SHARP and kind != "round":
        kind = "mitre"
    if kind == "mitre" and abs(a - b) > STEEP * max(a, b) * math.sin(turn):
        kind = "step"
    path = PATHS[kind](turn, a, b)
    if path is None or _goes_too_far(path, turn, a, b):
        path = _cut_off_mitre(turn, a, b)
    return path


def _goes_too_far(path: np.ndarray, turn: float, a: float, b: float) -> bool:
    """Return whether the path extends beyond the limit, or removes more from the end of an allowance than its width."""
    outwards = float(np.linalg.norm(path, axis=1).max()) > MITRE_LIMIT * max(a, b) * (1 + 1e-9)
    taken = max(-path[0, 0], path[-1] @ (math.cos(turn), math.sin(turn)))
    return outwards or bool(taken > max(a, b))


def _mitre(turn: float, a: float, b: float) -> np.ndarray:
    return np.array([[(b - a * math.cos(turn)) / math.sin(turn), -a]])


def _cut_off_mitre(turn: float, a: float, b: float) -> np.ndarray:
    """Return the mitre. Beyond the limit, it is cut off square to the line that leads to its point."""
    limit = MITRE_LIMIT * max(a, b)
    if math.sin(turn) < 1e-6:  # the outline turns back on itself
        return np.array([[limit, -a], [limit, b]])
    (point,) = _mitre(turn, a, b)
    if np.linalg.norm(point) <= limit:
        return point[None]
    out = point / np.linalg.norm(point)
    backwards, along = np.array([-1.0, 0.0]), np.array([math.cos(turn), math.sin(turn)])
    beyond = np.linalg.norm(point) - limit
    return np.array([point + backwards * beyond / -(backwards @ out), point + along * beyond / -(along @ out)])


def _right_angle(turn: float, a: float, b: float) -> np.ndarray | None:
    """End the first allowance square to its stitching line."""
    if math.cos(turn) < 1e-9:
        return None
    return np.array([[0.0, -a], [0.0, -b / math.cos(turn)]])


def _fold_back(turn: float, a: float, b: float) -> np.ndarray:
    """End the first allowance so that its end, folded onto the piece, is on the second cut line."""
    return np.array([[(b + a * math.cos(turn)) / math.sin(turn), -a], [b / math.sin(turn), 0.0]])


def _extend(turn: float, a: float, b: float) -> np.ndarray:
    """End each allowance where its cut line meets the other's extended stitching line, with a straight line between."""
    return np.array([[-a / math.tan(turn), -a], [b / math.sin(turn), 0.0]])


def _step(turn: float, a: float, b: float) -> np.ndarray | None:
    """End the wider allowance square to its stitching line; the narrower one continues to it."""
    cosine = math.cos(turn)
    if cosine <= 1e-9 or min(a, b) / cosine > max(a, b):
        return None
    if b > a:
        normal = np.array([math.sin(turn), -cosine])
        return np.array([normal * a / cosine, normal * b])
    return np.array([[0.0, -a], [0.0, -b / cosine]])


def _round(turn: float, a: float, b: float) -> np.ndarray:
    """Return an arc, which changes evenly between different widths."""
    largest = max(a, b)
    step = 2 * math.acos(max(1 - SAGITTA / largest, 0.5))
    angles = np.linspace(0, turn, 2 + int(turn / step))
    widths = np.linspace(a, b, len(angles))
    return np.column_stack([widths * np.sin(angles), -widths * np.cos(angles)])


PATHS: dict[str, Callable[[float, float, float], np.ndarray | None]] = {
    "mitre": _mitre,
    "right angle": _right_angle,
    "fold-back": _fold_back,
    "extend": _extend,
    "step": _step,
    "round": _round,
}
