# SPDX-License-Identifier: GPL-3.0-or-later
"""A flat object's mesh to plain arrays."""

import bpy
import numpy as np

from .flat_attributes import read_flat_attribute
from .foreach import read
from .mesh_topology import corner_edges, corner_vertices, edge_vertices, face_sizes
from .pattern.flat_pieces import FlatPieces
from .wire_attributes import read_marks


def read_flat_pieces(mesh: bpy.types.Mesh, scale: float) -> FlatPieces:
    """In Blender units times `scale`. Of a mesh in Object Mode that has our attributes."""
    marks = read_marks(mesh)
    return FlatPieces(
        vertices=read(mesh.vertices, "co", np.float32, 3)[:, :2].astype(np.float64) * scale,
        source_vertex=read_flat_attribute(mesh, "source_vertex"),
        loop_vertices=corner_vertices(mesh),
        loop_edges=corner_edges(mesh),
        face_sizes=face_sizes(mesh),
        face_piece=read_flat_attribute(mesh, "piece"),
        edges=edge_vertices(mesh),
        wire_ids=marks.wire_ids,
        tolerances=marks.tolerances,
    )
