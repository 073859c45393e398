# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws a modeled surface in parallel projection, with its visible seams and wires."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from palette import ELASTIC, INK, RIGID
from shapes import Shape

LAMP = np.array([-0.35, 0.55, 0.76])  # direction to the lamp: right, up, toward the viewer
FRONT, BACK = np.array([0.95, 0.93, 0.88]), np.array([0.62, 0.61, 0.59])
SHADES = 24
CELLS = 250  # number of cells across the view in the search for hidden lines
SAMPLES = 24  # number of samples along a side of a triangle in this search
SLACK = 0.02  # largest distance of a visible line behind the nearest surface, as a fraction of the view's size


def rotation(turned: float, tipped: float) -> np.ndarray:
    """Return the matrix (3, 3) whose rows are right, up and toward the viewer. The model's z is up.

    - turned: degrees of rotation about the model's z, counterclockwise seen from above
    - tipped: degrees by which the top then tilts toward the viewer
    """
    a, b = np.radians([turned, tipped])
    turn = np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
    look = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])  # front view: -y points toward the viewer
    tip = np.array([[1, 0, 0], [0, np.cos(b), -np.sin(b)], [0, np.sin(b), np.cos(b)]])
    return tip @ look @ turn


def draw_model(axes: Axes, shape: Shape, turned: float, tipped: float) -> None:
    """Draw triangles, the farthest first, so that near triangles cover far triangles. Then draw visible lines."""
    points = shape.vertices @ rotation(turned, tipped).T
    triangles = points[shape.triangles()]
    triangles = triangles[np.argsort(triangles[:, :, 2].mean(axis=1), kind="stable")]
    colors = _shades(triangles)
    # without antialiased borders, which would look like a net between the triangles
    axes.add_collection(
        PolyCollection(triangles[:, :, :2], facecolors=colors, edgecolors=colors, linewidths=0.3, antialiased=False)
    )
    segments, colors, widths = _lines(shape)
    lines = points[segments]
    seen = _in_sight(lines.mean(axis=1), triangles)
    axes.add_collection(
        LineCollection(lines[seen, :, :2], colors=colors[seen], linewidths=widths[seen], capstyle="round")
    )
    frame(axes, points[:, :2].min(axis=0), points[:, :2].max(axis=0))


def frame(axes: Axes, low: np.ndarray, high: np.ndarray) -> None:
    """Make the axes show the box from low to high with a small margin, with equal scales and without lines."""
    margin = 0.02 * (high - low).max()
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + margin)
    axes.set_aspect("equal")
    axes.set_axis_off()


def _shades(triangles: np.ndarray) -> np.ndarray:
    """Return colors (m, 4) of triangles (m, 3, 3) in the viewer's frame."""
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    is_front = normals[:, 2:] > 0
    light = np.where(is_front, normals, -normals) @ LAMP
    shade = 0.55 + 0.45 * np.round(SHADES * np.clip(light, 0, 1)) / SHADES
    return np.column_stack([np.where(is_front, FRONT, BACK) * shade[:, None], np.ones(len(triangles))])


def _in_sight(places: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Return whether the viewer sees each of the places (k, 3) on the triangles (m, 3, 3), in the viewer's frame."""
    i, j = (c.ravel() for c in np.meshgrid(np.arange(SAMPLES + 1), np.arange(SAMPLES + 1)))
    weights = (np.stack([i, j, SAMPLES - i - j], axis=-1) / SAMPLES)[i + j <= SAMPLES]
    samples = np.einsum("sc,mcd->msd", weights, triangles).reshape(-1, 3)
    low = triangles.reshape(-1, 3).min(axis=0)
    size = np.ptp(triangles.reshape(-1, 3), axis=0).max()

    def cell(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        column, row = ((points - low)[:, :2] / size * CELLS).astype(int).T
        return row, column

    nearest = np.full((CELLS + 1, CELLS + 1), -np.inf)
    np.maximum.at(nearest, cell(samples), samples[:, 2])
    return places[:, 2] >= nearest[cell(places)] - SLACK * size


def _lines(shape: Shape) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return vertex pairs (k, 2) with their colors and widths: outline and seams, then wires."""
    sides = np.sort(np.concatenate([shape.triangles()[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    edges, count = np.unique(sides, axis=0, return_counts=True)
    cuts = np.concatenate([edges[count == 1], shape.seams.reshape(-1, 2)])
    pairs, colors, widths = [cuts], [INK] * len(cuts), [1.0] * len(cuts)
    for wire in shape.wires:
        chain = np.array(wire.vertices)
        pairs.append(np.stack([chain[:-1], chain[1:]], axis=1))
        colors += [ELASTIC if wire.tolerance else RIGID] * (len(chain) - 1)
        widths += [2.0] * (len(chain) - 1)
    return np.concatenate(pairs), np.array(colors), np.array(widths)
