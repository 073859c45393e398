# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes an upholstered box cushion: domed top and bottom, and a strip in four parts around them."""

from __future__ import annotations

import numpy as np

from .shape import Shape, ShapeBuilder

HALF_WIDTH = 0.25
CORNER_RADIUS = 0.06
CORNER_DENSITY = 2.0  # density of points along round corners, as a multiple of the density along straight sides
CROWN = 0.035  # meters: rise of the top above its seam
STRIP_HEIGHT = 0.08
STRIP_BULGE = 0.006


def cushion(core: int = 20, rings: int = 7, strip_rows: int = 6) -> Shape:
    """Return the cushion with two lines around it over top and bottom: front to back, and side to side.

    core: edges along each side; rings: rings around the core of a panel; strip_rows: rows of the strip.
    """
    builder = ShapeBuilder()
    x, y = _panel(core, rings)
    crown = _inflate(x, y, core, rings)
    tops = {}
    for side in (1, -1):
        height = side * (STRIP_HEIGHT / 2 + CROWN * crown)
        points = builder.add_points(np.stack([x, y, height], axis=-1))
        for quad in _panel_quads(core, rings):
            builder.add_face(tuple(points[quad]), flip=side < 0)
        tops[side] = points
    outline = _spokes(core, rings)[:, -1]  # closed, counter-clockwise from a corner
    strip = builder.add_points(_strip(x[outline], y[outline], strip_rows))
    for lower, upper in zip(strip[:-1], strip[1:], strict=True):
        for corners in zip(lower[:-1], lower[1:], upper[1:], upper[:-1], strict=True):
            builder.add_face(corners)
    builder.add_seam(strip[0])
    builder.add_seam(strip[-1])
    for corner in range(4):
        builder.add_seam(strip[:, corner * core])
    builder.add_wire(_line_around(tops, strip, core, rings, first=0), "Line, front to back")
    builder.add_wire(_line_around(tops, strip, core, rings, first=1), "Line, side to side")
    return builder.build("Cushion")


