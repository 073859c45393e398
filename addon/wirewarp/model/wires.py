# SPDX-License-Identifier: GPL-3.0-or-later
"""The wires of a mesh, gathered from the edge attributes and kept until the mesh changes."""

from dataclasses import dataclass

import bpy
import numpy as np

from ..blender.memory import Take, kept, read_anew
from ..pattern.chains import chains_of_marks
from .attributes import own_ids
from .marked_mesh import marked_mesh
from .wire_names import chain_names, find_name, list_places, write_names


@dataclass(frozen=True)
class WireSummary:
    """A wire as flattening will see it: one run of edges with one id, one tolerance and one ease."""

    wire_id: int
    tolerance: float
    ease: float
    edges: list[int]  # of the mesh, in order along the wire
    edge_vectors: np.ndarray  # (k,3) in the mesh's own space
    shares_id: bool  # with an earlier one: a wire that was copied or cut in two

    def length(self, linear: np.ndarray) -> float:
        """In Blender units, for an object with this linear part."""
        return float(np.linalg.norm(self.edge_vectors @ linear.T, axis=1).sum())


def wires_of(target: bpy.types.Object) -> list[WireSummary]:
    """In the order of the mesh. Raises ObjectError if an attribute is not ours."""
    return kept(target.data, "wires", lambda _: find_wires(target, kept))


def listed_wires(target: bpy.types.Object) -> list[tuple[str, WireSummary]]:
    """With their names, in the order of the list of names. Raises ObjectError as wires_of does."""
    wires = wires_of(target)
    named = zip(chain_names(target.data, [wire.wire_id for wire in wires]), wires, strict=True)
    places = list_places(target.data)
    return sorted(named, key=lambda each: places.get(each[1].wire_id, len(places)))  # unnamed wires last


def editable_name(mesh: bpy.types.Mesh, wire: WireSummary) -> bpy.types.PropertyGroup | None:
    """The entry in the list of names that is this wire's and no other's."""
    return None if wire.shares_id else find_name(mesh, wire.wire_id)


def find_wires(target: bpy.types.Object, take: Take = read_anew) -> list[WireSummary]:
    """As wires_of; take: read_anew, or kept."""
    mesh, seen, wires = marked_mesh(target, take), set(), []
    places = mesh.places.astype(np.float64)
    for chain in chains_of_marks(mesh.edges, mesh.marks, places):
        ends = places[mesh.edges[chain.edges]]
        vectors, shares_id = ends[:, 1] - ends[:, 0], chain.wire_id in seen
        wires.append(WireSummary(chain.wire_id, chain.tolerance, chain.ease, chain.edges, vectors, shares_id))
        seen.add(chain.wire_id)
    return wires


def repair_names(target: bpy.types.Object) -> dict[int, int]:
    """Writes the names, and returns the ids that are still to be written, by edge. In either mode."""
    wires, mesh = find_wires(target), target.data
    ids = [wire.wire_id for wire in wires]
    own = own_ids(ids)
    write_names(mesh, dict(zip(own, chain_names(mesh, ids), strict=True)))
    return {edge: wire_id for wire, wire_id in zip(wires, own, strict=True) if wire.shares_id for edge in wire.edges}
