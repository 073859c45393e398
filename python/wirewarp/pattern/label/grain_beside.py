# SPDX-License-Identifier: GPL-3.0-or-later
"""Moves the grain arrow of a piece to a place beside a text."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..geometry import distances_to
from ..grain import grain_line
from ..model import Line, Text
from .room import corners, touches

SHORTEST = 10.0  # millimeters; fabric cannot be aligned with a shorter arrow
BESIDE = 3.0  # millimeters between a text and the line of an arrow, whose heads are 2.8 mm wide on each side
HATCHING = 2.0  # millimeters between lines that fill a text, so that the search finds no room inside the text


def grain_beside(
    text: Text,
    grain: Line,
    outlines: Sequence[np.ndarray],
    lines_inside: Sequence[np.ndarray],
    limits: Sequence[np.ndarray],
    allowance: float,
) -> Line:
    """Return the grain line. If it would cross the text and the piece has room, it is moved beside the text.

    - outlines: cutting lines
    - lines_inside, limits: as for grain_line()
    - allowance: widest allowance of the piece, in millimeters
    """
    if not touches(text, (grain.points[:1], grain.points[1:]), BESIDE):
        return grain
    box = corners(text, BESIDE)
    shares = np.linspace(0, 1, 1 + math.ceil(float(np.linalg.norm(box[3] - box[0])) / HATCHING))[:, None]
    rows = np.stack([box[0] + shares * (box[3] - box[0]), box[1] + shares * (box[2] - box[1])], axis=1)
    along = grain.points[1] - grain.points[0]
    along = along / np.linalg.norm(along)
    moved = grain_line(outlines, lines_inside, along, [*limits, box[[0, 1, 2, 3, 0]], *rows])
    is_long = np.linalg.norm(moved.points[1] - moved.points[0]) >= SHORTEST
    is_inside = distances_to(moved.points.mean(axis=0, keepdims=True), outlines)[0] > allowance
    return replace(grain, points=moved.points) if is_long and is_inside else grain
