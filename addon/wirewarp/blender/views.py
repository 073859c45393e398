# SPDX-License-Identifier: GPL-3.0-or-later
"""Redraws 3D views, and moves them so that given points are visible."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import bpy
import numpy as np
from mathutils import Quaternion, Vector

LEGEND_WIDTH = 180  # pixels at interface scale 1; the usual legend and its margin are 173 wide
TEXTS_HEIGHT = 50  # height of the names of view and object with their margin, in pixels at interface scale 1
# At most this share of the view is kept free for legend and texts. A wider legend hides some of the elements shown.
MOST_COVERED = 0.8
MARGIN = 1.15  # size of the visible area, as a multiple of the extent of the points, so that border lines are visible
# A surface has a front if its mean normal has at least this length. Around a ring, the normals cancel out. A band
# around 270 degrees of a cylinder has this length.
ONE_SIDE = 0.3
# A surface counts as visible if the angle between its mean normal and the direction to the eye has at least this
# cosine. Otherwise, it looks less than 30% as wide as from the front.
SEEN = 0.3
# If the eye's elevation above flat pieces is below the first angle, the view turns to the second angle.
# Pieces look a quarter as high as they are at 15 degrees, and two thirds as high at 40 degrees.
LEAST_ELEVATION, ELEVATION = math.radians(15), math.radians(40)
_legend_width = 0.0  # width of the legend as last drawn, with its margin, in pixels of the screen


def note_legend(width: float) -> None:
    """Store the width of the legend in a 3D view, in pixels of the screen. Views then show elements beside the
    legend."""
    global _legend_width
    _legend_width = width


def redraw_views() -> None:
    """Redraw all 3D views and UV editors with their sidebars."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type in {"VIEW_3D", "IMAGE_EDITOR"}:
                area.tag_redraw()


