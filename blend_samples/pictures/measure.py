# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes values and lines for the pictures from arrays of flat pieces. Needs only numpy."""

from __future__ import annotations

import numpy as np


def cloth_stretch(flat: np.ndarray, worn: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Return the stretch (n,) of the fabric around each vertex, as a mean of all directions.

    flat (n, 2): positions on the flat pieces; worn (n, 3): positions on the model. 0.1 means stretched by 10%, and -0.1
    compressed by 10%.
    """
    return np.sqrt(_areas_around(worn, triangles) / _areas_around(np.pad(flat, ((0, 0), (0, 1))), triangles)) - 1


def _areas_around(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    a, b, c = (points[triangles[:, corner]] for corner in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    return np.bincount(triangles.ravel(), np.repeat(area, 3), len(points))


def chains(edges: np.ndarray) -> list[list[int]]:
    """Return edges (k, 2) as polylines, which end at vertices with one edge or more than two edges.

    Closed polylines repeat their first vertex.
    """
    neighbors: dict[int, list[int]] = {}
    for a, b in edges.tolist():
        neighbors.setdefault(a, []).append(b)
        neighbors.setdefault(b, []).append(a)
    unused = {frozenset(edge) for edge in edges.tolist()}
    result = []
    starts = [v for v, around in neighbors.items() if len(around) != 2]
    for start in [*starts, *neighbors]:
        for second in neighbors[start]:
            if frozenset((start, second)) not in unused:
                continue
            chain = [start, second]
            unused.remove(frozenset(chain))
            while len(neighbors[chain[-1]]) == 2:
                following = next((v for v in neighbors[chain[-1]] if frozenset((chain[-1], v)) in unused), None)
                if following is None:
                    break
                unused.remove(frozenset((chain[-1], following)))
                chain.append(following)
            result.append(chain)
    return result
