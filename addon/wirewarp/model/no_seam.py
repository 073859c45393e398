# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the user wants no seam: on faces with an attribute of our name, and among vertices of a group of it.

The attribute may be of any number, as a Geometry Nodes tree or a script leaves it; what is above 0 counts.
"""

import bpy
import numpy as np

from ..blender.mesh import corner_edges, edge_vertices, face_sizes, faces_at_edges, read_attribute
from ..names import NO_SEAM

NUMBERS = ("BOOLEAN", "INT", "FLOAT")
LEAST_WEIGHT = 0.5  # of a vertex in the group: as painted with half the strength, or more


def read_no_seam(source: bpy.types.Object) -> np.ndarray:
    """(k,2) the vertices of the edges along which none is to run. Of an object in Object Mode."""
    mesh = source.data
    is_within = _within_faces(mesh) | _among_vertices(source)
    return edge_vertices(mesh)[is_within]


def _within_faces(mesh: bpy.types.Mesh) -> np.ndarray:
    """(e,) bool: all faces of the edge are painted, so that one around the area is not meant."""
    found = (read_attribute(mesh, NO_SEAM, kind, "FACE") for kind in NUMBERS)
    values = next((each for each in found if each is not None), np.zeros(len(mesh.polygons)))
    of_painted = corner_edges(mesh)[np.repeat(values > 0, face_sizes(mesh))]
    counts = np.bincount(of_painted, minlength=len(mesh.edges))
    return (counts > 0) & (counts == faces_at_edges(mesh))


def _among_vertices(source: bpy.types.Object) -> np.ndarray:
    """(e,) bool: both ends are in the group."""
    mesh, group = source.data, source.vertex_groups.get(NO_SEAM)
    if group is None:
        return np.zeros(len(mesh.edges), dtype=bool)
    is_in = np.array([
        any(each.group == group.index and each.weight >= LEAST_WEIGHT for each in vertex.groups)
        for vertex in mesh.vertices
    ], dtype=bool)  # fmt: skip
    return is_in[edge_vertices(mesh)].all(axis=1)
