# SPDX-License-Identifier: GPL-3.0-or-later
"""The wires of a mesh, gathered from the edge attributes and kept until the mesh changes."""

from dataclasses import dataclass

import bmesh
import bpy
import numpy as np

from ..blender.cache import kept
from ..blender.mesh import edge_vertices, read
from ..names import WIRE
from ..pattern.chains import EdgeMarks, chains_of_marks
from .attributes import own_ids, read_edit_marks, read_marks
from .wire_names import chain_names, find_name, list_places, write_names


@dataclass(frozen=True)
class WireSummary:
    """A wire as flattening will see it: one run of edges with one id and one tolerance."""

    wire_id: int
    tolerance: float
    edges: list[int]  # of the mesh, in order along the wire
    edge_vectors: np.ndarray  # (k,3) in the mesh's own space
    shares_id: bool  # with an earlier one: a wire that was copied or cut in two

    def length(self, linear: np.ndarray) -> float:
        """In Blender units, for an object with this linear part."""
        return float(np.linalg.norm(self.edge_vectors @ linear.T, axis=1).sum())


def wires_of(target: bpy.types.Object) -> list[WireSummary]:
    """In the order of the mesh. Raises ObjectError if an attribute is not ours."""
    return kept(target.data, "wires", find_wires)


def listed_wires(target: bpy.types.Object) -> list[tuple[str, WireSummary]]:
    """With their names, in the order of the list of names. Raises ObjectError as wires_of does."""
    wires = wires_of(target)
    named = zip(chain_names(target.data, [wire.wire_id for wire in wires]), wires, strict=True)
    places = list_places(target.data)
    return sorted(named, key=lambda each: places.get(each[1].wire_id, len(places)))  # unnamed wires last


def editable_name(mesh: bpy.types.Mesh, wire: WireSummary) -> bpy.types.PropertyGroup | None:
    """The entry in the list of names that is this wire's and no other's."""
    return None if wire.shares_id else find_name(mesh, wire.wire_id)


@dataclass(frozen=True)
class _Marked:
    """The marked edges."""

    rows: np.ndarray  # (k,) of the mesh's edges
    vertices: np.ndarray  # (k,2) of the mesh
    ends: np.ndarray  # (k,2,3)
    marks: EdgeMarks  # (k,)


def find_wires(mesh: bpy.types.Mesh) -> list[WireSummary]:
    """As wires_of, read anew."""
    marked = (_gather_edit if mesh.is_editmode else _gather)(mesh)
    numbers, edges = np.unique(marked.vertices, return_inverse=True)
    edges, positions = edges.reshape(-1, 2), np.empty((len(numbers), 3))
    positions[edges] = marked.ends
    vectors, seen, wires = marked.ends[:, 1] - marked.ends[:, 0], set(), []
    for chain in chains_of_marks(edges, marked.marks, positions):
        rows, shares_id = marked.rows[chain.edges].tolist(), chain.wire_id in seen
        wires.append(WireSummary(chain.wire_id, chain.tolerance, rows, vectors[chain.edges], shares_id))
        seen.add(chain.wire_id)
    return wires


def _gather(mesh: bpy.types.Mesh) -> _Marked:
    marks = read_marks(mesh)
    rows = marks.rows
    vertices = edge_vertices(mesh)[rows]
    ends = read(mesh.vertices, "co", np.float32, 3).astype(np.float64)[vertices]
    return _Marked(rows, vertices, ends, marks.take(rows))


def _gather_edit(mesh: bpy.types.Mesh) -> _Marked:
    edit = bmesh.from_edit_mesh(mesh)
    wire = edit.edges.layers.int.get(WIRE)
    marked = [(row, edge) for row, edge in enumerate(edit.edges) if edge[wire]] if wire else []
    edit.verts.index_update()
    return _Marked(
        rows=np.array([row for row, _ in marked], dtype=np.int32),
        vertices=np.array([[v.index for v in edge.verts] for _, edge in marked], np.int32).reshape(-1, 2),
        ends=np.array([[v.co[:] for v in edge.verts] for _, edge in marked], np.float64).reshape(-1, 2, 3),
        marks=read_edit_marks(edit, [edge for _, edge in marked]),
    )


def repair_names(mesh: bpy.types.Mesh) -> dict[int, int]:
    """Writes the names, and returns the ids that are still to be written, by edge. In either mode."""
    wires = find_wires(mesh)
    ids = [wire.wire_id for wire in wires]
    own = own_ids(ids)
    write_names(mesh, dict(zip(own, chain_names(mesh, ids), strict=True)))
    return {edge: wire_id for wire, wire_id in zip(wires, own, strict=True) if wire.shares_id for edge in wire.edges}
