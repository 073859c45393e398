# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn in a UV editor: the lines and failures of models, where their faces lie in the map of the pieces."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial

import bpy

from ..issues import ObjectError
from ..mesh_cache import stamp
from ..owners import model_or_self
from ..report_store import last_report
from ..write_helper_wires import helper_ends_in_map
from .cache import Same, kept_drawing
from .failure_drawing import Failures, uv_failures
from .gather_uv import gather_uv_lines, shows_our_map
from .object_drawing import Lines, lines_of, with_helpers


@dataclass(frozen=True)
class UvDrawing:
    target: bpy.types.Object
    lines: Lines
    failures: Failures | None


def uv_drawings(context: bpy.types.Context) -> Iterator[UvDrawing]:
    """Of the models in Edit Mode, in Object Mode of those that are selected or whose flat pieces are."""
    space = context.space_data
    if space.mode != "UV" or not space.overlay.show_overlays or not context.scene.wirewarp.show_lines:
        return
    for target in _targets(context):
        if target.type == "MESH" and shows_our_map(target.data):
            made_of = stamp(target), stamp(target.data), target.data.is_editmode, Same(last_report(target))
            lines = kept_drawing(target, "uv lines", made_of, partial(_lines, target))
            failed = None
            if not target.data.is_editmode:
                failed = kept_drawing(target, "uv failures", made_of, partial(uv_failures, target))
            yield UvDrawing(target, lines, failed)


def _targets(context: bpy.types.Context) -> list[bpy.types.Object]:
    if context.mode == "EDIT_MESH":
        return list(context.objects_in_mode_unique_data)
    if context.mode != "OBJECT":
        return []
    return list(dict.fromkeys(model_or_self(each) for each in context.selected_objects))


def _lines(target: bpy.types.Object) -> Lines:
    try:
        return with_helpers(lines_of(target, gather_uv_lines(target.data)), helper_ends_in_map(target))
    except ObjectError:
        return Lines({}, {}, [])  # an attribute of our name is another's; the list of wires says so
