# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps values to colors that differ in lightness or between warm and cold, so that color-blind people can read them."""

import math
from dataclasses import dataclass
from functools import cache

import numpy as np

# These linear RGB colors are at equal steps from no distortion to the upper end: near white, yellow, orange, red, dark.
_RISING = ((0.93, 0.93, 0.90), (0.98, 0.80, 0.35), (0.93, 0.42, 0.10), (0.65, 0.07, 0.08), (0.18, 0.01, 0.09))
# These linear RGB colors are at equal steps from compressed through unchanged to stretched: blue, near white, orange.
_TWO_SIDED = ((0.002, 0.08, 0.33), (0.10, 0.33, 0.66), (0.92, 0.90, 0.86), (0.89, 0.35, 0.05), (0.38, 0.05, 0.002))
STEPS = 4096  # number of colors of a scale, more than the eye can distinguish


@cache
def _colors(stops: tuple[tuple[float, float, float], ...]) -> np.ndarray:
    """Return a table of colors (STEPS + 1,4) at equal steps, float32. Looking up colors in the table is 20 times as
    fast as interpolating them."""
    colors, place = np.ones((STEPS + 1, 4), dtype=np.float32), np.linspace(0, len(stops) - 1, STEPS + 1)
    for channel, values in enumerate(np.array(stops).T):
        colors[:, channel] = np.interp(place, np.arange(len(stops)), values)
    return colors


@dataclass(frozen=True)
class ColorMap:
    """A color attribute of the flat mesh and the values at the two ends of its scale."""

    attribute: str
    label: str
    low: float
    high: float
    is_percent: bool = False
    is_angle: bool = False  # values are radians, written as degrees
    stops: tuple[tuple[float, float, float], ...] = _RISING

    def colors(self, values: np.ndarray) -> np.ndarray:
        """Return linear RGBA (k,4), float32. Values beyond the scale get the color of its end."""
        steps = (values - self.low) * (STEPS / (self.high - self.low)) + 0.5
        return _colors(self.stops).take(np.fmin(np.fmax(steps, 0), STEPS).astype(np.intp), axis=0)

    def number(self, value: float, digits: int = 4) -> str:
        """Return the text of a value, with a sign if the scale has two sides."""
        sign = "+" if self.low < 0 < value else ""
        if self.is_angle:
            return f"{math.degrees(value):.{digits}g}°"
        return f"{sign}{100 * value:.{digits}g}%" if self.is_percent else f"{sign}{value:.{digits}g}"


# The scales have fixed ends, so that the colors of different models can be compared.
ASPECT_RATIO = ColorMap("aspect_ratio_color", "Worst direction, as a factor", 1.0, 1.5)
STRETCH = ColorMap("stretch_color", "Stretch, mean of all directions", -0.1, 0.1, is_percent=True, stops=_TWO_SIDED)
LENGTH_VARIATION = ColorMap("length_variation_color", "Change of length", 0.0, 0.1, is_percent=True)
ARAP_ENERGY = ColorMap("arap_energy_color", "Distortion", 0.0, 0.1)
WEFT = ColorMap("weft_strain_color", "Across the grain", -0.1, 0.1, is_percent=True, stops=_TWO_SIDED)
WARP = ColorMap("warp_strain_color", "Along the grain", -0.1, 0.1, is_percent=True, stops=_TWO_SIDED)
# The scale ends at the angle at which the threads of a plain weave lock.
SHEAR = ColorMap("shear_angle_color", "Shear", 0.0, math.radians(45), is_angle=True)
CLOTH_MAPS = (WEFT, WARP, SHEAR)
COLOR_MAPS = (ASPECT_RATIO, STRETCH, LENGTH_VARIATION, ARAP_ENERGY, *CLOTH_MAPS)
NO_LAYOUT = np.array([0.16, 0.18, 0.22, 1.0], dtype=np.float32)  # differs from all colors of the scales
