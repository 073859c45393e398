# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the vertices of a mesh are, in few numbers that rounding leaves nearly as they are. No Blender in here.

What modifiers make differs in its last digits as soon as an object and what they refer to are moved together; and where
nothing was moved too, for up to Blender 3.6 threads sum up normals as they come.
"""

import numpy as np

BLOCKS = 64  # of vertices: one number for each of them and each axis
MOVED = 1e-6  # rounding of coordinates in single precision that went through matrices, by their size
UNMOVED = 1.2e-7  # of the last digit


def place_sums(points: np.ndarray) -> list[float]:
    """Of points (n,3)."""
    numbers = np.arange(len(points))
    blocks = numbers * BLOCKS // max(len(points), 1)
    wave = np.cos(2.4 * numbers)
    weights = (wave + np.sign(wave)) / 2  # none near 0, and together near 0: what rounding does to all alike cancels
    sums = [np.bincount(blocks, weights * column, minlength=BLOCKS) for column in _finite(points).T]
    return np.concatenate(sums).tolist()


def rounding_of_sums(points: np.ndarray, share: float, distance: float = 0.0) -> float:
    """How far rounding of the points (n,3) may take their sums. share: UNMOVED or MOVED, then with the distance of the
    object from the world's origin.
    """
    size = float(np.abs(_finite(points)).max(initial=0)) + distance
    return share * size * float(np.sqrt(max(len(points) / BLOCKS, 1)))


def are_same_places(first: list[float], second: list[float], rounding: float) -> bool:
    """Sums of meshes with the same vertices and faces; rounding: of both together."""
    return bool(np.allclose(first, second, rtol=0, atol=rounding))


def _finite(points: np.ndarray) -> np.ndarray:
    return np.nan_to_num(points.astype(np.float64), posinf=0, neginf=0)
