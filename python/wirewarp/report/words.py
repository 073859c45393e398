# SPDX-License-Identifier: GPL-3.0-or-later
"""Words for counts, names, tolerances, lengths and areas."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

# Areas in square millimeters would have six digits: unit of the area, and its side in units of length.
_AREA_UNITS = {"mm": ("cm", 10.0), "um": ("cm", 1e4), "thou": ("in", 1000.0)}
_DECIMALS = {"mm": 2, "cm": 3, "m": 4, "in": 3}
_AREA_DECIMALS = {"mm": 1, "um": 1, "cm": 1, "in": 2, "thou": 2, "ft": 3}


def counted(count: int, one: str, many: str = "") -> str:
    """Return "1 edge", "2 edges". many: the plural, such as "edges lie", if it is not the noun with an s."""
    return f"{count} {one if count == 1 else many or f'{one}s'}"


def quoted(names: Iterable[str]) -> str:
    """Return "Front", "Back": each in quotation marks."""
    return ", ".join(f'"{name}"' for name in names)


def paragraph(sentences: Iterable[str]) -> str:
    """Return one line with a period after each sentence: Blender's status bar drops line breaks."""
    return " ".join(each if each.endswith((".", "?", ":")) else f"{each}." for each in sentences)


def ease_text(ease: float) -> str:
    """Return "+5%", "-2.5%"."""
    return f"{100 * ease:+.3g}%"


def wire_text(tolerance: float, ease: float) -> str:
    """Return the text of a wire with its ease, if it has one: "±3%", "+5%", "+5% ±3%", "free"."""
    if ease == 0 or math.isinf(tolerance):
        return tolerance_text(tolerance)
    return ease_text(ease) if tolerance == 0 else f"{ease_text(ease)} {tolerance_text(tolerance)}"


def tolerance_text(tolerance: float) -> str:
    """Return the text of a rigid, an elastic or a free wire: "rigid", "±3%", "free"."""
    if tolerance == 0:
        return "rigid"
    return "free" if math.isinf(tolerance) else f"±{100 * tolerance:.3g}%"


@dataclass(frozen=True)
class LengthText:
    """Writes lengths given in Blender units. All but rough() use one unit, so that columns of numbers compare well."""

    unit: str
    per_blender_unit: float

    def __call__(self, length: float) -> str:
        return f"{self.number(length)} {self.unit}".rstrip()

    def number(self, length: float) -> str:
        return f"{length * self.per_blender_unit:.{_DECIMALS.get(self.unit, 4)}f}"

    def difference(self, length: float) -> str:
        """Return a signed difference; zero has no sign."""
        text = self.number(length)
        return text.removeprefix("-") if float(text) == 0 else f"{float(text):+.{_DECIMALS.get(self.unit, 4)}f}"

    def rough(self, length: float) -> str:
        """Return the length with three digits: "39.4 mm", "2.31 m"."""
        number, unit = float(f"{length * self.per_blender_unit:.3g}"), self.unit
        if unit == "mm" and abs(number) >= 1000:
            number, unit = number / 1000, "m"
        return f"{number:.10g} {unit}".rstrip()

    @property
    def area_unit(self) -> str:
        unit, _ = self._area_scale()
        return f"{unit}²" if unit else ""

    @property
    def area_per_blender_unit(self) -> float:
        """Return the area of one square Blender unit in this unit of area."""
        _, scale = self._area_scale()
        return (self.per_blender_unit / scale) ** 2

    def area(self, area: float) -> str:
        """Return the text of an area in square Blender units."""
        number = f"{area * self.area_per_blender_unit:.{_AREA_DECIMALS.get(self.unit, 4)}f}"
        return f"{number} {self.area_unit}".rstrip()

    def _area_scale(self) -> tuple[str, float]:
        return _AREA_UNITS.get(self.unit, (self.unit, 1.0))
