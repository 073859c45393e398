# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators: thin, each over its work module."""

from .change_wire import MESH_OT_wirewarp_change_wire
from .clear import MESH_OT_wirewarp_clear
from .copy_report import OBJECT_OT_wirewarp_copy_report
from .export_svg import OBJECT_OT_wirewarp_export_svg
from .flatten import OBJECT_OT_wirewarp_flatten
from .frame import VIEW3D_OT_wirewarp_frame
from .grain_wire import MESH_OT_wirewarp_grain_wire
from .mark import MESH_OT_wirewarp_mark
from .seams_from_uv import MESH_OT_wirewarp_seams_from_uv_islands
from .select_issues import MESH_OT_wirewarp_select_issues
from .select_result import MESH_OT_wirewarp_select_result
from .select_wire import MESH_OT_wirewarp_select_wire
from .take_proposal import MESH_OT_wirewarp_take_proposal
from .update import OBJECT_OT_wirewarp_update, WM_OT_wirewarp_watch

CLASSES = (
    MESH_OT_wirewarp_mark,
    MESH_OT_wirewarp_clear,
    MESH_OT_wirewarp_change_wire,
    MESH_OT_wirewarp_grain_wire,
    MESH_OT_wirewarp_select_wire,
    MESH_OT_wirewarp_seams_from_uv_islands,
    MESH_OT_wirewarp_select_issues,
    MESH_OT_wirewarp_select_result,
    MESH_OT_wirewarp_take_proposal,
    OBJECT_OT_wirewarp_flatten,
    VIEW3D_OT_wirewarp_frame,
    OBJECT_OT_wirewarp_copy_report,
    OBJECT_OT_wirewarp_export_svg,
    OBJECT_OT_wirewarp_update,
    WM_OT_wirewarp_watch,
)
