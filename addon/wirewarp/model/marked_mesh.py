# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh with its seams and wires as arrays: all that flat pieces depend on, read alike in either mode."""

from dataclasses import dataclass

import bpy
import numpy as np

from ..blender.memory import Take, read_anew
from ..blender.mesh import (
    corner_edges,
    corner_vertices,
    current_mesh,
    edge_vertices,
    face_sizes,
    read_seams,
    vertex_places,
)
from ..pattern.chains import EdgeMarks
from .attributes import read_marks
from .sides import SIDE_EASES


@dataclass(frozen=True)
class MarkedMesh:
    places: np.ndarray  # (n,3) float32, in the mesh's own space
    edges: np.ndarray  # (e,2) int32
    corner_vertices: np.ndarray  # (l,) int32
    corner_edges: np.ndarray  # (l,) int32, the edge from each corner to the next of its face
    face_sizes: np.ndarray  # (f,) int32
    seams: np.ndarray  # (e,) bool
    marks: EdgeMarks  # (e,)
    side_eases: np.ndarray  # (l,) float32, of the edge that begins at each corner, on the side of its face; 0 none


def read_marked(mesh: bpy.types.Mesh) -> MarkedMesh:
    """Of a mesh that is not in Edit Mode. Raises ObjectError if an attribute of our name is another's."""
    return MarkedMesh(
        vertex_places(mesh),
        edge_vertices(mesh),
        corner_vertices(mesh),
        corner_edges(mesh),
        face_sizes(mesh),
        read_seams(mesh),
        read_marks(mesh),
        SIDE_EASES.read(mesh),
    )


def marked_mesh(target: bpy.types.Object, take: Take = read_anew) -> MarkedMesh:
    """The object's own mesh in either mode, as read_marked; take: read_anew, or kept."""

    def gather(_mesh: bpy.types.Mesh) -> MarkedMesh:
        with current_mesh(target) as mesh:
            return read_marked(mesh)

    # Outside Edit Mode reading is quick, and not worth the memory.
    return take(target.data, "marked mesh", gather) if target.data.is_editmode else gather(target.data)
