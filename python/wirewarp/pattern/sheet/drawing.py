# SPDX-License-Identifier: GPL-3.0-or-later
"""Divides a pattern into strokes, which every writer draws. The role of a stroke or text decides its look."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..label.room import Segments
from ..model import PatternPiece, Text


class Look(NamedTuple):
    layer: str  # name of the layer in SVG and PDF
    color: str
    stroke: float  # width of the line in millimeters
    dashes: tuple[float, ...]  # lengths of dashes and gaps in millimeters
    dxf_layer: str  # layer of apparel DXF, by ASTM D6673
    dxf_color: int  # AutoCAD's color index in plain DXF
    pen: int  # number of the pen of plotters
    label: str = ""  # name in the legend; "" for lines that the legend does not list


# The colors differ enough for programs of cutters that replace each color with the nearest color of their own.
LOOKS = {
    "cut": Look("Cut", "#000000", 0.5, (), "1", 1, 1, "Cutting line"),
    "inner_cut": Look("Cut", "#000000", 0.5, (), "11", 1, 1),
    "sew": Look("Sew", "#ff00ff", 0.3, (4.0, 2.0), "14", 5, 2, "Stitching line"),
    "fold": Look("Fold", "#ff00ff", 0.3, (8.0, 2.0, 2.0, 2.0), "6", 5, 2, "Fold of the fabric"),
    "rigid wire": Look("Rigid Wires", "#0000ff", 0.3, (), "8", 8, 3, "Rigid wire"),
    "elastic wire": Look("Elastic Wires", "#c76b00", 0.3, (6.0, 2.0), "8", 8, 3, "Elastic wire"),
    "free wire": Look("Free Wires", "#008a78", 0.5, (0.3, 2.0), "8", 8, 3, "Free wire"),
    "grain": Look("Grain", "#505050", 0.3, (), "7", 8, 3, "Grain"),
    "notch": Look("Notches", "#ff0000", 0.3, (), "4", 3, 4, "Notch"),
    "clip": Look("Notches", "#ff0000", 0.3, (), "4", 3, 4, "Clip"),
    "drill": Look("Notches", "#ff0000", 0.3, (), "13", 3, 4, "Drill hole"),
    "card": Look("Text", "#505050", 0.3, (), "15", 7, 3),
    "line name": Look("Line Names", "#505050", 0.3, (), "15", 7, 3),
    "card leader": Look("Text", "#505050", 0.3, (), "15", 7, 3),
    "name leader": Look("Line Names", "#505050", 0.3, (), "15", 7, 3),
    "scale": Look("Scale", "#808080", 0.3, (), "8", 8, 3),
}
SHEET = Look("Sheets", "#909090", 0.3, (), "8", 8, 3)  # frames and marks of the sheets of a PDF
WIRES = {"rigid": "rigid wire", "elastic": "elastic wire", "super_elastic": "free wire"}  # roles by Line.kind
LAYERS = tuple(dict.fromkeys(look.layer for look in LOOKS.values()))


ARROW = 6.0  # millimeters: length of the heads of grain arrows, but at most a third of the arrow
CROSS = 4.0  # millimeters; the cross of a drill hole is (CROSS + diameter) / 2 wide, 0.5 mm wider than the hole


@dataclass(frozen=True)
class Stroke:
    role: str
    points: np.ndarray  # (k,2)
    closed: bool = False
    name: str = ""

    @property
    def look(self) -> Look:
        return SHEET if self.role == "sheet" else LOOKS[self.role]

    @property
    def segments(self) -> Segments:
        following = np.roll(self.points, -1, axis=0)
        return (self.points, following) if self.closed else (self.points[:-1], following[:-1])


def strokes_of(piece: PatternPiece) -> Iterator[Stroke]:
    """Yield all strokes of a piece. Cutting lines are last, so that inner lines are cut before the outline."""
    for line in sorted(piece.lines, key=lambda line: (line.role == "cut", line.role == "inner_cut")):
        if line.role == "cut":
            break
        if line.role == "sew" and line.width == 0:  # the cutting line is in the same place
            continue
        role = WIRES[line.kind] if line.role == "wire" else line.role
        yield Stroke(role, line.points, line.closed, line.name)
        if line.role == "grain":
            yield from (Stroke("grain", head) for head in _arrow_heads(line.points))
    for point in piece.points:
        if point.role == "drill":
            yield from (Stroke("drill", arm) for arm in _cross(point.at, point.depth))
        else:
            yield Stroke(point.role, point.stroke)
    for line in piece.of_role("cut"):
        yield Stroke("cut", line.points, line.closed)


def _arrow_heads(line: np.ndarray) -> list[np.ndarray]:
    heads = []
    for tip, other in (line, line[::-1]):
        back = (other - tip) / np.linalg.norm(other - tip) * min(ARROW, np.linalg.norm(other - tip) / 3)
        aside = np.array([-back[1], back[0]]) * math.tan(math.radians(25))
        heads.append(np.array([tip + back + aside, tip, tip + back - aside]))
    return heads


def _cross(at: np.ndarray, size: float) -> list[np.ndarray]:
    arm = np.array([[1.0, 1.0], [1.0, -1.0]]) * (size + CROSS) / 4
    return [np.array([at - each, at + each]) for each in arm]


def letters_baselines(text: Text, line_height: float) -> Iterator[tuple[str, np.ndarray]]:
    """Yield each line of the turned text with the middle (2,) of its base line, in millimeters."""
    angle = math.radians(text.angle)
    up = np.array([-math.sin(angle), math.cos(angle)])
    for line, below in base_lines(text, line_height):
        yield line, text.center - below * up


def base_lines(text: Text, line_height: float) -> Iterator[tuple[str, float]]:
    """Yield each line of the text with the distance of its base line below the center of the text, in millimeters."""
    for number, line in enumerate(text.lines):
        # The number 0.36 is half of the height of capitals, as a share of the font size.
        below = line_height * (number - (len(text.lines) - 1) / 2) + 0.36
        yield line, below * text.height
