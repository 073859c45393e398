# SPDX-License-Identifier: GPL-3.0-or-later
"""Names and legend of a 3D view."""

from collections.abc import Iterator

import bpy
import numpy as np

from .shown import Drawing, drawings, extremes, missing_maps, shown_map
from .write_screen import MAX_NAMES, PlacedName, write_over


def draw_screen() -> None:
    """The handler for POST_PIXEL."""
    context = bpy.context
    shown = list(drawings(context))
    if shown:
        names = (name for drawing in shown for name in _names_in_view(context, drawing))
        color_map = shown_map(context)
        write_over(context, shown, names, missing_maps(shown) if color_map else [], color_map, extremes(shown))


def _names_in_view(context: bpy.types.Context, drawing: Drawing) -> Iterator[PlacedName]:
    """Texts with those of their places that are in the region, on the side of the surface that is seen."""
    names = drawing.lines.names[:MAX_NAMES] if drawing.lines else []
    if not names:
        return
    matrix, view = drawing.target.matrix_world, context.region_data
    linear = matrix.to_3x3()
    places = np.concatenate([name.places for name in names]) @ np.array(linear).T + np.array(matrix.translation)
    normals = np.concatenate([name.normals for name in names]) @ np.array(linear.inverted_safe())
    eye = np.array(view.view_matrix.inverted_safe())
    toward_eye = eye[:3, 3] - places if view.is_perspective else eye[:3, 2]
    points, seen = _in_region(context, places)
    seen &= (normals * toward_eye).sum(axis=1) >= 0
    counts = [len(name.places) for name in names]
    reach = np.repeat([name.reach for name in names], counts)[:, None] * matrix.median_scale
    reaches = np.linalg.norm(_in_region(context, places + eye[:3, 0] * reach)[0] - points, axis=1)
    parts = (np.split(each, np.cumsum(counts)[:-1]) for each in (points, seen, reaches))
    for name, own, own_seen, own_reaches in zip(names, *parts, strict=True):
        if own_seen.any():
            yield PlacedName(name.text, own[own_seen], own_reaches[own_seen][0])


def _in_region(context: bpy.types.Context, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The pixels (n,2) of places (n,3) in the world, and a mask of those that are inside the region."""
    size = np.array([context.region.width, context.region.height])
    projected = np.column_stack([places, np.ones(len(places))]) @ np.array(context.region_data.perspective_matrix).T
    in_front = projected[:, 3] > 0
    depth = np.where(in_front, projected[:, 3], 1.0)
    points = (1 + projected[:, :2] / depth[:, None]) / 2 * size
    return points, in_front & np.all((points >= 0) & (points <= size), axis=1)
