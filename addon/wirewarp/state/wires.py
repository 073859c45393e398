# SPDX-License-Identifier: GPL-3.0-or-later
"""The wires of a mesh and their names: gathered from the edge attributes, named by a list on the mesh."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

import bpy
import numpy as np

from ..core import Report
from ..solve.chains import chains_of_marks
from .marked_mesh import has_marks, marked_mesh, own_ids, wires_on
from .memory import Take, kept, read_anew


def find_name(mesh: bpy.types.Mesh, wire_id: int) -> bpy.types.PropertyGroup | None:
    return next((entry for entry in mesh.wirewarp_names if entry.wire_id == wire_id), None)


def list_places(mesh: bpy.types.Mesh) -> dict[int, int]:
    """The place of each id in the list, for sorting."""
    return {entry.wire_id: place for place, entry in enumerate(mesh.wirewarp_names)}


def names_of(mesh: bpy.types.Mesh, wire_ids: Iterable[int]) -> dict[int, str]:
    """The name of each id."""
    present = dict.fromkeys(wire_ids)
    names = {entry.wire_id: entry.name for entry in mesh.wirewarp_names if entry.wire_id in present}
    taken = set(names.values())
    unnamed = [wire_id for wire_id in present if wire_id not in names]
    brought = _names_elsewhere(mesh, unnamed) if unnamed else {}
    for wire_id in unnamed:
        names[wire_id] = _numbered(brought[wire_id], taken) if wire_id in brought else _free_name(taken)
        taken.add(names[wire_id])
    return names


def chain_names(mesh: bpy.types.Mesh, wire_ids: Sequence[int]) -> list[str]:
    """The name of each wire; where several have one id or one name: Bust, Bust (2) and so on."""
    names, taken = names_of(mesh, wire_ids), dict[str, None]()
    for wire_id in wire_ids:
        taken[_numbered(names[wire_id], taken)] = None
    return list(taken)


def present_names(mesh: bpy.types.Mesh, report: Report) -> dict[int, str]:
    """What the wires of a report are called now, by their own ids; none as another, copies as what they are copied of.

    mesh: of the model.
    """
    listed = {entry.wire_id: entry.name for entry in mesh.wirewarp_names}
    names: dict[int, str] = {}
    taken: set[str] = set()
    for wire in report.wires:
        name = listed.get(wire.wire_id) or listed.get(wire.marked_id) or wire.name
        names[wire.wire_id] = _numbered(name, taken)
        taken.add(names[wire.wire_id])
    return names


def update_names(mesh: bpy.types.Mesh, wire_ids: Iterable[int]) -> None:
    """One entry for each of the ids that are on the mesh; entries of vanished wires go."""
    write_names(mesh, names_of(mesh, wire_ids))


def write_names(mesh: bpy.types.Mesh, names: Mapping[int, str]) -> None:
    """Makes the list say these names of these ids and nothing else; entries keep their places."""
    for index in reversed(range(len(mesh.wirewarp_names))):
        if mesh.wirewarp_names[index].wire_id not in names:
            mesh.wirewarp_names.remove(index)
    places = list_places(mesh)
    for wire_id, name in names.items():
        entry = mesh.wirewarp_names[places[wire_id]] if wire_id in places else mesh.wirewarp_names.add()
        entry.wire_id, entry.name = wire_id, name


def _names_elsewhere(mesh: bpy.types.Mesh, wire_ids: Sequence[int]) -> dict[int, str]:
    """Joining keeps one mesh's list of names; the others' meshes are there until the file is saved."""
    return {
        entry.wire_id: entry.name
        for other in bpy.data.meshes
        if other != mesh
        for entry in other.wirewarp_names
        if entry.wire_id in wire_ids
    }


def _numbered(name: str, taken: Collection[str]) -> str:
    number = 2
    numbered = name
    while numbered in taken:
        numbered = f"{name} ({number})"
        number += 1
    return numbered


def _free_name(taken: Collection[str]) -> str:
    number = len(taken) + 1
    while f"Wire {number}" in taken:
        number += 1
    return f"Wire {number}"


def write_brought_names(*_: object) -> None:
    """Before the file is saved: names that joined wires brought along, for the meshes that have them are not saved."""
    for mesh in bpy.data.meshes:
        if mesh.library is None and not mesh.is_editmode and has_marks(mesh):
            update_names(mesh, wires_on(mesh))


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
