# SPDX-License-Identifier: GPL-3.0-or-later
"""From flat pieces to the cutting table: allowances, notches, and files to print, plot and cut.

Everything is in millimeters, y upwards. Needs pyclipper, and pydyf and uharfbuzz for PDF; markers
are shorter where spyrrow is installed.
"""

from . import geometry as geometry
from .eases import longer_text
from .file_format import Choice, Format, Option
from .flat_piece import Chain, FlatPiece, FlatWire
from .fonts import add_font_folder
from .formats import FORMATS
from .marker import Marker, Placement
from .model import Line, PatternPiece, Point, Text
from .papers import Page
from .pattern import Pattern
from .pattern_data import Written
from .units import UnitSystem

__all__ = [
    "FORMATS",
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
    "PatternPiece",
    "Placement",
    "Point",
    "Text",
    "UnitSystem",
    "Written",
    "add_font_folder",
    "longer_text",
]
