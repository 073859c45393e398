# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects in Object Mode to models that can be solved without Blender; and whether they are still the same."""

from dataclasses import replace
from typing import Protocol

import bpy

from .. import core
from ..blender.mesh import element_counts
from ..blender.units import length_text, meters_per_blender_unit
from ..issues import ObjectError, object_error
from ..solve.report import Facts
from ..state.changes import has_changed, model_state
from ..state.identities import known_pieces, known_seams
from ..state.marked_mesh import marked_mesh
from ..state.memory import read_anew, state_of
from ..state.modifiers import left_out, shaped_by
from ..state.owners import find_flat_object
from ..state.read_model import object_to_arrays
from ..state.reports import flattened_name
from ..words import LengthText, quoted
from .models import Model
from .targets import check_target


class RunSettings(Protocol):
    """What of the panel's or the operator's settings reading and writing ask for."""

    use_modifiers: bool
    keep_places: bool


def read_models(context: bpy.types.Context, sources: list[bpy.types.Object], settings: RunSettings) -> list[Model]:
    """What cannot be flattened becomes a model with an issue."""
    context.view_layer.update()
    depsgraph, units = context.evaluated_depsgraph_get(), length_text(context.scene)
    allowance = context.scene.wirewarp.allowance / (1000 * meters_per_blender_unit(context.scene))
    return [_read(source, depsgraph, units, allowance, settings) for source in sources]


def find_source(model: Model) -> bpy.types.Object | None:
    """The object that the model was read from; None if it is gone or has another name."""
    return next((candidate for candidate in bpy.data.objects if candidate.name_full == model.name), None)


def is_current(model: Model) -> bool:
    """Whether its object is still there, a mesh, and as it was read. In any mode."""
    source = find_source(model)
    return source is not None and source.type == "MESH" and not has_changed(source, model.state, read_anew)


def check_current(context: bpy.types.Context, models: list[Model], settings: RunSettings) -> None:
    """Raises ObjectError if an object is no longer as it was read, or may not be written any more, in Object Mode."""
    context.view_layer.update()
    changed = [model.facts.object for model in models if not is_current(model)]
    if changed:
        sentence = f"{quoted(changed)} changed during the run, so nothing was written. Flatten again."
        raise object_error("changed", sentence)
    for model in models:
        if model.issue is None:
            _check(find_source(model), settings)


def _check(source: bpy.types.Object, settings: RunSettings) -> None:
    check_target(source, writes_model=not settings.use_modifiers)


def _read(
    source: bpy.types.Object,
    depsgraph: bpy.types.Depsgraph,
    units: LengthText,
    allowance: float,
    settings: RunSettings,
) -> Model:
    """allowance: where none is marked, in Blender units."""
    use_modifiers = settings.use_modifiers
    facts = Facts(
        object=source.name,
        mesh=source.data.name,
        with_modifiers=use_modifiers,
        shaped_by=shaped_by(source, depsgraph),
        counts=element_counts(source.data),
    )
    arrays = known = seams = state = solved = by_map = issue = None
    try:
        _check(source, settings)
        base = marked_mesh(source)
        arrays = object_to_arrays(source, base, depsgraph if use_modifiers else None)
        arrays = replace(arrays, allowance=max(arrays.allowance, allowance), lengths=units)
        # Results with modifiers are not written to the model, and of objects that share a mesh the last one's are on
        # it: only the flat pieces know this object's last ids.
        asks_flat_pieces = use_modifiers or source.data.users > 1
        flat = find_flat_object(source) if asks_flat_pieces else None
        known = known_pieces(source, arrays, flat, flattened_name(source))
        seams = known_seams(source, arrays, flat)
        state = model_state(source, base, use_modifiers)
        solved, by_map = solved_pieces(source)
    except ObjectError as error:
        issue = error.issue
    notes = left_out(source, arrays, use_modifiers)
    return Model(source.name_full, facts, state, notes, arrays, known, seams, solved, by_map, issue)


def solved_pieces(source: bpy.types.Object) -> tuple[core.Cache, core.Cache]:
    """The object's Caches: of its pieces, and of those by the seams of its UV map. What does not fit is not used."""
    state = state_of(source)
    if state.solved is None:
        state.solved, state.solved_by_map = core.library().Cache(), core.library().Cache()
    return state.solved, state.solved_by_map
