# SPDX-License-Identifier: GPL-3.0-or-later
"""The sidebar tab and the menu entries: they show, and call operators by name.

May import: overlay, run, solve, flat, model, blender, properties, core, issues, words.
"""

from . import layout, menus
from .flatten import VIEW3D_PT_wirewarp_advanced, VIEW3D_PT_wirewarp_flatten, VIEW3D_PT_wirewarp_settings
from .panel import IMAGE_PT_wirewarp_overlay, VIEW3D_PT_wirewarp_mark, VIEW3D_PT_wirewarp_overlay
from .piece_list import VIEW3D_PT_wirewarp_pieces, WIREWARP_UL_pieces
from .report import (
    VIEW3D_PT_wirewarp_report,
    VIEW3D_PT_wirewarp_report_outlines,
    VIEW3D_PT_wirewarp_report_seams,
    VIEW3D_PT_wirewarp_report_wires,
)
from .suggestions import VIEW3D_PT_wirewarp_suggestions
from .wire_list import VIEW3D_PT_wirewarp_wires, WIREWARP_UL_wires

CLASSES = (
    *menus.CLASSES,
    VIEW3D_PT_wirewarp_flatten,
    VIEW3D_PT_wirewarp_settings,
    VIEW3D_PT_wirewarp_advanced,
    VIEW3D_PT_wirewarp_suggestions,
    VIEW3D_PT_wirewarp_mark,
    WIREWARP_UL_wires,
    VIEW3D_PT_wirewarp_wires,
    WIREWARP_UL_pieces,
    VIEW3D_PT_wirewarp_pieces,
    VIEW3D_PT_wirewarp_report,
    VIEW3D_PT_wirewarp_report_seams,
    VIEW3D_PT_wirewarp_report_wires,
    VIEW3D_PT_wirewarp_report_outlines,
    VIEW3D_PT_wirewarp_overlay,
    IMAGE_PT_wirewarp_overlay,
)
__all__ = ["CLASSES", "menus", "layout"]
