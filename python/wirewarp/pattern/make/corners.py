# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the cutting line around a corner of the outline: a path from the first cutting line to the second.

- origin: the corner's point
- turn: left turn of the outline at the corner, from 0 to pi radians
- first section: arrives in the direction +x, with the piece above it
- second section: leaves in the direction (cos turn, sin turn)
- a, b: widths of the first and the second allowance; the first cutting line is y = -a
"""

import math
from collections.abc import Callable
from typing import Literal, get_args

import numpy as np

CornerType = Literal["mitre", "right angle", "fold-back", "extend", "step", "round"]
CORNER_TYPES: tuple[str, ...] = get_args(CornerType)
MITRE_LIMIT = 2.5  # multiple of the larger width; a corner that extends farther (below 47 degrees) is cut off square
STRAIGHT = 1e-7  # radians; with a smaller turn, the wedge between the widest strips is finer than the grid
SHARP = math.radians(30)  # radians; a smaller turn can hardly be seen on fabric, so it gets a mitre
# If the difference of the widths, divided by the sine of the turn, exceeds this multiple of the larger width, a step
# replaces the mitre.
STEEP = 1.5
# Largest distance between the chords of a round corner and its arc, in millimeters: a dot of a printer with 1200 dpi.
SAGITTA = 0.02


def corner_path(kind: CornerType, turn: float, a: float, b: float) -> np.ndarray | None:
    """Return the path (k,2) from the first cutting line to the second; None if the corner needs no path.

    "right angle", "fold-back" and "extend" end the first allowance. To end the second, mirror the corner.
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
    """Return whether the path extends beyond the limit, or shortens an allowance by more than the larger width."""
    outwards = float(np.linalg.norm(path, axis=1).max()) > MITRE_LIMIT * max(a, b) * (1 + 1e-9)
    taken = max(-path[0, 0], path[-1] @ (math.cos(turn), math.sin(turn)))
    return outwards or bool(taken > max(a, b))


def _mitre(turn: float, a: float, b: float) -> np.ndarray:
    return np.array([[(b - a * math.cos(turn)) / math.sin(turn), -a]])


def _cut_off_mitre(turn: float, a: float, b: float) -> np.ndarray:
    """Return the mitre. If its point is beyond the limit, the mitre is cut off square to the line from the corner to
    the point."""
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
    """Return a path that ends the first allowance square to its stitching line; None for turns of at least 90
    degrees."""
    if math.cos(turn) < 1e-9:
        return None
    return np.array([[0.0, -a], [0.0, -b / math.cos(turn)]])


def _fold_back(turn: float, a: float, b: float) -> np.ndarray:
    """Return a path that ends the first allowance so that it reaches the second cutting line if it is folded back."""
    return np.array([[(b + a * math.cos(turn)) / math.sin(turn), -a], [b / math.sin(turn), 0.0]])


def _extend(turn: float, a: float, b: float) -> np.ndarray:
    """Return the straight path between two points. At each point, the cutting line of one section meets the extended
    stitching line of the other section."""
    return np.array([[-a / math.tan(turn), -a], [b / math.sin(turn), 0.0]])


def _step(turn: float, a: float, b: float) -> np.ndarray | None:
    """Return a path that ends the wider allowance square to its stitching line, up to the narrower cutting line. Return
    None if the path meets the narrower cutting line only beyond the wider allowance."""
    cosine = math.cos(turn)
    if cosine <= 1e-9 or min(a, b) / cosine > max(a, b):
        return None
    if b > a:
        normal = np.array([math.sin(turn), -cosine])
        return np.array([normal * a / cosine, normal * b])
    return np.array([[0.0, -a], [0.0, -b / cosine]])


def _round(turn: float, a: float, b: float) -> np.ndarray:
    """Return an arc around the corner's point. Its radius changes evenly from the first width to the second."""
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
