# SPDX-License-Identifier: GPL-3.0-or-later
"""Outlines that lie on one another, as where an import or a scan has not joined its faces. No Blender in here."""

import numpy as np

from .edge_keys import edge_keys
from .issues import Hint
from .mesh_arrays import MeshArrays

TORN = "torn"
ADVICE = (
    "Outlines lie on others without being joined to them. Where that is one surface, show them, use Mesh > Merge > By "
    "Distance, or Merge of the modifier Mirror, and flatten again"
)


def torn_hints(arrays: MeshArrays) -> list[Hint]:
    """One, or none; cloth that is cut apart or doubled on purpose is like that, too."""
    edges = torn_edges(arrays)
    return [Hint(TORN, f"{ADVICE}.", short=f"{len(edges)} edges", edges=edges.tolist())] if len(edges) else []


def torn_edges(arrays: MeshArrays) -> np.ndarray:
    """(k,2) the edges of outlines that have both ends in the very places of the ends of another one."""
    places = _numbered(arrays.vertices[arrays.outline.ravel()])
    keys = edge_keys(places, len(places))
    _, inverse, counts = np.unique(keys, return_inverse=True, return_counts=True)
    return arrays.outline[counts[inverse] > 1]


def _numbered(points: np.ndarray) -> np.ndarray:
    """(k,) one number for each place among points (k,3)."""
    order = np.lexsort(points.T)
    is_new = np.any(np.diff(points[order], axis=0) != 0, axis=1)
    numbers = np.zeros(len(points), dtype=np.int64)
    numbers[order[1:]] = np.cumsum(is_new)
    return numbers
