# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the results of a run, after all results have been computed."""

import bpy
import numpy as np

from ..blender.mesh import current_mesh
from ..blender.objects import show_where_shown
from ..core import Note
from ..names import UV_LAYER
from ..solve.flat_mesh import FlatMesh
from ..solve.flatten import gap_between
from ..state.identities import update_names, with_new_names, write_pieces, write_seams
from ..state.marked_mesh import wires_on
from ..state.owners import earlier_sentence, find_flat_object, has_flat_object, is_earlier, model_of
from ..state.record import new_record
from ..state.reports import remember, store, with_names
from .flat_object import follow_name, show_flat_object, write_flat_object, write_uv
from .models import Outcome
from .places import (
    TURNED_TEXT,
    Earlier,
    crowded_text,
    earlier_layout,
    is_turned,
    pieces_in_place,
    places_of_absent,
    present_up,
)
from .read import RunSettings, find_source

# The view moves to a layout whose length or width has grown by more than this factor. If it grows less, two thirds of
# the layout are still in view.
GROWN = 1.5


def write_results(context: bpy.types.Context, outcomes: list[Outcome], settings: RunSettings) -> None:
    """For every model whose run made pieces, write the flat object with its color maps, the UV map and the report. Keep
    the reports of other models in memory."""
    models = [model for outcome in outcomes if (model := find_source(outcome.model))]
    for outcome in outcomes:
        source = find_source(outcome.model)
        if outcome.pieces is not None:
            _write_pieces(context, source, outcome, settings, models)
            continue
        if find_flat_object(source):
            text = "Nothing was changed. The flat pieces are still those of an earlier run."
            outcome.report.notes.append(Note(text, is_warning=True))
        remember(source, outcome.report)


def _write_pieces(
    context: bpy.types.Context,
    source: bpy.types.Object,
    outcome: Outcome,
    settings: RunSettings,
    models: list[bpy.types.Object],
) -> None:
    """Write all results of one model. The flat object is written first: errors are likeliest in this step, and
    after such an error nothing else has changed. models: all models of this run."""
    arrays = outcome.arrays
    is_new, failed = not has_flat_object(source), [issue.piece for issue in outcome.report.issues]
    earlier = earlier_layout(find_flat_object(source), outcome.report.options) if settings.keep_places else None
    pieces, up = _place(source, outcome, earlier)
    away = places_of_absent(outcome.pieces, earlier, outcome.identities)
    record = new_record(outcome.report.options, up, away, outcome.pieces, pieces, arrays)
    flat = write_flat_object(context.scene, source, pieces, arrays, record, models)
    follow_name(source, outcome.model.known.model_name)
    if source.data.library is None:
        with current_mesh(source) as mesh:
            wires = wires_on(mesh)
        update_names(source.data, wires)
    outcome.identities = with_new_names(source, outcome.model.known, outcome.identities)
    write_pieces(source, outcome.result, arrays, outcome.identities, not settings.use_modifiers)
    write_seams(source, arrays, outcome.seams, not settings.use_modifiers)
    with_names(source, outcome.report)
    if is_new or failed:  # otherwise the piece that the user has chosen stays chosen
        source.wirewarp_active_piece = outcome.report.tables.pieces[0].index
    if not settings.use_modifiers:
        uv_scale = write_uv(source.data, outcome.pieces, len(arrays.loop_vertices))
        outcome.report.uv_layer, outcome.report.uv_scale = UV_LAYER, uv_scale
    context.view_layer.update()
    outcome.report.flat_object = flat.name
    outcome.report.notes += show_flat_object(context.view_layer, flat)
    others = [each for each in bpy.data.objects if model_of(each) == source and is_earlier(each)]
    outcome.report.notes += [Note(earlier_sentence(each), is_warning=True) for each in others]
    show_where_shown(source, flat)
    store(source, outcome.report)


def _place(source: bpy.types.Object, outcome: Outcome, earlier: Earlier | None) -> tuple[FlatMesh, np.ndarray]:
    """Return the pieces in their earlier places, and the upward direction (3,) of their layout. Add notes about pieces
    that were moved, and about a rotated model."""
    options = outcome.report.options
    pieces, crowded = pieces_in_place(outcome.pieces, earlier, gap_between(outcome.arrays, options["spacing"]))
    was = np.ptp(np.array(earlier.flat.bound_box), axis=0)[:2] if earlier else np.zeros(2)
    has_grown = bool(np.any(np.ptp(pieces.vertices, axis=0) > GROWN * was))  # for example because of new pieces
    outcome.is_elsewhere = bool(crowded) or has_grown
    if crowded:
        name_of = {identity.piece_id: identity.name for identity in outcome.identities}
        outcome.report.notes.append(Note(crowded_text([name_of[piece_id] for piece_id in crowded])))
    up = present_up(source)
    then = earlier.up if earlier else up
    if is_turned(up, then, outcome.report):
        outcome.report.notes.append(Note(TURNED_TEXT))
    return pieces, then
