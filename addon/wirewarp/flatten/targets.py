# SPDX-License-Identifier: GPL-3.0-or-later
"""Which objects a command works on, and whether their data may be written."""

import bpy
import numpy as np

from ..blender.objects import check_local, linear_part, metric
from ..issues import Issue, ObjectError, object_error
from ..state.flat_pieces import is_flat_mesh
from ..state.marked_mesh import check_attributes, check_id_room
from ..state.owners import DELETED, check_not_edited, is_deleted, model_of, model_or_self
from .uv import check_uv_room

CONVERTIBLE = {"CURVE", "SURFACE", "META", "FONT"}


def mesh_targets(context: bpy.types.Context) -> list[bpy.types.Object]:
    """Every selected mesh and every mesh in Edit Mode, or else the active one; of flat pieces, their model."""
    edited = list(context.objects_in_mode) if context.mode == "EDIT_MESH" else []
    models = (_model(context, each) for each in [*edited, *context.selected_objects])
    chosen = list(dict.fromkeys(filter(None, models)))
    return chosen or ([] if context.selected_objects else active_target(context))


def active_target(context: bpy.types.Context) -> list[bpy.types.Object]:
    """The active object alone, or its model, if it can be seen."""
    active = context.view_layer.objects.active
    model = _model(context, active) if active and active.visible_get() else None
    return [model] if model else []


def _model(context: bpy.types.Context, target: bpy.types.Object) -> bpy.types.Object | None:
    """What is flattened where this is selected; None if it is no mesh, or its model is not there."""
    model = model_or_self(target)
    is_there = model.name_full in context.view_layer.objects or model == target
    return model if model.type == "MESH" and model_of(model) is None and is_there else None


def nothing_to_flatten(context: bpy.types.Context, sources: list[bpy.types.Object]) -> str:
    """Why nothing can be flattened, as a sentence; empty if it can."""
    if context.scene.library:
        return (
            f'Nothing to flatten: the scene "{context.scene.name}" is linked from another file and cannot take flat '
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


def check_target(target: bpy.types.Object, writes_model: bool) -> None:
    """Raises ObjectError if the results cannot be written. writes_model: to the base mesh too.

    All that can refuse is asked here, before the first of them is written. Of an object in Object Mode.
    """
    linear_part(target)
    check_not_edited(target)
    if is_flat_mesh(target.data):
        raise object_error(
            "flat_pieces",
            f'"{target.name}" holds flat pieces, and their model was deleted: bring it back, or select another one. To '
            'flatten them as they are, delete the attribute "source_vertex" under Object Data > Attributes.',
        )
    check_local(target, target)
    if writes_model:
        check_local(target, target.data)
    check_attributes(target.data)
    if writes_model:
        check_id_room(target)
        check_uv_room(target)
        _check_users(target)


def _check_users(target: bpy.types.Object) -> None:
    """One UV layer cannot be true for objects of different scale."""
    own = metric(target)
    for other in bpy.data.objects:
        shares = other.data == target.data and other.users_scene  # what is in no scene has no true scale
        if shares and not np.allclose(metric(other), own, rtol=1e-5, atol=1e-5 * np.abs(own).max()):
            sentence = (
                f'"{target.name}" and "{other.name}" share the mesh "{target.data.name}" but differ in scale, or one '
                "is mirrored, and one UV map cannot be true for both: use Object > Relations > Make Single User > "
                "Object & Data."
            )
            raise ObjectError(Issue("multi_user_scale", sentence))
