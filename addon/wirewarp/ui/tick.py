# SPDX-License-Identifier: GPL-3.0-or-later
"""A green tick: Blender's own icons take the color of the text."""

import bpy.utils.previews
import numpy as np

SIZE, THICKNESS = 64, 0.11  # pixels; half the width of the stroke as a share of them
STROKE = np.array([[0.16, 0.50], [0.40, 0.25], [0.86, 0.76]])  # from the left; y up
GREEN = (0.30, 0.78, 0.33)
_previews: bpy.utils.previews.ImagePreviewCollection | None = None


def green_tick() -> int:
    """Its icon_value; 0, no icon, while the add-on is not registered and where Blender has no window."""
    return _previews["tick"].icon_id if _previews else 0


def mark_of(ok: bool, is_strained: bool = False) -> dict:
    """The arguments of a label: a cross for what failed, a warning for cloth that can hardly follow, or the tick."""
    if not ok:
        return {"icon": "CANCEL"}
    return {"icon": "ERROR"} if is_strained else {"icon_value": green_tick()}


def attach() -> None:
    global _previews
    _previews = bpy.utils.previews.new()
    tick = _previews.new("tick")
    tick.icon_size = (SIZE, SIZE)
    tick.icon_pixels_float = _pixels().ravel().tolist()


def detach() -> None:
    global _previews
    bpy.utils.previews.remove(_previews)
    _previews = None


def _pixels() -> np.ndarray:
    """(SIZE, SIZE, 4) RGBA with the colors times alpha, as Blender draws icons; the lowest row first."""
    x, y = np.meshgrid(*2 * [(np.arange(SIZE) + 0.5) / SIZE])
    points = np.stack([x, y], axis=-1)
    distance = np.min([_distance(points, a, b) for a, b in zip(STROKE[:-1], STROKE[1:], strict=True)], axis=0)
    alpha = np.clip((THICKNESS - distance) * SIZE + 0.5, 0, 1)
    return alpha[..., None] * np.array([*GREEN, 1.0])


def _distance(points: np.ndarray, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Of points (..., 2) from the line between a and b."""
    share = np.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
    return np.linalg.norm(points - a - share[..., None] * (b - a), axis=-1)
