# SPDX-License-Identifier: GPL-3.0-or-later
"""Of which model the sidebar shows the report, and whether that is still true."""

import bpy

from ..solve.report import ObjectReport
from ..state.changes import has_changed
from ..state.drawings import Same, kept_drawing
from ..state.flat_pieces import no_pieces_sentence
from ..state.memory import stamp
from ..state.owners import earlier_sentence, has_flat_object, is_earlier, model_or_self
from ..state.reports import last_report

CHANGED = "The model has changed since. Flatten again."


def shown_report(context: bpy.types.Context) -> ObjectReport | None:
    """The report of the active object, or of the source of active flat pieces."""
    source = shown_source(context)
    return last_report(source) if source else None


def shown_source(context: bpy.types.Context) -> bpy.types.Object | None:
    active = context.active_object
    if active is None or active.type != "MESH":
        return None
    return model_or_self(active)


def untrue_sentence(active: bpy.types.Object, source: bpy.types.Object, report: ObjectReport) -> str:
    """Why the report says nothing of what is to be seen; "" if it does."""
    if has_changed_since(source, report):
        return CHANGED
    if report.flat_object is not None and not has_flat_object(source):
        return no_pieces_sentence(source)
    return earlier_sentence(active) if is_earlier(active) else ""


def has_changed_since(source: bpy.types.Object, report: ObjectReport) -> bool:
    """Not asked at every redraw while a large model with modifiers changes: to read it takes as long as to draw it."""
    place = source.mode, source.visible_get(), source.matrix_world.copy()
    seen = stamp(source), stamp(source.data), place, Same(report)
    return kept_drawing(source, "has changed", seen, lambda: has_changed(source, report.model_state))
