# SPDX-License-Identifier: GPL-3.0-or-later
"""Every name under which something of ours is stored in a Blender file, but for the properties of properties.py.

Scripts and earlier files rely on these; what it is for stands beside it, and in the table of addon/README.md.
"""

# On the model's mesh, the truth: edges.
WIRE = "wirewarp_wire"  # INT, random 31-bit id of the wire, 0 none
TOLERANCE = "wirewarp_tolerance"  # FLOAT, 0 rigid, finite elastic, inf super-elastic
EASE = "wirewarp_ease"  # FLOAT: by how much the wire is to be longer, as a fraction; 0.05 is 5%
SIDE_EASE = "wirewarp_side_ease"  # on corners, FLOAT: the same for the side of the face whose corner begins the edge
SIDE_RATIO = "wirewarp_side_ratio"  # FLOAT: the same for one side of the edge, see model.side_eases
EASED_SIDE = "wirewarp_eased_side"  # INT, the number of the face on that side, 0 where none is eased
ALLOWANCE = "wirewarp_allowance"  # FLOAT, Blender units: the seam allowance; below 0 none; 0 and NaN the default
SIDE_ALLOWANCE = "wirewarp_side_allowance"  # on corners: the same for the side of the face whose corner begins the edge
SIDE_WIDTH = "wirewarp_side_width"  # FLOAT: the same for one side of the edge, see model.side_allowances
SIDE = "wirewarp_side"  # INT, the number of the face on that side, 0 where both sides are alike
FACE = "wirewarp_face"  # on faces: INT, random 31-bit number beside edges where a side is marked, 0 elsewhere
NO_SEAM = "wirewarp_no_seam"  # on faces, above 0: none is suggested there; also a vertex group of the object

# On the model's mesh, written by a run.
PIECE = "wirewarp_piece"  # face attribute INT, random 31-bit id of the piece, 0 none; on the flat mesh too
SEAM = "wirewarp_seam"  # edge attribute INT, random 31-bit id of the seam, 0 none; on the flat mesh too
UV_LAYER = "WireWarp"  # UV map of the pieces in the unit square
UV_SCALE = "wirewarp_uv_scale"  # custom property: Blender units in one UV unit

# On the model's object, custom properties.
REPORT = "wirewarp_report"  # of the run that made the flat pieces, JSON
REPORT_SEAL = "wirewarp_report_seal"  # digest of that text
MARKER = "wirewarp_marker"  # of the last export that made one, JSON after its digest

# On the flat mesh: attributes that say what its elements are of the model, all INT.
SOURCE_VERTEX = "source_vertex"  # points
SOURCE_CORNER = "source_corner"  # corners
SOURCE_FACE = "source_face"  # faces
PIECE_INDEX = "piece"  # faces: index of the piece in the report

# On the flat mesh: what tells that it was changed by hand.
FLAT_LENGTH = "flat_length"  # edge attribute FLOAT: as laid out
FLAT_COUNTS = "wirewarp_flat_counts"  # custom property: numbers of vertices, edges and faces
FLAT_AREAS = "wirewarp_flat_areas"  # custom property: signed area of each piece

# On the flat mesh, custom properties: how it was laid out.
LAYOUT = "wirewarp_layout"  # the options that lay out otherwise when they change, JSON
UP = "wirewarp_up"  # direction in the model's own space that was up
AWAY = "wirewarp_away"  # places of pieces that have no shape just now, see solve.places.NONE_AWAY
GRAIN = "wirewarp_grain_axes"  # which way the grain of each piece runs, see flat.grain
FACE_COUNT = "wirewarp_source_faces"  # faces of the mesh that was flattened
RANGE = "wirewarp_range_"  # before the name of each map: its smallest and its largest value

# Data-blocks.
COLLECTION = "WireWarp"  # of the flat objects of a scene
FAILED_MATERIAL = "WireWarp Failed Piece"  # on faces of pieces that broke a promise
