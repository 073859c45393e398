# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads objects into models that can be solved without Blender, and checks whether the objects have changed."""

from collections.abc import Collection, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager, nullcontext
from dataclasses import replace
from typing import Protocol

import bpy
import numpy as np

from ..blender.mesh import current_mesh, element_counts
from ..blender.objects import check_local, length_text, linear_part, meters_per_blender_unit, metric
from ..blender.selection import edited_meshes, in_object_mode
from ..core import Cache, Issue, LengthText, quoted
from ..issues import ObjectError, object_error
from ..solve.report import Facts
from ..state.changes import has_changed, model_state
from ..state.flat_pieces import is_flat_mesh
from ..state.identities import known_pieces, known_seams
from ..state.marked_mesh import check_attributes, check_id_room, marked_mesh
from ..state.memory import read_anew, state_of
from ..state.owners import DELETED, check_not_edited, find_flat_object, is_deleted, model_of, model_or_self
from ..state.read_model import left_out, object_to_arrays, shaped_by
from ..state.reports import flattened_name
from ..ui import window_run
from .flat_object import check_uv_room
from .models import Model

CONVERTIBLE = {"CURVE", "SURFACE", "META", "FONT"}


def mesh_targets(context: bpy.types.Context) -> list[bpy.types.Object]:
    """Return all meshes that are selected or in Edit Mode; if nothing is selected, the active mesh. Flat pieces are
    replaced by their model."""
    edited = list(context.objects_in_mode) if context.mode == "EDIT_MESH" else []
    models = (_model(context, each) for each in [*edited, *context.selected_objects])
    chosen = list(dict.fromkeys(filter(None, models)))
    return chosen or ([] if context.selected_objects else active_target(context))


def active_target(context: bpy.types.Context) -> list[bpy.types.Object]:
    """Return a list with the active object or, if it contains flat pieces, with their model. The list is empty if the
    active object is hidden, or if _model() returns None for it."""
    active = context.view_layer.objects.active
    model = _model(context, active) if active and active.visible_get() else None
    return [model] if model else []


def _model(context: bpy.types.Context, target: bpy.types.Object) -> bpy.types.Object | None:
    """Return the model to flatten for this object; None if the object is not a mesh, or if its model is not in the view
    layer."""
    model = model_or_self(target)
    is_there = model.name_full in context.view_layer.objects or model == target
    return model if model.type == "MESH" and model_of(model) is None and is_there else None


def check_sources(context: bpy.types.Context, sources: list[bpy.types.Object]) -> None:
    """Raises ObjectError if another run is in progress, or if nothing can be flattened."""
    refusal = window_run.busy_sentence() or _nothing_to_flatten(context, sources)
    if refusal:
        raise object_error("nothing", refusal)


def _nothing_to_flatten(context: bpy.types.Context, sources: list[bpy.types.Object]) -> str:
    """Return a sentence that says why nothing can be flattened; empty if an object can be flattened."""
    if context.scene.library:
        return (
            f'Nothing to flatten: the scene "{context.scene.name}" is linked from another file and cannot get flat '
            "pieces. Link the model into a scene of this file."
        )
    if sources:
        return ""
    active = context.view_layer.objects.active
    if active and active.type == "MESH" and not active.visible_get():
        return f'Nothing to flatten: "{active.name}" is hidden. Show it in the Outliner and select it.'
    models = [model for model in map(model_of, context.selected_objects) if model]
    if models and all(map(is_deleted, models)):
        return f"Nothing to flatten: these are flat pieces. {DELETED.format(models[0].name)}"
    if active and active.select_get() and active.type in CONVERTIBLE:
        return f'Nothing to flatten: "{active.name}" is not a mesh. Use Object > Convert > Mesh first.'
    if models:
        return f'Nothing to flatten: "{models[0].name}", the model of these pieces, is not in this view layer.'
    return "Nothing to flatten: select a mesh object."


class RunSettings(Protocol):
    """Settings of the panel or operator that are needed for reading and writing."""

    use_modifiers: bool
    keep_places: bool


@contextmanager
def in_suitable_mode(
    context: bpy.types.Context, sources: list[bpy.types.Object], settings: RunSettings
) -> Iterator[None]:
    """Leave Edit Mode if these models cannot be read or written in it, and return to it at the end.

    Otherwise stay in Edit Mode, because Auto flattens often, and Blender's log would show each change of mode.
    """
    edited = edited_meshes(context)
    if any(_needs_object_mode(source, settings, edited) for source in sources):
        with in_object_mode(context):
            yield
    else:
        yield


def _needs_object_mode(source: bpy.types.Object, settings: RunSettings, edited: Collection[bpy.types.Mesh]) -> bool:
    """Return whether the run reads data that Edit Mode hides, or replaces a mesh that is in Edit Mode."""
    if settings.use_modifiers:
        return True
    flat = find_flat_object(source)
    if flat is not None and flat.data in edited:
        return True
    is_shaped = source.data.shape_keys is not None or any(modifier.show_viewport for modifier in source.modifiers)
    return source.data in edited and is_shaped


