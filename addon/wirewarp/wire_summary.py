# SPDX-License-Identifier: GPL-3.0-or-later
"""What the list of wires shows, gathered from the edge attributes and kept until the mesh changes."""

from dataclasses import dataclass

import bmesh
import bpy
import numpy as np

from .foreach import read
from .mesh_cache import kept
from .wire_attributes import TOLERANCE, WIRE, read_marks


@dataclass(frozen=True)
class WireSummary:
    wire_id: int
    tolerance: float
    edge_vectors: np.ndarray  # (k,3) in the mesh's own space

    def length(self, linear: np.ndarray) -> float:
        """In Blender units, for an object with this linear part."""
        return float(np.linalg.norm(self.edge_vectors @ linear.T, axis=1).sum())


def wires_of(target: bpy.types.Object) -> list[WireSummary]:
    """One entry per id and tolerance. Raises ObjectError if an attribute is not ours."""
    return kept(target.data, "wires", _summarize)


def _summarize(mesh: bpy.types.Mesh) -> list[WireSummary]:
    gather = _gather_edit if mesh.is_editmode else _gather
    return _group(*gather(mesh))


def _gather(mesh: bpy.types.Mesh) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Ids (k,), tolerances (k,) and vectors (k,3) of the marked edges."""
    marks = read_marks(mesh)
    marked = np.flatnonzero(marks.wire_ids)
    if not len(marked):
        return _nothing()
    ends = read(mesh.edges, "vertices", np.int32, 2)[marked]
    positions = read(mesh.vertices, "co", np.float32, 3).astype(np.float64)
    return marks.wire_ids[marked], marks.tolerances[marked], positions[ends[:, 1]] - positions[ends[:, 0]]


def _gather_edit(mesh: bpy.types.Mesh) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    edit = bmesh.from_edit_mesh(mesh)
    wire, tolerance = edit.edges.layers.int.get(WIRE), edit.edges.layers.float.get(TOLERANCE)
    marked = [edge for edge in edit.edges if edge[wire]] if wire and tolerance else []
    if not marked:
        return _nothing()
    vectors = [edge.verts[1].co - edge.verts[0].co for edge in marked]
    return np.array([edge[wire] for edge in marked]), np.array([edge[tolerance] for edge in marked]), np.array(vectors)


def _nothing() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    return np.empty(0, np.int32), np.empty(0, np.float32), np.empty((0, 3))


def _group(wire_ids: np.ndarray, tolerances: np.ndarray, vectors: np.ndarray) -> list[WireSummary]:
    keys = dict.fromkeys(zip(wire_ids.tolist(), tolerances.tolist(), strict=True))
    return [
        WireSummary(wire_id, tolerance, vectors[(wire_ids == wire_id) & (tolerances == tolerance)])
        for wire_id, tolerance in keys
    ]
