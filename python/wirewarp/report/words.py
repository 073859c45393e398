# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes counts, names, tolerances, lengths and areas as texts."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

# For some units of length, areas have a larger unit, because areas in mm² would have six digits. The values are the
# larger unit of length and its length in the smaller unit.
_AREA_UNITS = {"mm": ("cm", 10.0), "um": ("cm", 1e4), "thou": ("in", 1000.0)}
_DECIMALS = {"mm": 2, "cm": 3, "m": 4, "in": 3}
_AREA_DECIMALS = {"mm": 1, "um": 1, "cm": 1, "in": 2, "thou": 2, "ft": 3}


def counted(count: int, one: str, many: str = "") -> str:
    """Return a text such as "1 edge" or "2 edges". many: the plural, if it is not `one` with an s."""
    return f"{count} {one if count == 1 else many or f'{one}s'}"


def quoted(names: Iterable[str]) -> str:
    """Return the names in quotation marks, such as '"Front", "Back"'."""
    return ", ".join(f'"{name}"' for name in names)


def paragraph(sentences: Iterable[str]) -> str:
    """Return the sentences in one line, because Blender's status bar would drop line breaks. Add missing periods."""
    return " ".join(each if each.endswith((".", "?", ":")) else f"{each}." for each in sentences)


def ease_text(ease: float) -> str:
    """Return an ease, which is a fraction, as a text such as "+5%" or "-2.5%"."""
    return f"{100 * ease:+.3g}%"


def wire_text(tolerance: float, ease: float) -> str:
    """Return the ease and the tolerance of a wire as a text such as "rigid", "±3%", "+5%", "+5% ±3%" or "free"."""
    if ease == 0 or math.isinf(tolerance):
        return tolerance_text(tolerance)
    return ease_text(ease) if tolerance == 0 else f"{ease_text(ease)} {tolerance_text(tolerance)}"


def tolerance_text(tolerance: float) -> str:
    """Return a tolerance as a text: "rigid", "free", or for an elastic wire a text such as "±3%"."""
    if tolerance == 0:
        return "rigid"
    return "free" if math.isinf(tolerance) else f"±{100 * tolerance:.3g}%"


@dataclass(frozen=True)
class LengthText:
    """Writes lengths that are given in Blender units.

    All methods except rough() use the same unit, so that numbers in a column can be compared.
    """

    unit: str
    per_blender_unit: float

    def __call__(self, length: float) -> str:
        return f"{self.number(length)} {self.unit}".rstrip()

    def number(self, length: float) -> str:
        return f"{length * self.per_blender_unit:.{_DECIMALS.get(self.unit, 4)}f}"

    def difference(self, length: float) -> str:
        """Return the number of a difference, with a sign if it is not zero."""
        text = self.number(length)
        return text.removeprefix("-") if float(text) == 0 else f"{float(text):+.{_DECIMALS.get(self.unit, 4)}f}"

    def rough(self, length: float) -> str:
        """Return the length with three digits, such as "39.4 mm" or "2.31 m"."""
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
        """Return the area of one square Blender unit in the unit `area_unit`."""
        _, scale = self._area_scale()
        return (self.per_blender_unit / scale) ** 2

    def area(self, area: float) -> str:
        """Return the text of an area in square Blender units."""
        number = f"{area * self.area_per_blender_unit:.{_AREA_DECIMALS.get(self.unit, 4)}f}"
        return f"{number} {self.area_unit}".rstrip()

    def _area_scale(self) -> tuple[str, float]:
        return _AREA_UNITS.get(self.unit, (self.unit, 1.0))
