# SPDX-License-Identifier: GPL-3.0-or-later
"""Places the names along lines. Sides that are sewn together have the same number on paper."""

import math
from collections.abc import Iterator, Sequence

import numpy as np

from ..geometry import lengths_along
from ..model import Line, Text, short_name
from .leaders import Beside
from .room import CLEAR, Room
from .text_place import text_width

# These are the heights of letters to try, in millimeters. If none fits, the name is placed beside the piece.
HEIGHTS = (4.5, 3.5, 2.5)
BESIDE = CLEAR + 0.25  # millimeters between a line and the letters of its name: half of the thickest line is added
ALONG_SEAM = (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8)  # places along a line to try, as shares of its length
ALONG_WIRE = (0.3, 0.7, 0.4, 0.6, 0.2, 0.8, 0.5)  # the middle is last, because wires often cross there


def line_names(lines: Sequence[Line], room: Room, beside: Beside) -> tuple[list[Text], list[Line]]:
    """Return the names of stitching lines, folds and wires, and the leader lines to names beside the piece.

    Names without room inside are beside the piece, or left out if there is no place.
    """
    named = [line for line in lines if line.name and line.role in ("sew", "fold", "wire")]
    texts, leaders = [], []
    for line in sorted(named, key=lambda line: line.role != "sew"):
        text = room.take(_choices(line))
        if text:
            texts.append(text)
        elif led := beside.lead(*_out_of_room(line)):
            texts.append(led[0])
            leaders.append(led[1])
    return texts, leaders


def _out_of_room(line: Line) -> tuple[list[Text], np.ndarray]:
    """Return the whole and the short name at the middle of the line, and the unit vector (2,) away from the piece."""
    middle, along, inside = _place_on(line.path, lengths_along(line.path), 0.5)
    names = dict.fromkeys([line.name, _short(line)])
    return [Text((name,), middle, HEIGHTS[-1], role="line name") for name in names], -inside


def _short(line: Line) -> str:
    return short_name(line.name) if line.role == "sew" else line.name


def _choices(line: Line) -> Iterator[Text]:
    points, along = line.path, lengths_along(line.path)
    is_seam = line.role == "sew"
    for height in HEIGHTS:
        named = [f"{line.name}: {line.joins}", line.name] if line.joins else [line.name]
        texts = [f"{text}, {line.note}" for text in named if line.note] + named
        text = next((each for each in texts if text_width(each, height) <= along[-1] / 2), _short(line))
        if text_width(text, height) > along[-1]:
            continue
        for share in ALONG_SEAM if is_seam else ALONG_WIRE:
            point, way, inside = _place_on(points, along, share)
            for side in (1,) if is_seam else (1, -1):
                yield Text((text,), point + side * (BESIDE + height / 2) * inside, height, _angle(way), "line name")


def _place_on(points: np.ndarray, along: np.ndarray, share: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return a point (2,) of a line (k,2), and the unit vectors (2,) along the line and into the piece.

    - along (k,): the result of lengths_along() for the line
    - share: share of the line's length from its start to the point
    """
    row = int(np.searchsorted(along, share * along[-1], side="right")) - 1
    a, b = points[row : row + 2]
    way = (b - a) / np.linalg.norm(b - a)
    point = a + (b - a) * (share * along[-1] - along[row]) / (along[row + 1] - along[row])
    return point, way, np.array([-way[1], way[0]])  # the piece is to the left of its outline


def _angle(direction: np.ndarray) -> float:
    """Return the angle of a text along this direction (2,), in degrees counterclockwise. The angle is above -90 and at
    most 90, so that the text is not upside down."""
    angle = math.degrees(math.atan2(direction[1], direction[0]))
    return angle - 180 if angle > 90 else angle + 180 if angle <= -90 else angle
