# SPDX-License-Identifier: GPL-3.0-or-later
"""Values that the pictures show, computed from the arrays of a flat piece. Needs only numpy."""

from __future__ import annotations

import numpy as np


def cloth_stretch(flat: np.ndarray, worn: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Return how much longer the fabric around each vertex is on the model than flat, as a mean of all directions.

    flat (n, 2) and worn (n, 3) are positions. 0.1 is stretched by 10%, -0.1 is compressed by 10%.
    """
    return np.sqrt(_areas_around(worn, triangles) / _areas_around(np.pad(flat, ((0, 0), (0, 1))), triangles)) - 1


def _areas_around(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    a, b, c = (points[triangles[:, corner]] for corner in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    return np.bincount(triangles.ravel(), np.repeat(area, 3), len(points))


def chains(edges: np.ndarray) -> list[list[int]]:
    """Return edges (k, 2) as polylines that end where not exactly two edges meet; closed ones repeat their first
    vertex.
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
