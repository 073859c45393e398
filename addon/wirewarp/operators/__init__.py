# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators: thin, each over its work module.

May import: ui, run, flat, model, blender, report, solve, properties, core, issues, words.
"""

from .ease import MESH_OT_wirewarp_ease
from .export import OBJECT_OT_wirewarp_export, OBJECT_OT_wirewarp_export_svg
from .flatten import OBJECT_OT_wirewarp_cancel, OBJECT_OT_wirewarp_flatten
from .mark import (
    MESH_OT_wirewarp_allowance,
    MESH_OT_wirewarp_clear,
    MESH_OT_wirewarp_mark,
    MESH_OT_wirewarp_seams_from_uv_islands,
)
from .mend import OBJECT_OT_wirewarp_mend
from .report import (
    MESH_OT_wirewarp_select_issues,
    MESH_OT_wirewarp_select_result,
    MESH_OT_wirewarp_take_proposal,
    OBJECT_OT_wirewarp_copy_report,
)
from .sewing import OBJECT_OT_wirewarp_sewing
from .smooth import MESH_OT_wirewarp_smooth_seam
from .suggest import (
    OBJECT_OT_wirewarp_choose_suggestion,
    OBJECT_OT_wirewarp_drop_suggestions,
    OBJECT_OT_wirewarp_suggest_darts,
    OBJECT_OT_wirewarp_suggest_seams,
)
from .unit import SCENE_OT_wirewarp_set_unit
from .update import OBJECT_OT_wirewarp_update, WM_OT_wirewarp_watch
from .view import VIEW3D_OT_wirewarp_frame
from .wire import MESH_OT_wirewarp_change_wire, MESH_OT_wirewarp_grain_wire, MESH_OT_wirewarp_select_wire

CLASSES = (
    MESH_OT_wirewarp_mark,
    MESH_OT_wirewarp_clear,
    MESH_OT_wirewarp_allowance,
    MESH_OT_wirewarp_ease,
    MESH_OT_wirewarp_change_wire,
    MESH_OT_wirewarp_grain_wire,
    MESH_OT_wirewarp_select_wire,
    MESH_OT_wirewarp_seams_from_uv_islands,
    MESH_OT_wirewarp_smooth_seam,
    MESH_OT_wirewarp_select_issues,
    MESH_OT_wirewarp_select_result,
    MESH_OT_wirewarp_take_proposal,
    OBJECT_OT_wirewarp_flatten,
    OBJECT_OT_wirewarp_mend,
    OBJECT_OT_wirewarp_cancel,
    OBJECT_OT_wirewarp_suggest_darts,
    OBJECT_OT_wirewarp_suggest_seams,
    OBJECT_OT_wirewarp_choose_suggestion,
    OBJECT_OT_wirewarp_drop_suggestions,
    VIEW3D_OT_wirewarp_frame,
    OBJECT_OT_wirewarp_copy_report,
    OBJECT_OT_wirewarp_export,
    OBJECT_OT_wirewarp_export_svg,
    OBJECT_OT_wirewarp_sewing,
    SCENE_OT_wirewarp_set_unit,
    OBJECT_OT_wirewarp_update,
    WM_OT_wirewarp_watch,
)
