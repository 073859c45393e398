# SPDX-License-Identifier: GPL-3.0-or-later
"""Colored and failing faces as triangles to draw."""

from dataclasses import dataclass

import numpy as np

from ..solve.maps import NO_LAYOUT

Extremes = tuple[float, float]  # the smallest and the largest value of a map, whatever range its colors show


@dataclass(frozen=True)
class Triangles:
    """Of a whole mesh."""

    positions: np.ndarray  # (n,3) float32
    vertices: np.ndarray  # (m,3) int32
    corners: np.ndarray  # (m,3) int32
    polygons: np.ndarray  # (m,) int32


@dataclass(frozen=True)
class ColoredTriangles:
    places: np.ndarray  # (3m,3) float32
    colors: np.ndarray  # (3m,4) float32, as the screen shows them, sRGB
    extremes: Extremes | None


def colored(triangles: Triangles, corner_colors: np.ndarray, extremes: Extremes | None) -> ColoredTriangles:
    """corner_colors (l,4): linear."""
    colors = screen_colors(corner_colors)[triangles.corners.ravel()]
    return ColoredTriangles(triangles.positions[triangles.vertices.ravel()], np.ascontiguousarray(colors), extremes)


def on_model(flat_colors: np.ndarray, source_corner: np.ndarray, count: int) -> np.ndarray:
    """The colors (count,4) at the model's corners, from those at the flat pieces' corners."""
    colors = np.tile(NO_LAYOUT, (count, 1))
    inside = (source_corner >= 0) & (source_corner < count)  # corners made by hand are of no place on the model
    colors[source_corner[inside]] = flat_colors[inside]
    return colors


def screen_colors(linear: np.ndarray) -> np.ndarray:
    """float32 sRGB of linear RGBA."""
    rgb = np.clip(linear[:, :3], 0, 1)
    shown = np.where(rgb <= 0.0031308, 12.92 * rgb, 1.055 * rgb ** np.float32(1 / 2.4) - 0.055)
    return np.column_stack([shown, linear[:, 3]]).astype(np.float32)