def check_target(target: bpy.types.Object, writes_model: bool, edited: Collection[bpy.types.Mesh]) -> None:
    """Raises ObjectError if the results cannot be written. All conditions are checked here, before the first result is
    written. writes_model: whether results are also written to the base mesh; edited: see edited_meshes."""
    linear_part(target)
    check_not_edited(target, edited)
    with current_mesh(target) as mesh:
        is_flat = is_flat_mesh(mesh)
        check_attributes(mesh)
    if is_flat:
        raise object_error(
            "flat_pieces",
            f'"{target.name}" contains flat pieces, and their model was deleted. Restore the model, or select another '
            'model. To flatten the pieces as they are, delete the attribute "source_vertex" under Object Data > '
            "Attributes.",
        )
    check_local(target, target)
    if writes_model:
        check_local(target, target.data)
        check_id_room(target)
        check_uv_room(target)
        _check_users(target)


def _check_users(target: bpy.types.Object) -> None:
    """Raise ObjectError if objects with different scales share a mesh, because they cannot share a UV map."""
    own = metric(target)
    for other in bpy.data.objects:
        shares = other.data == target.data and other.users_scene  # objects outside all scenes do not count
        if shares and not np.allclose(metric(other), own, rtol=1e-5, atol=1e-5 * np.abs(own).max()):
            sentence = (
                f'"{target.name}" and "{other.name}" share the mesh "{target.data.name}" but differ in scale, or one '
                "is mirrored. One UV map cannot fit both. Use Object > Relations > Make Single User > Object & Data."
            )
            raise ObjectError(Issue("multi_user_scale", sentence))


def read_models(context: bpy.types.Context, sources: list[bpy.types.Object], settings: RunSettings) -> list[Model]:
    """Return the models read from these objects. The model of an object that cannot be flattened has an issue."""
    context.view_layer.update()
    depsgraph, units = context.evaluated_depsgraph_get(), length_text(context.scene)
    allowance = context.scene.wirewarp.allowance / (1000 * meters_per_blender_unit(context.scene))
    edited, models = edited_meshes(context), []
    for source in sources:
        with _one_copy(source, edited):
            models.append(_read(source, depsgraph, units, allowance, settings, edited))
    return models


def _one_copy(source: bpy.types.Object, edited: Collection[bpy.types.Mesh]) -> AbstractContextManager:
    """Return a context in which all readers of a mesh in Edit Mode share one copy, because making copies is slow."""
    return current_mesh(source) if source.data in edited else nullcontext()


def find_source(model: Model) -> bpy.types.Object | None:
    """Return the object that the model was read from; None if it was deleted or renamed."""
    return next((candidate for candidate in bpy.data.objects if candidate.name_full == model.name), None)


def is_as_read(model: Model) -> bool:
    """Return whether the model's object is still the mesh that was read. Works in any mode."""
    source = find_source(model)
    return source is not None and source.type == "MESH" and not has_changed(source, model.state, read_anew)


def check_current(context: bpy.types.Context, models: list[Model], settings: RunSettings) -> None:
    """Raises ObjectError if an object has changed since it was read, or if its results can no longer be written."""
    context.view_layer.update()
    edited = edited_meshes(context)
    with ExitStack() as copies:
        for source in filter(None, map(find_source, models)):
            copies.enter_context(_one_copy(source, edited))
        changed = [model.facts.object for model in models if not is_as_read(model)]
        if changed:
            sentence = f"{quoted(changed)} changed during the run, so nothing was written. Flatten again."
            raise object_error("changed", sentence)
        for model in models:
            if model.issue is None:
                check_target(find_source(model), not settings.use_modifiers, edited)


def _read(
    source: bpy.types.Object,
    depsgraph: bpy.types.Depsgraph,
    units: LengthText,
    allowance: float,
    settings: RunSettings,
    edited: Collection[bpy.types.Mesh],
) -> Model:
    """Return the model read from this object. allowance: the default allowance, in Blender units."""
    use_modifiers = settings.use_modifiers
    facts = Facts(
        object=source.name,
        mesh=source.data.name,
        with_modifiers=use_modifiers,
        shaped_by=shaped_by(source, depsgraph),
        counts=_counts(source, edited),
    )
    arrays = known = seams = state = solved = by_map = issue = None
    try:
        check_target(source, not use_modifiers, edited)
        base = marked_mesh(source)
        arrays = object_to_arrays(source, base, depsgraph if use_modifiers else None)
        widest = max(arrays.allowance, allowance)
        arrays = replace(arrays, allowance=widest, default_allowance=allowance, lengths=units)
        # The mesh may lack the ids of this object's last run: results with modifiers are not written to it, and objects
        # that share it overwrite each other's ids. The flat pieces have these ids.
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


def _counts(source: bpy.types.Object, edited: Collection[bpy.types.Mesh]) -> dict[str, int]:
    """Return the present numbers of elements."""
    # If a mesh is in Edit Mode in another view layer, the numbers before Edit Mode are returned. Reading its data of
    # Edit Mode would crash Blender.
    if source.data not in edited:
        return element_counts(source.data)
    with current_mesh(source) as mesh:
        return element_counts(mesh)


def solved_pieces(source: bpy.types.Object) -> tuple[Cache, Cache]:
    """Return the object's caches: one for its pieces, and one for the pieces of the attempt with its UV seams."""
    state = state_of(source)
    if state.solved is None:
        state.solved, state.solved_by_map = Cache(), Cache()
    return state.solved, state.solved_by_map
