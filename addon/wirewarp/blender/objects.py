# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects and their names: may they be changed, and how they are removed and shown."""

from collections.abc import Iterator

import bpy
import numpy as np

from ..issues import object_error

LONGEST = 255 if bpy.app.version >= (5, 0, 0) else 63  # bytes; Blender cuts what is longer


def remove_object(target: bpy.types.Object) -> None:
    """With its data, unless other objects, which may be the user's copies, use that too."""
    data = target.data
    bpy.data.objects.remove(target)
    if data.users == 0:
        bpy.data.batch_remove([data])


def name_with(name: str, ending: str) -> str:
    """The name, cut so that the ending fits behind it: by that users and scripts know what it is."""
    room = LONGEST - len(ending.encode())
    return name.encode()[:room].decode(errors="ignore") + ending


def show_where_shown(source: bpy.types.Object, target: bpy.types.Object) -> None:
    """Adds the target to every local view that shows the source; new objects are in all of them anyway."""
    for window in bpy.context.window_manager.windows:
        present = window.view_layer.objects.values()
        for view in _local_views(window) if source in present and target in present else ():
            # Not local_view_get, which is always False in Blender 3.4.
            if source.visible_get(view_layer=window.view_layer, viewport=view):
                target.local_view_set(view, True)


def _local_views(window: bpy.types.Window) -> Iterator[bpy.types.SpaceView3D]:
    for area in window.screen.areas:
        if area.type == "VIEW_3D" and area.spaces.active.local_view:
            yield area.spaces.active


def check_local(target: bpy.types.Object, written: bpy.types.Object | bpy.types.Mesh) -> None:
    """Raises ObjectError if the object, or its mesh, whichever is to be written, belongs to another file."""
    remedy = "make it local with Object > Relations > Make Local > Selected Objects and Data."
    if written.library is not None:
        raise object_error(
            "linked_data", f'"{target.name}" is linked from another file and cannot be changed in this one: {remedy}'
        )
    if written.override_library is not None:
        raise object_error(
            "library_override",
            f'"{target.name}" is a library override, and what would be written to it is lost when the file is opened '
            f"again: {remedy}",
        )


def linear_part(source: bpy.types.Object) -> np.ndarray:
    """Rotation, scale and shear of the object, (3,3). Raises ObjectError if it squashes the mesh flat."""
    linear = np.array(source.matrix_world, dtype=np.float64)[:3, :3]
    lengths = np.linalg.norm(linear, axis=0)
    if not np.isfinite(linear).all() or lengths.min() == 0 or abs(np.linalg.det(linear / lengths)) < 1e-6:
        raise object_error(
            "zero_scale",
            f'"{source.name}" is scaled to zero along an axis, so its faces have no size: '
            "set its scale (N panel > Item) to something else.",
        )
    return linear


def metric(source: bpy.types.Object) -> np.ndarray:
    """What the object's matrix does to lengths, and whether it mirrors: the same for all rotations."""
    linear = np.array(source.matrix_world, dtype=np.float64)[:3, :3]
    return np.append((linear.T @ linear).ravel(), np.linalg.det(linear))
