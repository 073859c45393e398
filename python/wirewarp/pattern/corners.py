# SPDX-License-Identifier: GPL-3.0-or-later
"""The cut line round a corner of the outline, between the allowances of the two stretches that meet there.

Coordinates here are of the corner: its point is the origin, the first stretch arrives along +x with the piece above it,
and the outline turns left by `turn`, between 0 and pi. The first allowance, `a` wide, is cut along y = -a; the second,
`b` wide, runs on in the direction (cos turn, sin turn). A path leads from the one cut line to the other.
"""

import math
from collections.abc import Callable
from typing import Literal, get_args

import numpy as np

from .strips import MITRE_LIMIT

CornerType = Literal["mitre", "right angle", "fold-back", "extend", "step", "round"]
CORNER_TYPES: tuple[str, ...] = get_args(CornerType)
STRAIGHT = math.radians(0.5)  # less is no corner: the two cut lines are parallel for all that can be cut
NEARLY_STRAIGHT = 3.0  # times the width: a step comes before a point so far away
SAGITTA = 0.02  # millimeters, of the chords of a round corner


def corner_path(kind: CornerType, turn: float, a: float, b: float) -> np.ndarray | None:
    """The path (k,2) of the cut line from y = -a to the second cut line; None where the corner needs none.

    At "right angle", "fold-back" and "extend" it is the first stretch whose allowance ends that way: the other one's
    corner is the mirror image. A path that leads farther than the limit is a mitre.
    """
    if turn < STRAIGHT or (a == 0 and b == 0):
        return None
    if kind == "mitre" and abs(a - b) > NEARLY_STRAIGHT * max(a, b) * math.sin(turn):
        kind = "step"
    path = PATHS[kind](turn, a, b)
    if path is None or np.linalg.norm(path, axis=1).max() > MITRE_LIMIT * max(a, b) * (1 + 1e-9):
        path = _cut_off_mitre(turn, a, b)
    return path


def _mitre(turn: float, a: float, b: float) -> np.ndarray:
    return np.array([[(b - a * math.cos(turn)) / math.sin(turn), -a]])


def _cut_off_mitre(turn: float, a: float, b: float) -> np.ndarray:
    """The mitre; where its point lies beyond the limit, cut square to the line to the point."""
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
    """The first allowance ends square to its sew line."""
    if math.cos(turn) < 1e-9:
        return None
    return np.array([[0.0, -a], [0.0, -b / math.cos(turn)]])


def _fold_back(turn: float, a: float, b: float) -> np.ndarray:
    """The first allowance, folded over its sew line onto the piece, ends on the cut line of the second."""
    return np.array([[(b + a * math.cos(turn)) / math.sin(turn), -a], [b / math.sin(turn), 0.0]])


def _extend(turn: float, a: float, b: float) -> np.ndarray:
    """Each allowance ends where its cut line meets the sew line of the other, extended; straight from one to the other."""
    return np.array([[-a / math.tan(turn), -a], [b / math.sin(turn), 0.0]])


def _step(turn: float, a: float, b: float) -> np.ndarray | None:
    """The wider allowance ends square to its sew line; the narrower one runs on to it."""
    cosine = math.cos(turn)
    if cosine <= 1e-9 or min(a, b) / cosine > max(a, b):
        return None
    if b > a:
        normal = np.array([math.sin(turn), -cosine])
        return np.array([normal * a / cosine, normal * b])
    return np.array([[0.0, -a], [0.0, -b / cosine]])


def _round(turn: float, a: float, b: float) -> np.ndarray:
    """An arc; between different widths it goes from the one to the other evenly."""
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
