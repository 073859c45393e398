# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths as the scene shows them, and models whose size shows that their unit was lost."""

from collections.abc import Sequence

import bpy
from mathutils import Vector

from ..words import LengthText

_UNITS = {
    "KILOMETERS": "km",
    "CENTIMETERS": "cm",
    "MILLIMETERS": "mm",
    "MICROMETERS": "um",
    "MILES": "mi",
    "INCHES": "in",
    "THOU": "thou",
}
# Cutters work in these: also in a new file, where Blender shows meters or feet.
_CUTTERS = {"METRIC": "mm", "IMPERIAL": "in"}


def length_text(scene: bpy.types.Scene) -> LengthText:
    settings = scene.unit_settings
    if settings.system == "NONE":
        return LengthText("", 1.0)
    unit = _UNITS.get(settings.length_unit) or _CUTTERS[settings.system]
    meters = bpy.utils.units.to_value(settings.system, "LENGTH", f"1{unit}")
    return LengthText(unit, settings.scale_length / meters)


def meters_per_blender_unit(scene: bpy.types.Scene) -> float:
    """What the JSON report states metres by; with no unit system one Blender unit is one metre."""
    return scene.unit_settings.scale_length if scene.unit_settings.system != "NONE" else 1.0


SMALLEST, LARGEST = 0.02, 5.0  # meters: from a doll's glove to a sofa's cover
# What one Blender unit may mean, in meters: the units that files are written in, and a tenth, a hundredth and a
# thousandth of a model that was scaled down when it was imported.
# A decimeter is that of MakeHuman.
UNITS = {1.0: "Meters", 0.1: "Decimeters", 0.01: "Centimeters", 0.001: "Millimeters", 0.0254: "Inches"}
UNITS |= {10.0: "10 m", 100.0: "100 m", 1000.0: "1000 m"}
SHOWN = 3  # of the units that would do


def strange_size(target: bpy.types.Object, scene: bpy.types.Scene) -> str:
    """A sentence on a model that is very large or very small; "" for others."""
    largest = max(target.dimensions) * meters_per_blender_unit(scene)
    if largest == 0 or SMALLEST <= largest <= LARGEST:
        return ""
    size = LengthText("m", 1.0).rough(largest) if largest > LARGEST else LengthText("mm", 1000.0).rough(largest)
    return f'"{target.name}" is {size} {"large" if largest > LARGEST else "small"}. Was it modeled in another unit?'


def likely_units(target: bpy.types.Object) -> Sequence[float]:
    """Meters in a Blender unit with which the model has a size to sew, the likeliest first."""
    largest = max(target.dimensions)
    return [unit for unit in UNITS if SMALLEST <= largest * unit <= LARGEST][:SHOWN]


def unit_of_height(target: bpy.types.Object, height: float) -> float | None:
    """Meters in a Blender unit with which the model is so many meters high as it stands; None if it is flat."""
    heights = [(target.matrix_world @ Vector(corner)).z for corner in target.bound_box]
    own = max(heights) - min(heights)
    return height / own if own > 0 else None


def unit_text(target: bpy.types.Object, unit: float) -> str:
    """The unit, and how large the model is then."""
    return f"{UNITS[unit]}: {LengthText('cm', 100.0).rough(max(target.dimensions) * unit)}"
