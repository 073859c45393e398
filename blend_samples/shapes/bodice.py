# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes panels of a bodice as grids in longitude and v of the torso: level rows, and a block above the bust line."""

from __future__ import annotations

import numpy as np

from . import torso
from .curves import chord_lengths, cubic_spline, even_parameters

# Points of the left armhole, from the front underarm over the shoulder tip to the back underarm. Each point has its
# distance x from the middle in meters, and a position that is 0 at the shoulder line and ±1 at the underarm: -1 in
# front, 1 behind.
ARMHOLE = np.array(
    [
        [0.1700, -1.0], [0.1690, -0.975], [0.1600, -0.90], [0.1510, -0.75], [0.1500, -0.55], [0.1580, -0.32],
        [0.1670, -0.13], [0.1680, 0.0], [0.1675, 0.13], [0.1630, 0.32], [0.1570, 0.55], [0.1570, 0.77],
        [0.1640, 0.91], [0.1693, 0.975], [0.1700, 1.0],
    ]
)  # fmt: skip
NECK_POINT = 0.072  # meters: x of the end of the shoulder seam at the neck


def armhole(half: int, points: np.ndarray = ARMHOLE) -> np.ndarray:
    """Return longitude and v (n, 2) of the front (half +1) or back (-1) of an armhole, from the underarm to the tip.

    points: as in ARMHOLE, with the shoulder tip in the middle.
    """
    loop = cubic_spline(chord_lengths(points * [4, 1]), points)(np.linspace(0, 1, 1601))
    x, down = loop[loop[:, 1] <= 0].T if half > 0 else loop[::-1][loop[::-1, 1] >= 0].T
    v = 1 - np.abs(down) * (1 - torso.UNDERARM_V)
    curve = np.stack([torso.longitude_at(x, v), v], axis=-1)
    curve[[0, -1]] = [np.pi / 2, torso.UNDERARM_V], [torso.longitude_at(points[len(points) // 2, 0], 1.0), 1.0]
    return curve


def neckline(depth: float) -> np.ndarray:
    """Return points (n, 2) of the neckline from the right neck point to the left.

    depth: depth of the middle as a share of the distance in v from the shoulder line to the underarm.
    """
    end = np.radians(66)  # below 90, so that the neckline does not touch the vertical columns of the grid at its ends
    t = np.linspace(-end, end, 400)
    drop = depth * (1 - torso.UNDERARM_V) * (np.cos(t) - np.cos(end)) / (1 - np.cos(end))
    return np.stack([torso.longitude_at(NECK_POINT, 1.0) * np.sin(t) / np.sin(end), 1 - drop], axis=-1)


def evenly(body: torso.Half, curve: np.ndarray, count: int) -> np.ndarray:
    """Return count + 1 points of a curve in longitude and v, at equal distances on the body. It keeps its ends."""
    at = chord_lengths(body.points(curve[:, 0], curve[:, 1]))
    even = np.linspace(0, 1, count + 1)
    points = np.stack([np.interp(even, at, curve[:, k]) for k in range(2)], axis=-1)
    points[[0, -1]] = curve[[0, -1]]
    return points


def level_row(body: torso.Half, v: float, begin: float, end: float, columns: int) -> np.ndarray:
    """Return evenly spaced points (columns + 1, 2) of a level row between two longitudes."""
    phi = even_parameters(lambda t: body.points(t, np.full_like(t, v)), begin, end, columns)
    return np.stack([phi, np.full_like(phi, v)], axis=-1)


def upper_block(
    bust: np.ndarray, left: np.ndarray, upper: np.ndarray, body: torso.Half, straight: bool = False
) -> np.ndarray:
    """Return rows (r, c, 2) from the bust line (c, 2) to the upper edge (c, 2).

    The sides are the left edge (r, 2) and its mirror image. Bust line and upper edge run from right to left, and the
    left edge from the bust line up. The columns follow the left edge. If straight, only columns near this edge follow
    it.
    """
    t = chord_lengths(body.points(left[:, 0], left[:, 1]))[:, None]
    across = (1 - t) * bust[:, 0] / bust[-1, 0] + t * upper[:, 0] / upper[-1, 0]  # from -1 at the right edge to 1
    followed = (1 - t) * left[0, 0] + t * left[-1, 0] if straight else left[:, :1]
    phi = (followed + (left[:, :1] - followed) * across**4) * across
    # height of each point of the left edge in the block, from 0 to 1
    height = (left[:, 1:] - bust[0, 1]) / (1 - bust[0, 1])
    v = bust[0, 1] + (t + (height - t) * across**2) * (upper[:, 1] - bust[0, 1])
    return np.stack([phi, v], axis=-1)


def upper_edge(body: torso.Half, tip: np.ndarray, depth: float, shoulder: int, neck: int) -> np.ndarray:
    """Return points (2 * shoulder + neck + 1, 2) along the right shoulder, the neckline and the left shoulder.

    tip: left shoulder tip; depth: see neckline(); shoulder, neck: numbers of edges.
    """
    middle = evenly(body, neckline(depth), neck)
    ridge = evenly(body, np.linspace(middle[-1], tip, 200), shoulder)
    return np.concatenate([ridge[::-1] * [-1, 1], middle[1:-1], ridge])
