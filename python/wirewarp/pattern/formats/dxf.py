# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a pattern as DXF: in the dialects of apparel CAD, or as outlines on named layers."""

from pathlib import Path

import numpy as np

from ..checks import problem
from ..pattern_data import PatternData
from ..progress import Steps
from ..sheet.drawing import LOOKS, Stroke, strokes_of
from .apparel_dxf import apparel_dxf
from .dxf_tags import Tags, section
from .file_format import Choice, Format, Option
from .read_back import read_dxf

DIALECTS = (
    Choice("astm", "Clothing: ASTM", "Numbered layers, for AccuMark"),
    Choice("aama", "Clothing: AAMA", "Numbered layers, for CLO and Optitex"),
    Choice("plain", "Lasers and drawing", "Outlines on named layers, in millimeters"),
)
DECIMALS = 4  # decimals of the coordinates, which are in millimeters; as fine as GRID of geometry.py


def write_dxf(
    path: Path, pattern: PatternData, dialect: str = "astm", control_square: bool = False
) -> Steps[tuple[int, list[str]]]:
    """Write the file in steps. Return 1 for one page, and sentences about names that were changed.

    - dialect: a value of DIALECTS
    - control_square: whether to add a square of 100 mm to apparel DXF
    """
    changed: list[str] = []
    if dialect == "plain":
        text = yield from _plain_dxf(pattern)
    elif dialect in ("astm", "aama"):
        text, changed = yield from apparel_dxf(pattern, dialect == "aama", control_square)
    else:
        raise problem(f"dialect is {dialect!r}: give {', '.join(repr(each.value) for each in DIALECTS)}.")
    path.write_text(text, encoding="ascii", newline="\r\n")
    return 1, changed


def _plain_dxf(pattern: PatternData) -> Steps[str]:
    entities = Tags(DECIMALS)
    side, _ = pattern.units.square
    square = side * np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) - (side + 10, 0)
    strokes = [Stroke("scale", square, True)]
    for number, piece in enumerate(pattern.pieces):
        yield "writing", number / len(pattern.pieces)
        strokes += strokes_of(piece.without_texts_beside())
    for stroke in strokes:
        layer = stroke.look.layer.upper()
        if len(stroke.points) == 2 and stroke.look.layer != LOOKS["cut"].layer:
            entities.line(layer, stroke.points)
        else:
            entities.polyline(layer, stroke.points, stroke.closed)
    lowest, highest = pattern.bounds
    low, high = np.minimum(square.min(axis=0), lowest), np.maximum(square.max(axis=0), highest)
    parts = [section("HEADER", [_header(low, high)]), section("TABLES", [_layers()]), section("ENTITIES", [entities])]
    return "".join(part.data() for part in parts) + "  0\nEOF\n"


def _header(low: np.ndarray, high: np.ndarray) -> Tags:
    tags = Tags(DECIMALS)
    tags.add((9, "$ACADVER"), (1, "AC1009"), (9, "$INSUNITS"), (70, 4), (9, "$MEASUREMENT"), (70, 1))  # 4: millimeters
    tags.add((9, "$EXTMIN"), *tags.at(low, z=0.0), (9, "$EXTMAX"), *tags.at(high, z=0.0))
    return tags


def _layers() -> Tags:
    looks = {look.layer.upper(): look for look in reversed(LOOKS.values())}
    tags = Tags(DECIMALS)
    tags.add((0, "TABLE"), (2, "LTYPE"), (70, 1))
    tags.add((0, "LTYPE"), (2, "CONTINUOUS"), (70, 0), (3, "Solid line"), (72, 65), (73, 0), (40, "0.0"))
    tags.add((0, "ENDTAB"), (0, "TABLE"), (2, "LAYER"), (70, len(looks)))
    for name, look in looks.items():
        tags.add((0, "LAYER"), (2, name), (70, 0), (62, look.dxf_color), (6, "CONTINUOUS"))
    tags.add((0, "ENDTAB"))
    return tags


DXF_FORMAT = Format(
    ".dxf",
    "DXF, for CAD",
    "For programs of the clothing industry, or for lasers and routers",
    write_dxf,
    read_dxf,
    options=(
        Option("dialect", "For", "Kind of programs that read the file", DIALECTS),
        Option(
            "control_square",
            "Control Square",
            "Add a 100 mm square to check the scale after import",
            unless=("dialect", "plain"),
        ),
    ),
)