def redraw_sidebars() -> None:
    """Redraw the sidebars of all 3D views, but not the views."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            for region in area.regions if area.type == "VIEW_3D" else ():
                if region.type == "UI":
                    region.tag_redraw()


def is_over_sidebar(event: bpy.types.Event) -> bool:
    return any(
        region.x <= event.mouse_x < region.x + region.width and region.y <= event.mouse_y < region.y + region.height
        for area in bpy.context.window.screen.areas
        for region in (area.regions if area.type == "VIEW_3D" else ())
        if region.type == "UI"
    )


@dataclass(frozen=True)
class Projection:
    """Projection of a view, with numbers from its projection matrix."""

    axes: np.ndarray  # (3,3) in columns: right, up, toward the eye
    across: float  # cotangent of half the angle of view from left to right; orthographic: one over half the width
    upward: float  # like across, but from bottom to top
    is_perspective: bool
    covered: float = 0.0  # share of the width that sidebar and legend cover on the right
    covered_above: float = 0.0  # share of the height that headers and Blender's texts cover at the top


def fit(points: np.ndarray, view: Projection) -> tuple[np.ndarray, float]:
    """Return the point to look at (3,), and the eye's distance at which the points (n,3) fill the view.

    - For an orthographic view, a factor for the present distance is returned instead of the distance.
    - Covered parts of the view and MARGIN stay free.
    """
    x, y, z = (points @ view.axes).T
    middle = (z.min() + z.max()) / 2
    nearer = z - middle if view.is_perspective else np.zeros_like(z)
    sides = [_Sides(view.across * x, nearer, view.covered), _Sides(view.upward * y, nearer, view.covered_above)]
    distance = max(side.distance for side in sides)
    across, upward = (side.center(distance) for side in sides)
    return view.axes @ [across / view.across, upward / view.upward, middle], distance


class _Sides:
    """The two limits of the view in one direction, left and right or bottom and top. All points must be between
    them."""

    def __init__(self, places: np.ndarray, nearer: np.ndarray, covered: float) -> None:
        """Set `distance` to the smallest distance at which all points are inside.

        places (n,): coordinates of the points, in units of half the view's size at distance 1
        nearer (n,): how much nearer to the eye the points are than the center
        covered: covered share of the view, at its right or upper end

        With free = (1 - covered) / MARGIN and depth = distance - nearer, a point is inside if

            -(free + covered) * depth <= place - center <= (free - covered) * depth.
        """
        self._covered, self._free = covered, (1 - covered) / MARGIN
        self._last = float((places + (self._free - covered) * nearer).max())
        self._first = float((-places + (self._free + covered) * nearer).max())
        self.distance = (self._last + self._first) / (2 * self._free)

    def center(self, distance: float) -> float:
        """Return the place to look at, which has equal room on both sides."""
        return (self._last - self._first) / 2 + self._covered * distance


def show_objects(context: bpy.types.Context, area: bpy.types.Area, objects: Sequence[bpy.types.Object]) -> None:
    """Move this 3D view so that all objects are visible, and flat objects are not seen edge-on."""
    view = _free_view(area)
    _rise(view)
    corners = [target.matrix_world @ Vector(corner) for target in objects for corner in target.bound_box]
    _look_at(context, area, np.array(corners))


def show_place(
    context: bpy.types.Context, area: bpy.types.Area, points: np.ndarray, normals: np.ndarray, least: float
) -> None:
    """Move this 3D view so that the points (n,3) of a surface are visible from the front.

    normals (n,3): normals of the surface
    least: smallest extent of the visible area, in Blender units
    """
    view = _free_view(area)
    normal = Vector(normals.mean(axis=0))
    toward = view.view_rotation.to_matrix().col[2]
    if normal.length > ONE_SIDE and normal.normalized().dot(toward) < SEEN:
        view.view_rotation = normal.to_track_quat("Z", "Y")
        view.update()
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    _look_at(context, area, np.concatenate([points, middle + least / 2 * np.eye(3), middle - least / 2 * np.eye(3)]))


def _free_view(area: bpy.types.Area) -> bpy.types.RegionView3D:
    """Return the view of the area, after leaving the camera view."""
    view = area.spaces.active.region_3d
    if view.view_perspective == "CAMERA":
        view.view_perspective = "PERSP"
        view.update()
    return view


def _look_at(context: bpy.types.Context, area: bpy.types.Area, points: np.ndarray) -> None:
    """Move the view so that the points (n,3) are visible from its present direction, and not clipped."""
    view, region = area.spaces.active.region_3d, next(each for each in area.regions if each.type == "WINDOW")
    is_perspective = view.view_perspective == "PERSP"
    projection = Projection(
        axes=np.array(view.view_rotation.to_matrix()),
        across=view.window_matrix[0][0],
        upward=view.window_matrix[1][1],
        is_perspective=is_perspective,
        covered=min(_covered(context, area) / region.width, MOST_COVERED),
        covered_above=min(covered_above(context, area) / region.height, MOST_COVERED),
    )
    middle, distance = fit(points, projection)
    view.view_location = middle
    view.view_distance = distance if is_perspective else distance * view.view_distance
    farthest = view.view_distance + float(np.linalg.norm(points - middle, axis=1).max())
    area.spaces.active.clip_end = max(area.spaces.active.clip_end, farthest)


def _rise(view: bpy.types.RegionView3D) -> None:
    """Look down on flat pieces, because a view from the side (Numpad 1 or 3) shows them as lines."""
    right, _, toward = view.view_rotation.to_matrix().col
    elevation = math.asin(max(-1.0, min(1.0, toward.z)))
    if abs(elevation) < LEAST_ELEVATION:
        view.view_rotation = Quaternion(right, elevation - ELEVATION) @ view.view_rotation
        view.update()


def _covered(context: bpy.types.Context, area: bpy.types.Area) -> float:
    """Return the width in pixels that the sidebar and the legend cover on the right of the view."""
    sidebar, system = next(each for each in area.regions if each.type == "UI"), context.preferences.system
    overlaps = system.use_region_overlap and sidebar.width > 1
    return max(LEGEND_WIDTH * system.ui_scale, _legend_width) + (sidebar.width if overlaps else 0)


def covered_above(context: bpy.types.Context, area: bpy.types.Area) -> float:
    """Return the height in pixels that headers and Blender's texts cover at the top of the view."""
    system, kinds = context.preferences.system, {"HEADER", "TOOL_HEADER"}
    headers = sum(each.height for each in area.regions if each.type in kinds and each.alignment == "TOP")
    return TEXTS_HEIGHT * system.ui_scale + (headers if system.use_region_overlap else 0)


def work_area(context: bpy.types.Context) -> bpy.types.Area | None:
    """Return the 3D view that the user has just clicked in, or else the largest 3D view; None without a window."""
    areas = [area for area in context.window.screen.areas if area.type == "VIEW_3D"] if context.window else []
    return (
        context.area if context.area in areas else max(areas, key=lambda each: each.width * each.height, default=None)
    )


def send_mouse_move(window: bpy.types.Window) -> None:
    """Makes Blender send a mouse movement to the current position, so that modal operators handle an event."""
    # Blender sends a movement after a region is scrolled, even by zero, because another button may be under the mouse.
    for area in window.screen.areas:
        for region in area.regions:
            with bpy.context.temp_override(window=window, area=area, region=region):
                if region.height > 1 and bpy.ops.view2d.pan.poll():
                    bpy.ops.view2d.pan("EXEC_DEFAULT", deltax=0, deltay=0)
                    return
