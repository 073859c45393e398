# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns flat pieces into sewing patterns, and writes files to print, plot and cut.

Lengths are in millimeters, and y points upwards. The package uses these libraries:

- pyclipper: always
- pydyf, uharfbuzz: for PDF files
- spyrrow: optional, for shorter markers (layouts of the pieces on the fabric)
"""

from . import geometry as geometry
from .formats import FORMATS
from .formats.file_format import Choice, Format, Option
from .label.fonts import add_font_folder
from .make.outline import Chain, FlatPiece, FlatWire
from .make.seams import longer_text
from .make.widths import narrow_pieces
from .marker import Marker, Placement
from .model import Line, PatternPiece, Point, Text
from .narrow import closed_lines, has_room, narrowest_width, piece_width, pieces_along
from .options import PatternOptions
from .pattern import Pattern
from .pattern_data import PatternData, SewingStep, Written
from .progress import STAGES
from .sheet.papers import PAPERS, Page, roll_width
from .units import UnitSystem

__all__ = [
    "FORMATS",
    "PAPERS",
    "STAGES",
    "Chain",
    "Choice",
    "FlatPiece",
    "FlatWire",
    "Format",
    "Line",
    "Marker",
    "Option",
    "Page",
    "Pattern",
    "PatternData",
    "PatternOptions",
    "PatternPiece",
    "Placement",
    "Point",
    "SewingStep",
    "Text",
    "UnitSystem",
    "Written",
    "add_font_folder",
    "closed_lines",
    "has_room",
    "longer_text",
    "narrow_pieces",
    "narrowest_width",
    "piece_width",
    "pieces_along",
    "roll_width",
]
