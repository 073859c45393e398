# SPDX-License-Identifier: GPL-3.0-or-later
"""All names under which the add-on stores data in Blender files, except for the properties in properties.py.

Scripts and earlier files rely on these names; the table in addon/README.md describes them.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Attribute:
    """A mesh attribute with one number per element, which is 0 if none was written."""

    name: str
    data_type: str  # "INT" or "FLOAT"
    domain: str  # "POINT", "EDGE", "FACE" or "CORNER"


@dataclass(frozen=True)
class Mark(Attribute):
    """An attribute of the model's mesh that stores the user's marks of edges, or of one side of an edge."""

    is_length: bool = False  # whether the values are lengths in Blender units, which Set Unit scales
    is_drawn: bool = False  # whether the overlay draws the mark on the model


# Marks on the model's mesh. Users and scripts write these, and runs only read them.
WIRE = Mark("wirewarp_wire", "INT", "EDGE", is_drawn=True)  # random 31-bit id of the wire, 0 none
TOLERANCE = Mark("wirewarp_tolerance", "FLOAT", "EDGE")  # 0: rigid, finite: elastic, infinite: super-elastic
EASE = Mark("wirewarp_ease", "FLOAT", "EDGE")  # relative change of the wire's length: 0.05 is 5%
# SIDE_EASE is the ease of one side of an edge: the side of the face in which the edge begins at this corner.
SIDE_EASE = Mark("wirewarp_side_ease", "FLOAT", "CORNER", is_drawn=True)
SIDE_RATIO = Mark("wirewarp_side_ratio", "FLOAT", "EDGE", is_drawn=True)  # like EASE, for one side, see SidedMark
EASED_SIDE = Mark("wirewarp_eased_side", "INT", "EDGE")  # FACE of the face on the side with SIDE_RATIO, 0 none
ALLOWANCE = Mark("wirewarp_allowance", "FLOAT", "EDGE", is_length=True)  # see state.allowances
# SIDE_ALLOWANCE is the allowance of one side of an edge: the side of the face in which the edge begins at this corner.
SIDE_ALLOWANCE = Mark("wirewarp_side_allowance", "FLOAT", "CORNER", is_length=True)
SIDE_WIDTH = Mark("wirewarp_side_width", "FLOAT", "EDGE", is_length=True)  # like ALLOWANCE, for one side, see SidedMark
SIDE = Mark("wirewarp_side", "INT", "EDGE")  # FACE of the face on the side with SIDE_WIDTH, 0 none
FACE = Mark("wirewarp_face", "INT", "FACE")  # random 31-bit number of a face beside an edge with a marked side, 0 none
MARKS = (WIRE, TOLERANCE, EASE, SIDE_EASE, SIDE_RATIO, EASED_SIDE, ALLOWANCE, SIDE_ALLOWANCE, SIDE_WIDTH, SIDE, FACE)
# No seam is suggested on faces with a value above 0. A vertex group of the object with this name has the same effect.
NO_SEAM = "wirewarp_no_seam"

# A run writes these data on the model's mesh.
PIECE = Attribute("wirewarp_piece", "INT", "FACE")  # random 31-bit id of the piece, 0 none; on the flat mesh too
SEAM = Attribute("wirewarp_seam", "INT", "EDGE")  # random 31-bit id of the seam, 0 none; on the flat mesh too
UV_LAYER = "WireWarp"  # UV map of the pieces in the unit square
UV_SCALE = "wirewarp_uv_scale"  # custom property: Blender units in one UV unit

# These are custom properties of the model's object.
REPORT = "wirewarp_report"  # report of the run that made the flat pieces, JSON
REPORT_SEAL = "wirewarp_report_seal"  # digest of the report's text
MARKER = "wirewarp_marker"  # last marker made by an export: a digest, then JSON

# These attributes of the flat mesh contain the index of the model's element from which each flat element was made.
SOURCE_VERTEX = Attribute("source_vertex", "INT", "POINT")
SOURCE_CORNER = Attribute("source_corner", "INT", "CORNER")
SOURCE_FACE = Attribute("source_face", "INT", "FACE")
PIECE_INDEX = Attribute("piece", "INT", "FACE")  # index of the face's piece in the report

# These data of the flat mesh describe its layout, and show manual changes.
FLAT_LENGTH = Attribute("flat_length", "FLOAT", "EDGE")  # edge lengths of the layout
FLAT_RECORD = "wirewarp_flat"  # custom property: how the pieces were laid out, see state.record

COLLECTION = "WireWarp"  # collection of the flat objects of a scene
FAILED_MATERIAL = "WireWarp Failed Piece"  # on faces of pieces that failed
