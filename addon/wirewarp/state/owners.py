# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the model of flat pieces and the flat pieces of a model.

The functions check the stored pointer from flat pieces to their model. Scripts and users may have changed the pointer,
or converted or replaced objects.
"""

from collections.abc import Collection

import bpy

from ..blender.objects import name_with
from ..issues import object_error

DELETED = (
    'You deleted their model "{}". Press Ctrl+Z to get it back, or select another model. The file keeps a hidden copy '
    "until you delete these pieces, too."
)


def model_of(target: bpy.types.Object) -> bpy.types.Object | None:
    """Return the model of these flat pieces; None for other objects."""
    model = target.wirewarp_source
    are_meshes = target.type == "MESH" and model is not None and model.type == "MESH"
    return model if are_meshes and model != target else None


def model_or_self(target: bpy.types.Object) -> bpy.types.Object:
    """Return the model of a flat object, otherwise the object itself."""
    return model_of(target) or target


def is_deleted(model: bpy.types.Object) -> bool:
    """Return whether the user has deleted this model of flat pieces. It stays in the file while its pieces exist."""
    return not model.users_scene


def find_flat_object(source: bpy.types.Object) -> bpy.types.Object | None:
    """Return the flat object of this model; None if there is none. If there are copies, the object named
    flat_name() is preferred."""
    named = bpy.data.objects.get(flat_name(source.name))
    if named and model_of(named) == source:  # the name is tried first, because a file may have thousands of objects
        return named
    return next((candidate for candidate in bpy.data.objects if model_of(candidate) == source), None)


def flat_name(model_name: str) -> str:
    return name_with(model_name, " Flat")


def has_flat_object(source: bpy.types.Object) -> bool:
    """Return whether the model has flat pieces that the user has not deleted."""
    flat = find_flat_object(source)
    return flat is not None and bool(flat.users_scene)


def is_earlier(target: bpy.types.Object) -> bool:
    """Return whether the object contains flat pieces that the next run does not change: a copy, or pieces that were
    separated from the flat object."""
    model = model_of(target)
    return model is not None and target != find_flat_object(model) and bool(target.users_scene)


def earlier_sentence(target: bpy.types.Object) -> str:
    flat = find_flat_object(model_of(target))
    return f'"{target.name}" is a copy or a part of earlier pieces. Use "{flat.name}", and delete "{target.name}".'


def check_not_edited(target: bpy.types.Object, handled: Collection[bpy.types.Mesh] = ()) -> None:
    """Raises ObjectError if the mesh of the model or of its pieces is in Edit Mode, which hides attributes.

    handled: meshes that may be in Edit Mode, because the caller reads and writes them there
    """
    # In other scenes and windows, meshes stay in Edit Mode even within in_object_mode.
    for each in filter(None, [target, find_flat_object(target)]):
        if each.data.is_editmode and each.data not in handled:
            raise object_error(
                "edited_elsewhere",
                f'The mesh "{each.data.name}" is being edited in another scene or view layer. Leave Edit Mode there '
                "first.",
            )
