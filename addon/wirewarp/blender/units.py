# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths as text in the scene's units. Unit Scale changes the text, never the numbers behind it."""

import bpy

from ..words import LengthText

_UNITS = {
    "KILOMETERS": "km",
    "METERS": "m",
    "CENTIMETERS": "cm",
    "MILLIMETERS": "mm",
    "MICROMETERS": "um",
    "MILES": "mi",
    "FEET": "ft",
    "INCHES": "in",
    "THOU": "thou",
}
# Cutters work in these; metres only where the scene asks for them.
_ADAPTIVE = {"METRIC": "mm", "IMPERIAL": "in"}


def length_text(scene: bpy.types.Scene) -> LengthText:
    settings = scene.unit_settings
    if settings.system == "NONE":
        return LengthText("", 1.0)
    unit = _UNITS.get(settings.length_unit) or _ADAPTIVE[settings.system]
    meters = bpy.utils.units.to_value(settings.system, "LENGTH", f"1{unit}")
    return LengthText(unit, settings.scale_length / meters)


def meters_per_blender_unit(scene: bpy.types.Scene) -> float:
    """What the JSON report states metres by; with no unit system one Blender unit is one metre."""
    return scene.unit_settings.scale_length if scene.unit_settings.system != "NONE" else 1.0
