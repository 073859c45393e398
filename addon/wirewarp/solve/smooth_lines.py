# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth lines beside paths of edges. No Blender in here."""

from itertools import pairwise
from types import ModuleType

import numpy as np
from numpy.typing import ArrayLike

from ..core import SurfacePath
from ..issues import ObjectError
from .arrays import MeshArrays
from .chains import edge_keys
from .cut_faces import Pairs
from .flatten import issue_of_error
from .suggest import NoSeam, painted_at_edges


def smooth_line(library: ModuleType, arrays: MeshArrays, path: list[int], kept: Pairs, no_seam: NoSeam) -> SurfacePath:
    """Return a smooth line beside a path of vertices inside a piece, with the same ends and crossings of kept edges.

    It enters only painted faces that the path enters. Edges of the path must not be seams. Raises ObjectError.
    """
    painted = (painted_at_edges(arrays, no_seam) > 0) | no_seam.vertices[arrays.edges].all(axis=1)
    painted &= ~np.isin(_keys(arrays.edges, arrays), _keys(list(pairwise(path)), arrays))
    seams = np.concatenate([arrays.seams, np.array(kept, dtype=np.int32).reshape(-1, 2), arrays.edges[painted]])
    try:
        wires = [library.Wire(wire.chain.vertices, wire.chain.tolerance) for wire in arrays.wires]
        ends, t = library.straighten_path(arrays.vertices, arrays.triangles, path, seams=seams, wires=wires)
    except library.FlattenError as error:
        raise ObjectError(issue_of_error(error, arrays)) from error
    return _on_triangles(library, ends, t, arrays)


def _on_triangles(library: ModuleType, ends: np.ndarray, t: np.ndarray, arrays: MeshArrays) -> SurfacePath:
    """Return points at ends[:, 0] + t (ends[:, 1] - ends[:, 0]) as points in triangles."""
    near = np.flatnonzero(np.isin(arrays.triangles, ends).any(axis=1))
    faces, coordinates = [], []
    for (first, second), share in zip(ends.tolist(), t.tolist(), strict=True):
        triangles = arrays.triangles[near]
        row = np.flatnonzero((triangles == first).any(axis=1) & (triangles == second).any(axis=1))[0]
        faces.append(int(near[row]))
        coordinates.append((1 - share) * (triangles[row] == first) + share * (triangles[row] == second))
    return library.SurfacePath(faces, coordinates)


def _keys(pairs: ArrayLike, arrays: MeshArrays) -> np.ndarray:
    return edge_keys(pairs, len(arrays.vertices))
