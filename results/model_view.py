# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface as modeled, seen from far away, with its seams and wires."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from palette import ELASTIC, INK, RIGID
from shapes import Shape

LAMP = np.array([-0.35, 0.55, 0.76])  # right, up, toward the viewer
FRONT, BACK = np.array([0.95, 0.93, 0.88]), np.array([0.62, 0.61, 0.59])
SHADES = 24
LIFT = 1.5  # edge lengths by which lines come nearer to the viewer, to lie above the triangles beside them


def rotation(turned: float, tipped: float) -> np.ndarray:
    """(3, 3) rows right, up, toward the viewer; z of the model is up. Degrees turned to the left, then tipped down."""
    a, b = np.radians([turned, tipped])
    turn = np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
    look = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])  # from the front: -y comes toward the viewer
    tip = np.array([[1, 0, 0], [0, np.cos(b), -np.sin(b)], [0, np.sin(b), np.cos(b)]])
    return tip @ look @ turn


def draw_model(axes: Axes, shape: Shape, turned: float, tipped: float) -> None:
    """Triangles and lines from the farthest to the nearest, so that near ones cover far ones."""
    points = shape.vertices @ rotation(turned, tipped).T
    triangles = points[shape.triangles()]
    segments, colors, widths = _lines(shape)
    lines = points[segments]

    lift = (
        1.5 * np.linalg.norm(lines[:, 0] - lines[:, 1], axis=1).mean()
    )  # toward the viewer, over the triangles beside the line
    depth = np.concatenate([triangles[:, :, 2].mean(axis=1), lines[:, :, 2].mean(axis=1) + lift])
    order = np.argsort(depth, kind="stable")
    faces = _shades(triangles)
    polygons = [*triangles[:, :, :2], *lines[:, :, :2]]
    face_colors = [*faces, *((0, 0, 0, 0) for _ in lines)]
    edge_colors = [*faces, *colors]
    edge_widths = [*(0.3 for _ in triangles), *widths]
    is_line = [*(False for _ in triangles), *(True for _ in lines)]
    axes.add_collection(
        PolyCollection(
            [polygons[k] for k in order],
            facecolors=[face_colors[k] for k in order],
            edgecolors=[edge_colors[k] for k in order],
            linewidths=[edge_widths[k] for k in order],
            antialiaseds=[is_line[k] for k in order],  # soft rims would show as a net between the triangles
            closed=False,
            capstyle="round",
        )
    )
    frame(axes, points[:, :2].min(axis=0), points[:, :2].max(axis=0))


def frame(axes: Axes, low: np.ndarray, high: np.ndarray) -> None:
    """Shows the box with a small margin, undistorted and without axes."""
    margin = 0.02 * (high - low).max()
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + margin)
    axes.set_aspect("equal")
    axes.set_axis_off()


def _shades(triangles: np.ndarray) -> np.ndarray:
    """(m, 4) colors of triangles (m, 3, 3) in the viewer's frame."""
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    is_front = normals[:, 2:] > 0
    light = np.where(is_front, normals, -normals) @ LAMP
    shade = 0.55 + 0.45 * np.round(SHADES * np.clip(light, 0, 1)) / SHADES
    return np.column_stack([np.where(is_front, FRONT, BACK) * shade[:, None], np.ones(len(triangles))])


def _lines(shape: Shape) -> tuple[np.ndarray, list[str], list[float]]:
    """Vertex pairs with a color and a width: outline and seams, then wires."""
    sides = np.sort(np.concatenate([shape.triangles()[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    edges, count = np.unique(sides, axis=0, return_counts=True)
    cuts = np.concatenate([edges[count == 1], shape.seams.reshape(-1, 2)])
    pairs, colors, widths = [cuts], [INK] * len(cuts), [1.0] * len(cuts)
    for wire in shape.wires:
        chain = np.array(wire.vertices)
        pairs.append(np.stack([chain[:-1], chain[1:]], axis=1))
        colors += [ELASTIC if wire.tolerance else RIGID] * (len(chain) - 1)
        widths += [2.0] * (len(chain) - 1)
    return np.concatenate(pairs), colors, widths
