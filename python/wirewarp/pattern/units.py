# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes lengths and areas in the units that makers use."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

Units = Literal["metric", "imperial"]
INCH = 25.4  # millimeters, by definition
FINEST = 16  # denominator of the smallest fraction of an inch on a tape measure


@dataclass(frozen=True)
class UnitSystem:
    name: Units = "metric"

    def text(self, millimeters: float) -> str:
        """Return a length such as "10 mm", "1.25 m" or "3/8 in". Inches are rounded to the nearest sixteenth."""
        if self.name == "metric":
            return f"{millimeters:.4g} mm" if millimeters < 1000 else f"{millimeters / 1000:.4g} m"
        sixteenths = Fraction(round(millimeters / INCH * FINEST), FINEST)
        whole, rest = divmod(sixteenths, 1)
        return (
            " ".join(part for part in (str(whole) if whole or not rest else "", str(rest) if rest else "") if part)
            + " in"
        )

    def measured(self, millimeters: float) -> str:
        """Return a length with decimals, such as "430.2 mm" or "16.94 in", to compare with a measured length."""
        return f"{millimeters:.1f} mm" if self.name == "metric" else f"{millimeters / INCH:.2f} in"

    def difference_text(self, millimeters: float) -> str:
        """Return a small length such as "0.012 mm" or "0.0005 in", for differences that should be zero."""
        return f"{millimeters:.3f} mm" if self.name == "metric" else f"{millimeters / INCH:.4f} in"

    def area_text(self, square_millimeters: float) -> str:
        """Return an area such as "182.3 cm²" or "28.26 in²"."""
        if self.name == "imperial":
            return f"{square_millimeters / INCH**2:.4g} in²"
        square_meters = square_millimeters / 1e6
        return f"{square_meters:.4g} m²" if square_meters >= 1 else f"{square_millimeters / 100:.4g} cm²"

    def range_of(self, lengths: Sequence[float]) -> str:
        if not lengths:
            return "none"
        low, high = self.text(min(lengths)), self.text(max(lengths))
        return low if low == high else f"{low} to {high}"

    @property
    def square(self) -> tuple[float, str]:
        """Return the side length in millimeters and the label of the test square, which is measured after printing."""
        return (100.0, "100 mm") if self.name == "metric" else (4 * INCH, "4 in")