def _line_around(tops: dict[int, np.ndarray], strip: np.ndarray, core: int, rings: int, first: int) -> np.ndarray:
    """Return the closed chain from the middle of side `first` over the top, down the strip, under the bottom and up."""
    begin, end = (side * core + core // 2 for side in (first, first + 2))
    spokes = _spokes(core, rings)
    across = [*spokes[begin][::-1], *_core_line(core, first)[1:-1], *spokes[end]]
    return np.concatenate(
        [tops[1][across], strip[-2:0:-1, end], tops[-1][across[::-1]], strip[1:-1, begin], tops[1][across[:1]]]
    )


# A panel is planar. Its points are a square core of (core+1)^2 points, row by row, and then rings of 4*core points.


def _panel(core: int, rings: int) -> tuple[np.ndarray, np.ndarray]:
    side = np.linspace(-1, 1, core + 1)
    inner = 0.45 * HALF_WIDTH
    # The core is bulged toward a disk, so that the rings are not too close at its corners.
    bulge = 1 + 0.22 * (1 - side**2)
    core_x = inner * side[None, :] * bulge[:, None]
    core_y = inner * side[:, None] * bulge[None, :]
    points = [np.stack([core_x.ravel(), core_y.ravel()], axis=-1)]
    border = points[0][_core_border(core)]
    outer = _rounded_square(core)
    for ring in range(1, rings + 1):
        points.append(border + (outer - border) * ring / rings)
    x, y = np.concatenate(points).T
    return x, y


def _rounded_square(core: int) -> np.ndarray:
    """Return the outline, 4*core points, counter-clockwise from the middle of the corner (-, -)."""
    straight = HALF_WIDTH - CORNER_RADIUS
    t = np.linspace(0, np.pi / 2, 200)
    corner = np.stack([straight + CORNER_RADIUS * np.cos(t), straight + CORNER_RADIUS * np.sin(t)], axis=-1)
    first = np.concatenate([corner[len(corner) // 2 :], (corner * [-1, 1])[::-1][: len(corner) // 2]])  # top side
    steps = np.linalg.norm(np.diff(first, axis=0), axis=1)
    steps[first[:-1, 1] < HALF_WIDTH - 1e-9] *= CORNER_DENSITY
    lengths = np.concatenate([[0], np.cumsum(steps)])
    even = np.linspace(0, lengths[-1], core + 1)[:-1]
    x, y = (np.interp(even, lengths, first[:, k]) for k in range(2))
    quarter = np.stack([x, y], axis=-1)  # from corner (+, +) to corner (-, +)
    turn = np.array([[0.0, 1.0], [-1.0, 0.0]])  # rotates row vectors counter-clockwise by 90 degrees
    sides = [quarter @ np.linalg.matrix_power(turn, k) for k in (2, 3, 0, 1)]
    return np.concatenate(sides)


def _core_border(core: int) -> np.ndarray:
    """Return indices of the 4*core border points of the core, counter-clockwise from its corner (-, -)."""
    grid = np.arange((core + 1) ** 2).reshape(core + 1, core + 1)
    return np.concatenate([grid[0, :-1], grid[:-1, -1], grid[-1, :0:-1], grid[:0:-1, 0]])


def _core_line(core: int, first: int) -> np.ndarray:
    """Return the middle line of the core, from the middle of side `first` to the opposite side.

    first: 0 for the front (-y), 1 for the right (+x).
    """
    grid = np.arange((core + 1) ** 2).reshape(core + 1, core + 1)
    return grid[:, core // 2] if first == 0 else grid[core // 2, ::-1]


def _spokes(core: int, rings: int) -> np.ndarray:
    """Return indices (4*core + 1, rings + 1) of the lines from the core's border to the outline.

    The last line is the first line again.
    """
    ring_points = (core + 1) ** 2 + np.arange(rings * 4 * core).reshape(rings, 4 * core)
    spokes = np.concatenate([_core_border(core)[None], ring_points]).T
    return np.concatenate([spokes, spokes[:1]])


def _panel_quads(core: int, rings: int) -> np.ndarray:
    """Return the indices (k, 4) of a panel's quads, counter-clockwise as seen from above."""
    grid = np.arange((core + 1) ** 2).reshape(core + 1, core + 1)
    spokes = _spokes(core, rings)
    quads = [
        np.stack([g[:-1, :-1], g[1:, :-1], g[1:, 1:], g[:-1, 1:]], axis=-1).reshape(-1, 4) for g in (grid.T, spokes.T)
    ]
    return np.concatenate(quads)


def _inflate(x: np.ndarray, y: np.ndarray, core: int, rings: int) -> np.ndarray:
    """Return the heights of a membrane under even pressure with a fixed outline (Poisson's equation, linear elements).

    The maximum is 1.
    """
    quads = _panel_quads(core, rings)
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    stiffness = np.zeros((len(x), len(x)))
    load = np.zeros(len(x))
    for triangle in triangles:
        px, py = x[triangle], y[triangle]
        gx, gy = np.roll(py, -1) - np.roll(py, 1), np.roll(px, 1) - np.roll(px, -1)  # edge normals
        double_area = abs(gx @ px)
        stiffness[np.ix_(triangle, triangle)] += (np.outer(gx, gx) + np.outer(gy, gy)) / (2 * double_area)
        load[triangle] += double_area / 6
    free = np.setdiff1d(np.arange(len(x)), _spokes(core, rings)[:, -1])
    height = np.zeros(len(x))
    height[free] = np.linalg.solve(stiffness[np.ix_(free, free)], load[free])
    return height / height.max()


def _strip(x: np.ndarray, y: np.ndarray, rows: int) -> np.ndarray:
    """Return points (rows + 1, c, 3) of the strip along the closed outline, bottom row first, bulging outward."""
    outline = np.stack([x, y], axis=-1)
    along = np.roll(outline[:-1], -1, axis=0) - np.roll(outline[:-1], 1, axis=0)
    normal = np.stack([along[:, 1], -along[:, 0]], axis=-1) / np.linalg.norm(along, axis=1, keepdims=True)
    normal = np.concatenate([normal, normal[:1]])
    up = np.linspace(-1, 1, rows + 1)
    plane = outline[None] + STRIP_BULGE * (1 - up**2)[:, None, None] * normal[None]
    height = np.broadcast_to(STRIP_HEIGHT / 2 * up[:, None, None], (*plane.shape[:2], 1))
    return np.concatenate([plane, height], axis=-1)
