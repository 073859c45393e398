# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions for objects, their names, matrices and sizes, and for lengths in the scene's units."""

from collections.abc import Iterator, Sequence

import bpy
import numpy as np
from mathutils import Vector

from ..core import LengthText
from ..issues import object_error

LONGEST = 255 if bpy.app.version >= (5, 0, 0) else 63  # bytes; Blender cuts longer names


def remove_object(target: bpy.types.Object) -> None:
    """Remove the object with its data, unless another object, such as the user's copy, also uses that data."""
    data = target.data
    bpy.data.objects.remove(target)
    if data.users == 0:
        bpy.data.batch_remove([data])


def name_with(name: str, ending: str) -> str:
    """Return the name with the ending. Long names are cut first, so that Blender does not cut the ending."""
    room = LONGEST - len(ending.encode())
    return name.encode()[:room].decode(errors="ignore") + ending


def show_where_shown(source: bpy.types.Object, target: bpy.types.Object) -> None:
    """Add the target to every local view that shows the source, because Blender adds only new objects to
    local views."""
    for window in bpy.context.window_manager.windows:
        present = window.view_layer.objects.values()
        for view in _local_views(window) if source in present and target in present else ():
            # local_view_get is not used, because it always returns False in Blender 3.4.
            if source.visible_get(view_layer=window.view_layer, viewport=view):
                target.local_view_set(view, True)


def _local_views(window: bpy.types.Window) -> Iterator[bpy.types.SpaceView3D]:
    for area in window.screen.areas:
        if area.type == "VIEW_3D" and area.spaces.active.local_view:
            yield area.spaces.active


def check_local(target: bpy.types.Object, written: bpy.types.Object | bpy.types.Mesh) -> None:
    """Raises ObjectError if the object or mesh to be written belongs to another file."""
    remedy = "make it local with Object > Relations > Make Local > Selected Objects and Data."
    if written.library is not None:
        raise object_error(
            "linked_data", f'"{target.name}" is linked from another file and cannot be changed in this file: {remedy}'
        )
    if written.override_library is not None:
        raise object_error(
            "library_override",
            f'"{target.name}" is a library override, and changes to it are lost when the file is opened again: '
            f"{remedy}",
        )


def linear_part(source: bpy.types.Object) -> np.ndarray:
    """Return rotation, scale and shear of the object, (3,3). Raises ObjectError if the scale along an axis is zero."""
    linear = np.array(source.matrix_world, dtype=np.float64)[:3, :3]
    lengths = np.linalg.norm(linear, axis=0)
    if not np.isfinite(linear).all() or lengths.min() == 0 or abs(np.linalg.det(linear / lengths)) < 1e-6:
        raise object_error(
            "zero_scale",
            f'"{source.name}" is scaled to zero along an axis, so its faces have no size. '
            "Set a scale other than 0 in the sidebar (N) under Item.",
        )
    return linear


def world_box(target: bpy.types.Object) -> np.ndarray:
    """Return the lowest and the highest corner (2,3) of the object's bounding box in the world."""
    corners = np.array([target.matrix_world @ Vector(corner) for corner in target.bound_box])
    return np.array([corners.min(axis=0), corners.max(axis=0)])


def metric(source: bpy.types.Object) -> np.ndarray:
    """Return ten numbers (10,) about how the object's matrix scales, shears and mirrors. Rotations do not change
    these numbers."""
    linear = np.array(source.matrix_world, dtype=np.float64)[:3, :3]
    return np.append((linear.T @ linear).ravel(), np.linalg.det(linear))


_UNITS = {
    "KILOMETERS": "km",
    "CENTIMETERS": "cm",
    "MILLIMETERS": "mm",
    "MICROMETERS": "um",
    "MILES": "mi",
    "INCHES": "in",
    "THOU": "thou",
}
# New files use meters or feet. Lengths are shown in mm or inches instead, because fabric is cut in these units.
_CUTTERS = {"METRIC": "mm", "IMPERIAL": "in"}


def length_text(scene: bpy.types.Scene) -> LengthText:
    """Return the format of lengths in the scene's unit. mm or inches replace meters, feet and adaptive units."""
    settings = scene.unit_settings
    if settings.system == "NONE":
        return LengthText("", 1.0)
    unit = _UNITS.get(settings.length_unit) or _CUTTERS[settings.system]
    meters = bpy.utils.units.to_value(settings.system, "LENGTH", f"1{unit}")
    return LengthText(unit, settings.scale_length / meters)


def meters_per_blender_unit(scene: bpy.types.Scene) -> float:
    """Return the length of one Blender unit in meters, or 1 without a unit system."""
    return scene.unit_settings.scale_length if scene.unit_settings.system != "NONE" else 1.0


SMALLEST, LARGEST = 0.02, 5.0  # sizes that can be sewn, in meters: from a doll's glove to the cover of a sofa
# Possible lengths of one Blender unit, in meters. The first are the usual units of files (MakeHuman uses decimeters).
# The others are for models that were scaled down by 10, 100 or 1000 when they were imported.
UNITS = {1.0: "Meters", 0.1: "Decimeters", 0.01: "Centimeters", 0.001: "Millimeters", 0.0254: "Inches"}
UNITS |= {10.0: "10 m", 100.0: "100 m", 1000.0: "1000 m"}
SHOWN = 3  # number of possible units shown: sizes that can be sewn differ by a factor of 250, three powers of ten


def strange_size(target: bpy.types.Object, scene: bpy.types.Scene) -> str:
    """Return a sentence about a very large or very small model; "" for other models."""
    largest = max(target.dimensions) * meters_per_blender_unit(scene)
    if largest == 0 or SMALLEST <= largest <= LARGEST:
        return ""
    size = LengthText("m", 1.0).rough(largest) if largest > LARGEST else LengthText("mm", 1000.0).rough(largest)
    return f'"{target.name}" measures {size}. Was it modeled in another unit?'


def size_text(target: bpy.types.Object, scene: bpy.types.Scene) -> str:
    largest = max(target.dimensions) * meters_per_blender_unit(scene)
    return f'"{target.name}" now measures {LengthText("cm", 100.0).rough(largest)}.'


def likely_units(target: bpy.types.Object) -> Sequence[float]:
    """Return up to SHOWN possible lengths of a Blender unit in meters, the likeliest first. With each of them, the
    model has a size that can be sewn."""
    largest = max(target.dimensions)
    return [unit for unit in UNITS if SMALLEST <= largest * unit <= LARGEST][:SHOWN]


def height_of(target: bpy.types.Object) -> float:
    """Return the height of the bounding box in Blender units."""
    return float(np.ptp(world_box(target)[:, 2]))


def unit_text(target: bpy.types.Object, unit: float) -> str:
    """Return the name of the unit, and the size that the model has if it was modeled in this unit. unit: its length in
    meters."""
    return f"{UNITS[unit]}: {LengthText('cm', 100.0).rough(max(target.dimensions) * unit)}"
