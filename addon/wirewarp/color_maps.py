# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures to colours: pale where nothing is distorted, dark red where much is; told apart without hue. No Blender."""

from dataclasses import dataclass

import numpy as np

# Linear RGB at equal steps from no distortion to the map's upper end: near white, yellow, orange, red, dark.
_STOPS = np.array(
    [(0.93, 0.93, 0.90), (0.98, 0.80, 0.35), (0.93, 0.42, 0.10), (0.65, 0.07, 0.08), (0.18, 0.01, 0.09)],
    dtype=np.float32,
)


@dataclass(frozen=True)
class ColorMap:
    """A colour attribute of the flat mesh and the values at the two ends of its scale."""

    attribute: str
    low: float
    high: float

    def colors(self, values: np.ndarray) -> np.ndarray:
        """(k,4) float32 linear RGBA; values beyond the scale get its end's colour."""
        place = np.clip((values - self.low) / (self.high - self.low), 0, 1) * (len(_STOPS) - 1)
        lower = np.minimum(place.astype(np.int32), len(_STOPS) - 2)
        share = (place - lower).astype(np.float32)[:, None]
        rgb = _STOPS[lower] * (1 - share) + _STOPS[lower + 1] * share
        return np.column_stack([rgb, np.ones(len(rgb), dtype=np.float32)]).astype(np.float32)


ARAP_ENERGY = ColorMap("arap_energy_color", 0.0, 0.1)  # energy by area
ASPECT_RATIO = ColorMap("aspect_ratio_color", 1.0, 1.5)
LENGTH_VARIATION = ColorMap("length_variation_color", 0.0, 0.1)
COLOR_MAPS = (ASPECT_RATIO, ARAP_ENERGY, LENGTH_VARIATION)
NO_LAYOUT = np.array([0.16, 0.18, 0.22, 1.0], dtype=np.float32)  # on none of the scales
