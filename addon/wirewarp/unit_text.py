# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths as text in the scene's units. Unit Scale changes the text, never the numbers behind it."""

from dataclasses import dataclass

import bpy

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
# Areas in square millimeters would be numbers of six digits: unit of the area, and how many of ours it is long.
_AREA_UNITS = {"mm": ("cm", 10.0), "um": ("cm", 1e4), "thou": ("in", 1000.0)}
_DECIMALS = {"mm": 2, "cm": 3, "m": 4, "in": 3}
_AREA_DECIMALS = {"mm": 1, "um": 1, "cm": 1, "in": 2, "thou": 2, "ft": 3}


@dataclass(frozen=True)
class LengthText:
    """Writes lengths given in Blender units; all in one unit, so that a column of numbers can be compared."""

    unit: str
    per_blender_unit: float

    def __call__(self, length: float) -> str:
        return f"{self.number(length)} {self.unit}".rstrip()

    def number(self, length: float) -> str:
        return f"{length * self.per_blender_unit:.{_DECIMALS.get(self.unit, 4)}f}"

    def difference(self, length: float) -> str:
        """A signed difference; what rounds to nothing has no sign."""
        text = self.number(length)
        return text.removeprefix("-") if float(text) == 0 else f"{float(text):+.{_DECIMALS.get(self.unit, 4)}f}"

    @property
    def area_unit(self) -> str:
        unit, _ = self._area_scale()
        return f"{unit}²" if unit else ""

    @property
    def area_per_blender_unit(self) -> float:
        """How many of our areas one square Blender unit is."""
        _, scale = self._area_scale()
        return (self.per_blender_unit / scale) ** 2

    def area(self, area: float) -> str:
        """Of an area in square Blender units."""
        number = f"{area * self.area_per_blender_unit:.{_AREA_DECIMALS.get(self.unit, 4)}f}"
        return f"{number} {self.area_unit}".rstrip()

    def _area_scale(self) -> tuple[str, float]:
        return _AREA_UNITS.get(self.unit, (self.unit, 1.0))


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
