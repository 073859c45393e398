# SPDX-License-Identifier: GPL-3.0-or-later
"""Defines colors that people with any color vision can distinguish, and the scale of stretch. Needs only numpy."""

from __future__ import annotations

import numpy as np


def linear(hex_color: str) -> np.ndarray:
    """Return Blender's linear RGBA of a screen color "#rrggbb"."""
    srgb = np.array([int(hex_color[k : k + 2], 16) for k in (1, 3, 5)]) / 255
    rgb = np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)
    return np.append(rgb, 1.0)


PAPER = linear("#ffffff")
MODEL = linear("#e3ded4")
INSIDE = linear("#8d8a85")
INK = linear("#22262e")
FAINT_INK = linear("#6b7078")
SEAM = linear("#22262e")
# colors of wires by kind, as the add-on draws them, and colors of their rims, which contrast with any background
RIGID, ELASTIC, FREE = (linear(color) for color in ("#0048e8", "#ffc400", "#4fc3f7"))
LIGHT_RIM, DARK_RIM = linear("#ffffff"), linear("#3a3a3a")

# colors of compressed, unchanged and stretched fabric: from blue over near white to orange
_SCALE = [linear(c) for c in ("#08519c", "#5a9bd4", "#f6f4ef", "#f2a03d", "#a63c06")]


def stretch_colors(stretch: np.ndarray, limit: float) -> np.ndarray:
    """Return linear colors (..., 4) of relative stretch. Beyond -limit and limit, the colors are constant."""
    at = np.clip(np.asarray(stretch) / limit, -1, 1)
    stops = np.linspace(-1, 1, len(_SCALE))
    return np.stack([np.interp(at, stops, [color[k] for color in _SCALE]) for k in range(4)], axis=-1)


def lit(normals: np.ndarray, color: np.ndarray) -> np.ndarray:
    """Return the color (..., 4) of fabric in soft light from the upper left.

    normals (..., 3): unit vectors; z points toward the viewer.
    """
    lamp = np.array([-0.35, 0.55, 0.76])
    share = 0.30 + 0.70 * np.clip(0.15 + 0.85 * normals @ lamp, 0, 1)
    return np.concatenate([share[..., None] * color[:3], np.ones((*normals.shape[:-1], 1))], axis=-1)


def round_limit(stretch: np.ndarray) -> float:
    """Return a round end of the scale, from 1% to 50%. If possible, at most 1% of the values are beyond it."""
    needed = np.quantile(np.abs(stretch), 0.99)
    return next((limit for limit in (0.01, 0.02, 0.05, 0.1, 0.2, 0.3) if needed <= limit), 0.5)
