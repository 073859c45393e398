# SPDX-License-Identifier: GPL-3.0-or-later
"""How every kind of line is drawn, whatever it is written to: the one table."""

from typing import NamedTuple


class Look(NamedTuple):
    layer: str  # of SVG and PDF
    color: str
    stroke: float  # millimeters
    dashes: tuple[float, ...]
    dxf_layer: str  # of apparel DXF, ASTM D6673
    dxf_color: int  # of plain DXF: AutoCAD's color index
    pen: int  # of plotters


# Colors differ enough for cutters' programs to tell them apart by the nearest of their own.
LOOKS = {
    "cut": Look("Cut", "#000000", 0.5, (), "1", 1, 1),
    "inner_cut": Look("Cut", "#000000", 0.5, (), "11", 1, 1),
    "sew": Look("Sew", "#ff00ff", 0.3, (4.0, 2.0), "14", 5, 2),
    "fold": Look("Fold", "#ff00ff", 0.3, (8.0, 2.0, 2.0, 2.0), "6", 5, 2),
    "rigid wire": Look("Rigid Wires", "#0000ff", 0.3, (), "8", 8, 3),
    "elastic wire": Look("Elastic Wires", "#c76b00", 0.3, (6.0, 2.0), "8", 8, 3),
    "free wire": Look("Free Wires", "#008a78", 0.5, (0.3, 2.0), "8", 8, 3),
    "grain": Look("Grain", "#505050", 0.3, (), "7", 8, 3),
    "notch": Look("Notches", "#ff0000", 0.3, (), "4", 3, 4),
    "clip": Look("Notches", "#ff0000", 0.3, (), "4", 3, 4),
    "drill": Look("Notches", "#ff0000", 0.3, (), "13", 3, 4),
    "card": Look("Text", "#505050", 0.3, (), "15", 7, 3),
    "line name": Look("Line Names", "#505050", 0.3, (), "15", 7, 3),
    "card leader": Look("Text", "#505050", 0.3, (), "15", 7, 3),
    "name leader": Look("Line Names", "#505050", 0.3, (), "15", 7, 3),
    "scale": Look("Scale", "#808080", 0.3, (), "8", 8, 3),
}
SHEET = Look("Sheets", "#909090", 0.3, (), "8", 8, 3)  # frames and marks of the sheets of a PDF
WIRES = {"rigid": "rigid wire", "elastic": "elastic wire", "super_elastic": "free wire"}  # by Line.kind
LAYERS = tuple(dict.fromkeys(look.layer for look in LOOKS.values()))
