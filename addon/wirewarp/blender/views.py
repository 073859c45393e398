# SPDX-License-Identifier: GPL-3.0-or-later
"""What 3D views show: redrawn, and moved so that given points are in sight."""

from dataclasses import dataclass

import bpy
import numpy as np

MARGIN = 1.15  # so much more is seen than the points


def redraw_views() -> None:
    """All 3D views and UV editors with their sidebars."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type in {"VIEW_3D", "IMAGE_EDITOR"}:
                area.tag_redraw()


def redraw_sidebars() -> None:
    """Of all 3D views, without what is beside them."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            for region in area.regions if area.type == "VIEW_3D" else ():
                if region.type == "UI":
                    region.tag_redraw()


def is_over_sidebar(event: bpy.types.Event) -> bool:
    """Whether the mouse is over the sidebar of a 3D view of the event's window."""
    return any(
        region.x <= event.mouse_x < region.x + region.width and region.y <= event.mouse_y < region.y + region.height
        for area in bpy.context.window.screen.areas
        for region in (area.regions if area.type == "VIEW_3D" else ())
        if region.type == "UI"
    )


@dataclass(frozen=True)
class Projection:
    """Of a view, as its projection matrix has it."""

    axes: np.ndarray  # (3,3) in columns: right, up, toward the eye
    across: float  # cotangent of half the angle of view from left to right; orthographic: one over half the width
    upward: float  # the same from bottom to top
    is_perspective: bool
    covered: float = 0.0  # share of the width that a sidebar covers on the right


def fit(points: np.ndarray, view: Projection) -> tuple[np.ndarray, float]:
    """The point to look at (3,), and the distance to it; orthographic: the factor by which to see more than now.

    points (n,3): all of them are in sight then, and left of what is covered.
    """
    seen = points @ view.axes
    middle = (seen.min(axis=0) + seen.max(axis=0)) / 2
    (x, y), z = np.abs(seen - middle)[:, :2].T, (seen - middle)[:, 2]
    needed = MARGIN * np.maximum(view.across / (1 - view.covered) * x, view.upward * y)
    distance = float((needed + z).max() if view.is_perspective else needed.max())
    middle[0] += view.covered * distance / view.across  # the points are left of the middle, to have the sidebar beside
    return view.axes @ middle, distance
