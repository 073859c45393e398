# SPDX-License-Identifier: GPL-3.0-or-later
"""Writing what a report proposes to the model: seams, and tolerances of wires. Of meshes in Object Mode."""

import bpy
import numpy as np

from .edge_keys import edge_keys
from .mesh_topology import edge_vertices, read_seams
from .wire_attributes import read_marks, write_marks


def mark_seams(mesh: bpy.types.Mesh, edges: list) -> int:
    """Marks edges, given as vertex pairs, as seams. Returns how many were none before."""
    before = read_seams(mesh)
    wanted = _mask(mesh, edges)
    mesh.edges.foreach_set("use_seam", before | wanted)
    mesh.update()
    return int(np.count_nonzero(wanted & ~before))


def loosen_wires(mesh: bpy.types.Mesh, wires: list[dict]) -> int:
    """Gives the edges of each proposed wire its tolerance, unless theirs is wider. Returns how many edges changed."""
    marks = read_marks(mesh)
    before, tolerances = marks.tolerances.copy(), marks.tolerances
    for wire in wires:
        rows = _mask(mesh, wire["edges"]) & (marks.wire_ids != 0)  # what is no wire any more stays so
        tolerances[rows] = np.maximum(tolerances[rows], np.float32(wire["tolerance"]))
    write_marks(mesh, marks)
    return int(np.count_nonzero(tolerances != before))


def _mask(mesh: bpy.types.Mesh, pairs: list) -> np.ndarray:
    count = len(mesh.vertices)
    return np.isin(edge_keys(edge_vertices(mesh), count), edge_keys(pairs, count))
