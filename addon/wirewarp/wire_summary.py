# SPDX-License-Identifier: GPL-3.0-or-later
"""What the list of wires shows, gathered from the edge attributes and kept until the mesh changes."""

from dataclasses import dataclass

import bmesh
import bpy
import numpy as np
from bpy.app.handlers import persistent

from .foreach import read
from .wire_attributes import TOLERANCE, WIRE, read_marks


@dataclass(frozen=True)
class WireSummary:
    wire_id: int
    tolerance: float
    edge_vectors: np.ndarray  # (k,3) in the mesh's own space

    def length(self, linear: np.ndarray) -> float:
        """In Blender units, for an object with this linear part."""
        return float(np.linalg.norm(self.edge_vectors @ linear.T, axis=1).sum())


_kept: dict[str, list[WireSummary]] = {}


def wires_of(target: bpy.types.Object) -> list[WireSummary]:
    """One entry per id and tolerance. Raises ObjectError if an attribute is not ours."""
    mesh = target.data
    if mesh.name_full not in _kept:
        gather = _gather_edit if mesh.is_editmode else _gather
        _kept[mesh.name_full] = _group(*gather(mesh))
    return _kept[mesh.name_full]


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


@persistent
def _drop_changed(_scene: bpy.types.Scene, depsgraph: bpy.types.Depsgraph) -> None:
    for update in depsgraph.updates:
        changed = update.id
        if isinstance(changed, bpy.types.Mesh):
            _kept.pop(changed.name_full, None)
        elif isinstance(changed, bpy.types.Object) and update.is_updated_geometry and changed.type == "MESH":
            _kept.pop(changed.data.name_full, None)


@persistent
def _drop_all(*_: object) -> None:
    _kept.clear()


def attach() -> None:
    bpy.app.handlers.depsgraph_update_post.append(_drop_changed)
    for handlers in (bpy.app.handlers.undo_post, bpy.app.handlers.redo_post, bpy.app.handlers.load_post):
        handlers.append(_drop_all)


def detach() -> None:
    bpy.app.handlers.depsgraph_update_post.remove(_drop_changed)
    for handlers in (bpy.app.handlers.undo_post, bpy.app.handlers.redo_post, bpy.app.handlers.load_post):
        handlers.remove(_drop_all)
    _drop_all()
