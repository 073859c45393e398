# SPDX-License-Identifier: GPL-3.0-or-later
"""Outlines that lie on one another, as where an import or a scan has not joined its faces. No Blender in here."""

import numpy as np

from .edge_keys import edge_keys
from .mesh_arrays import MeshArrays
from .words import counted


def torn_text(arrays: MeshArrays) -> str:
    """The sentence; "" where there are none."""
    count = count_torn(arrays)
    if not count:
        return ""
    lie = counted(count, "edge of an outline lies", "edges of outlines lie")
    return (
        f"{lie} on others without being joined to them. Where that is one surface, select all in Edit Mode, use "
        "Mesh > Merge > By Distance, and flatten again."
    )


def count_torn(arrays: MeshArrays) -> int:
    """How many edges of outlines have both ends in the very places of the ends of another one."""
    places = _numbered(arrays.vertices[arrays.outline.ravel()])
    keys = edge_keys(places, len(places))
    _, counts = np.unique(keys, return_counts=True)
    return int(counts[counts > 1].sum())


def _numbered(points: np.ndarray) -> np.ndarray:
    """(k,) one number for each place among points (k,3)."""
    order = np.lexsort(points.T)
    is_new = np.any(np.diff(points[order], axis=0) != 0, axis=1)
    numbers = np.zeros(len(points), dtype=np.int64)
    numbers[order[1:]] = np.cumsum(is_new)
    return numbers
