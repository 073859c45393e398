# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns flat pieces into patterns for the cutting table: allowances, notches, and files to print, plot and cut.

Everything is in millimeters, with y upwards. Needs pyclipper, and pydyf and uharfbuzz for PDF; markers are shorter if
spyrrow is installed.
"""

from . import geometry as geometry
from .formats import FORMATS
from .formats.file_format import Choice, Format, Option
from .label.fonts import add_font_folder
from .make.outline import Chain, FlatPiece, FlatWire
from .make.seams import longer_text
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
    "narrowest_width",
    "piece_width",
    "pieces_along",
    "roll_width",
]
