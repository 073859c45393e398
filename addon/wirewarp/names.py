# SPDX-License-Identifier: GPL-3.0-or-later
"""Every name under which something of ours is stored in a Blender file."""

UV_LAYER = "WireWarp"
UV_SCALE = "wirewarp_uv_scale"
WIRE = "wirewarp_wire"
TOLERANCE = "wirewarp_tolerance"
PIECE = "wirewarp_piece"
