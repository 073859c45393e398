# SPDX-License-Identifier: GPL-3.0-or-later
"""Models turned inside out: their pieces are drawn as seen from inside. No Blender in here."""

import numpy as np

from .mesh_arrays import MeshArrays
from .triangle_areas import area_vectors

ALL_ROUND = 0.3  # of the area: by so much at most may one side outweigh the others, or in and out are not told apart
INWARD = (
    "The faces point inward, so that the pieces are drawn as seen from inside. "
    "In Edit Mode: Mesh > Normals > Recalculate Outside. Then flatten again."
)


def faces_inward(arrays: MeshArrays) -> bool:
    """Of a model that has faces all around, like a bodice, a sleeve or a ball: whether they point to its middle."""
    vectors = area_vectors(arrays.vertices, arrays.triangles)
    areas = np.linalg.norm(vectors, axis=0)
    if len(areas) == 0 or np.linalg.norm(vectors.sum(axis=1)) > ALL_ROUND * areas.sum():
        return False
    centers = arrays.vertices[arrays.triangles].mean(axis=1)
    middle = (centers.min(axis=0) + centers.max(axis=0)) / 2
    return bool(np.sum((centers - middle).T * vectors) < 0)
