# SPDX-License-Identifier: GPL-3.0-or-later
"""Names along the lines: on paper, too, the sides that are sewn together have one number."""

import math
import re
from collections.abc import Iterator, Sequence

import numpy as np

from .interior import text_width
from .model import Line, Text
from .outline import lengths_along
from .room import Room

HEIGHTS = (4.5, 3.5, 2.5)  # of the letters, in millimeters; where none fits, the line goes without a name
NUMBERED = re.compile("^(Seam|Dart) (?=[0-9]+$)")  # goes without the word where there is little room
BESIDE = 0.75  # from a line to the letters
ALONG_SEAM = (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8)  # of its length, the best first
ALONG_WIRE = (0.3, 0.7, 0.4, 0.6, 0.2, 0.8, 0.5)  # wires often cross in their middles


def line_names(lines: Sequence[Line], room: Room) -> list[Text]:
    """Of the sew lines and wires that have a name and room for it, inside the piece."""
    named = [line for line in lines if line.name and line.role in ("sew", "wire")]
    found = (room.take(_choices(line)) for line in sorted(named, key=lambda line: line.role != "sew"))
    return [text for text in found if text]


def _choices(line: Line) -> Iterator[Text]:
    points = np.concatenate([line.points, line.points[:1]]) if line.closed else line.points
    along = lengths_along(points)
    is_seam = line.role == "sew"
    for height in HEIGHTS:
        short = NUMBERED.sub("", line.name) if is_seam else line.name
        texts = [f"{line.name}: {line.joins}", line.name] if line.joins else [line.name]
        text = next((each for each in texts if text_width(each, height) <= along[-1] / 2), short)
        if text_width(text, height) > along[-1]:
            continue
        for share in ALONG_SEAM if is_seam else ALONG_WIRE:
            row = int(np.searchsorted(along, share * along[-1], side="right")) - 1
            a, b = points[row : row + 2]
            point = a + (b - a) * (share * along[-1] - along[row]) / (along[row + 1] - along[row])
            inside = np.array([a[1] - b[1], b[0] - a[0]]) / np.linalg.norm(b - a)  # of an outline, on its left
            for side in (1,) if is_seam else (1, -1):
                yield Text((text,), point + side * (BESIDE + height / 2) * inside, height, _angle(b - a), "line name")


def _angle(direction: np.ndarray) -> float:
    """Degrees counterclockwise, over -90 to 90, so that the text is not upside down."""
    angle = math.degrees(math.atan2(direction[1], direction[0]))
    return angle - 180 if angle > 90 else angle + 180 if angle <= -90 else angle
