# SPDX-License-Identifier: GPL-3.0-or-later
"""Stores up to two reports of each object.

- The report of the run that made its flat pieces is stored on the object, so that the file keeps it.
- The report of a later run that wrote nothing is in memory, until another report is stored on the object.

A stored report that another program has changed is not shown, because it may be unsafe to read.
"""

import json

import bpy

from ..blender.attributes import digest, stored_text
from ..blender.mesh import element_counts
from ..core import Issue, ReportError, from_dict, rename_wires, to_dict
from ..names import REPORT, REPORT_SEAL
from ..solve.report import ObjectReport, failure_report
from .changes import has_changed
from .drawings import Same, kept_drawing
from .identities import piece_names, present_names, seam_names
from .memory import all_states, note, stamp, state_of

_SEEMS_CHANGED = "seems changed"  # name of a kept drawing, which is valid until another report is stored


def store(source: bpy.types.Object, report: ObjectReport) -> None:
    """Stores the report of a run that wrote pieces on the object."""
    note(source)
    text = json.dumps(to_dict(report))
    state_of(source).drawings.pop(_SEEMS_CHANGED, None)
    source[REPORT], source[REPORT_SEAL] = text, digest(text)


def remember(source: bpy.types.Object, report: ObjectReport) -> None:
    """Keeps in memory the report of a run that wrote nothing for this object. The report is hidden while the object
    has a later report."""
    note(source)
    state = state_of(source)
    state.failure, state.failed_after = report, stored_text(source, REPORT)
    state.drawings.pop(_SEEMS_CHANGED, None)


def last_report(source: bpy.types.Object) -> ObjectReport | None:
    """Return the report of the last run, with the present names of pieces, seams and wires; None without a run."""
    return with_names(source, _failure(source)) or pieces_report(source)


def pieces_report(source: bpy.types.Object) -> ObjectReport | None:
    """Return the report of the run that wrote the flat pieces, even if a later run failed; None without such a run."""
    return with_names(source, _read(source))


def seems_changed(source: bpy.types.Object, report: ObjectReport) -> bool:
    """Return whether the model has changed since its report, for drawing: the answer may be out of date for a moment.
    While a large model with modifiers changes, reading it at every redraw would take as long as drawing."""
    place = source.mode, source.visible_get(), source.matrix_world.copy()
    seen = stamp(source), stamp(source.data), place, Same(report)
    return kept_drawing(source, _SEEMS_CHANGED, seen, lambda: has_changed(source, report.model_state))


def flattened_name(source: bpy.types.Object) -> str:
    """Return the model's name when its flat pieces were made; without flat pieces, its present name."""
    report = _read(source)
    return report.object if report and report.object else source.name


def with_names(source: bpy.types.Object, report: ObjectReport | None) -> ObjectReport | None:
    """Return the report with the names of pieces, seams and wires in the lists of the model."""
    if report and report.pieces:
        names, named_seams = piece_names(source), seam_names(source)
        for seam in report.seams:
            seam.name = named_seams.get(seam.seam_id, seam.name)
        for piece in report.pieces:
            piece.name = names.get(piece.piece_id, piece.name)
        rename_wires(report, present_names(source.data, report))
    return report


def _failure(source: bpy.types.Object) -> ObjectReport | None:
    """Return the report of the last run if this run wrote nothing, otherwise None.

    After a later run is undone, the report is returned again.
    """
    state = state_of(source)
    failure = state.failure if state.failed_after == stored_text(source, REPORT) else None
    # Before Blender 4.1, another object may have the same key.
    if failure and not hasattr(source, "session_uid") and failure.counts != element_counts(source.data):
        return None
    return failure


def _read(source: bpy.types.Object) -> ObjectReport | None:
    if REPORT not in source:
        return None
    stored, state = (stored_text(source, REPORT), stored_text(source, REPORT_SEAL)), state_of(source)
    if state.parsed is None or state.parsed[0] != stored:
        state.parsed = stored, _parse(*stored)  # kept, because drawing panels reads the report often
    return state.parsed[1]


def _parse(text: str, seal: str) -> ObjectReport:
    try:
        return from_dict(json.loads(text) if seal == digest(text) else None, ObjectReport)
    except ReportError:
        sentence = "The stored report is from another version of WireWarp. Flatten again."
        return failure_report(Issue("unreadable_report", sentence))


def forget_incomparable(*_: object) -> None:
    """Forget reports of failed runs that have no state of the model, because after undo nothing can show whether they
    are outdated."""
    for state in all_states():
        if state.failure and state.failure.model_state is None:
            state.failure = None
