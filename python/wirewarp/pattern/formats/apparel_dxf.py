# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes DXF for apparel CAD: ASTM D6673 as AccuMark reads it, and AAMA-292 as CLO and Optitex read it.

Closed polylines have the closed flag, and also repeat their first point at the end, as these programs write them.
"""

import math

import numpy as np

from ..files import today
from ..label.text_place import LINE, text_width
from ..model import LEADERS, PatternPiece, Text
from ..pattern_data import PatternData
from ..progress import Steps
from ..sheet.drawing import LOOKS, WIRES, letters_baselines
from ..units import INCH
from .dxf_tags import Tags, block_names, escaped_text, plain_text, section

LONGEST_NAME = 20  # number of letters; AccuMark cuts off longer names
CORNER = math.radians(30)  # radians; points at which the outline turns more are turn points, others are curve points
TURN_POINT, CURVE_POINT = "2", "3"
NOTCH_WIDTH = 2.0  # millimeters at the edge of the piece; with the usual allowance, notches are 5 mm deep
FIELD_HEIGHT = 5.0  # millimeters: height of the letters in fields, large enough to read on a plot
CONTROL = 100.0  # millimeters: side of the control square, which any ruler can measure


def apparel_dxf(pattern: PatternData, is_aama: bool, control_square: bool) -> Steps[tuple[str, list[str]]]:
    """Return the text of the file, and sentences about names that were changed."""
    writer = _Writer(pattern, is_aama)
    names = block_names([piece.name for piece in pattern.pieces], LONGEST_NAME)
    blocks: list[Tags] = []
    for name, piece in zip(names, pattern.pieces, strict=True):
        yield "writing", len(blocks) / len(names)
        blocks.append(writer.block(name, piece))
    entities = [writer.style()]
    if control_square:
        names, blocks = [*names, "CONTROL_100MM"], [*blocks, writer.control()]
    entities += [writer.insert(name) for name in names]
    parts = [section("HEADER", []), section("BLOCKS", blocks), section("ENTITIES", entities)]
    changed = [
        f'"{piece.name}" is "{name}" in the DXF, whose letters are ASCII.'
        for piece, name in zip(pattern.pieces, names, strict=False)
        if not piece.name.isascii()
    ]
    return "".join(part.data() for part in parts) + "  0\nEOF\n", changed


def _legible(text: str, otherwise: str) -> str:
    """Return the text in ASCII, or `otherwise` if none of its letters can be written in ASCII."""
    plain = plain_text(text)
    return plain if plain.strip(" ?") else otherwise


class _Writer:
    def __init__(self, pattern: PatternData, is_aama: bool) -> None:
        self._pattern, self._is_aama = pattern, is_aama
        is_metric = pattern.units.name == "metric"
        self._units = "METRIC" if is_metric else "ENGLISH"
        self._scale = 1.0 if is_metric else 1 / INCH
        self._decimals = 2 if is_metric and not self._is_aama else 4

    def _tags(self) -> Tags:
        return Tags(self._decimals, self._scale)

    def _key(self, key: str) -> str:
        return key.upper() if self._is_aama else key

    def style(self) -> Tags:
        """Return the data of the whole pattern, as texts on layer 1."""
        tags = self._tags()
        fields = {
            "Style Name": _legible(self._pattern.title, "PATTERN"),
            "Creation Date": today().strftime("%d-%m-%Y"),
            "Author": "WireWarp",
            "Sample Size": "1",
            "Grade Rule Table": "",
            "Units": self._units,
        }
        if not self._is_aama:
            fields["ASTM/D13 Proposal 1 Version"] = "D6673-10"
        self._add_fields(tags, fields, np.zeros(2))
        return tags

    def insert(self, name: str) -> Tags:
        tags = self._tags()
        tags.add((0, "INSERT"), (8, "1"), (2, name), *tags.at(np.zeros(2)))
        return tags

    def block(self, name: str, piece: PatternPiece) -> Tags:
        tags = self._opened(name)
        right, left = piece.quantity
        quantity = str(right + left) if self._is_aama else f"{right},{left}"
        fields = {"Piece Name": _legible(piece.name, name)[:LONGEST_NAME], "Quantity": quantity}
        fields |= {"Material": plain_text(piece.material)} if piece.material else {}
        fields |= {"Size": "1"} if self._is_aama else {}
        middle = piece.bounds[0] + piece.size / 2
        self._add_fields(tags, fields, middle)
        # Leader lines are left out, because apparel DXF has no entity for them.
        for line in (line for line in piece.lines if line.role not in LEADERS.values()):
            self._add_line(tags, line.role, line.points, line.closed)
        for point in piece.points:
            if point.role == "drill":
                tags.add((0, "POINT"), (8, LOOKS["drill"].dxf_layer), *tags.at(point.at, z=point.depth))
            else:
                angle = math.degrees(math.atan2(point.direction[1], point.direction[0])) % 360
                at = tags.at(point.at, z=point.depth)
                tags.add((0, "POINT"), (8, LOOKS["notch"].dxf_layer), *at)
                tags.add((39, tags.number(NOTCH_WIDTH)), (50, f"{angle:.2f}"))
        for text in piece.texts:
            self._add_text(tags, text)
        tags.add((0, "ENDBLK"), (8, "1"))
        return tags

    def control(self) -> Tags:
        """Return the block of the control square. After import, its side must be 100 mm long."""
        tags = self._opened("CONTROL_100MM")
        square = CONTROL * np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]) - (2 * CONTROL, 0)
        tags.polyline("1", square, closed=True, repeat=True)
        self._add_fields(tags, {"Piece Name": "100 MM DO NOT CUT", "Quantity": "0"}, square[0] + 10)
        tags.add((0, "ENDBLK"), (8, "1"))
        return tags

    def _opened(self, name: str) -> Tags:
        tags = self._tags()
        tags.add((0, "BLOCK"), (8, "1"), (2, name), (70, 64), *tags.at(np.zeros(2), z=0.0))
        return tags

    def _add_fields(self, tags: Tags, fields: dict[str, str], at: np.ndarray) -> None:
        for number, (key, value) in enumerate(fields.items()):
            place = at - (0, number * LINE * FIELD_HEIGHT)
            tags.text("1", f"{self._key(key)}: {value}".rstrip(), place, FIELD_HEIGHT)

    def _add_text(self, tags: Tags, text: Text) -> None:
        """Add the lines of the text. They start half a width before their middle, as not all readers center texts."""
        angle = math.radians(text.angle)
        along = np.array([math.cos(angle), math.sin(angle)])
        for words, middle in letters_baselines(text, LINE):
            start = middle - text_width(words, text.height) / 2 * along
            tags.text(LOOKS["card"].dxf_layer, escaped_text(words), start, text.height, text.angle)

    def _add_line(self, tags: Tags, role: str, points: np.ndarray, closed: bool) -> None:
        layer = LOOKS[WIRES["rigid"] if role == "wire" else role].dxf_layer  # all kinds of wires have the same layer
        if role in ("grain", "fold"):
            tags.line(layer, points)
            if role == "grain":
                tags.line("5", points)  # layer 5 is for the reference line of grading
            return
        # An open cutting line belongs to a half piece. AccuMark needs its first point again, but no closed flag.
        if role == "cut" and not closed:
            points = np.concatenate([points, points[:1]])
        tags.polyline(layer, points, closed, repeat=True)
        if role == "sew" and self._is_aama:
            tags.polyline("8", points, closed, repeat=True)  # also as internal lines: AAMA has no layer 14
        self._add_kinds_of_points(tags, points, closed)

    def _add_kinds_of_points(self, tags: Tags, points: np.ndarray, closed: bool) -> None:
        around = np.concatenate([points[-1:], points, points[:1]]) if closed else points
        along = np.diff(around, axis=0)
        turns = np.arctan2(
            along[:-1, 0] * along[1:, 1] - along[:-1, 1] * along[1:, 0], (along[:-1] * along[1:]).sum(axis=1)
        )
        is_turn = np.abs(turns) > CORNER if closed else np.concatenate([[True], np.abs(turns) > CORNER, [True]])
        for point, turn in zip(points, is_turn, strict=True):
            tags.add((0, "POINT"), (8, TURN_POINT if turn else CURVE_POINT), *tags.at(point))
