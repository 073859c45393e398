# SPDX-License-Identifier: GPL-3.0-or-later
"""Identifies wires, pieces and seams by their ids and names on the model, its object and the flat mesh."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import bpy
import numpy as np

from ..blender.attributes import find_values, has_attributes, write_values
from ..blender.mesh import current_mesh, edge_vertices
from ..core import FlattenResult, Report
from ..names import PIECE, SEAM, SOURCE_FACE, SOURCE_VERTEX
from ..solve.arrays import MeshArrays
from ..solve.chains import chains_of_marks, find_edges
from ..solve.identity import GIVEN, KnownPieces, KnownSeams, PieceIdentity, SeamIdentity, ids_by_face
from .marked_mesh import has_marks, marked_mesh, own_ids, read_ids, wires_on
from .memory import Take, kept, read_anew
from .record import read_record


def find_name(mesh: bpy.types.Mesh, wire_id: int) -> bpy.types.PropertyGroup | None:
    """Return the entry of this wire in the list of names; None if there is none."""
    return next((entry for entry in mesh.wirewarp_names if entry.wire_id == wire_id), None)


def list_places(mesh: bpy.types.Mesh) -> dict[int, int]:
    """Return the index of each wire's entry in the list of names, by the wire's id."""
    return {entry.wire_id: place for place, entry in enumerate(mesh.wirewarp_names)}


def names_of(mesh: bpy.types.Mesh, wire_ids: Iterable[int]) -> dict[int, str]:
    """Return the name of each wire by its id. Wires without an entry in the list of names get new names."""
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
    """Return the name of each wire. If several wires have the same id or name, they are named Bust, Bust (2) and so
    on."""
    names, taken = names_of(mesh, wire_ids), dict[str, None]()
    for wire_id in wire_ids:
        taken[_numbered(names[wire_id], taken)] = None
    return list(taken)


def present_names(mesh: bpy.types.Mesh, report: Report) -> dict[int, str]:
    """Return the present name of each wire of a report, by the wire's own id. A copy of a wire has the name of the
    original with a number. mesh: the model's mesh."""
    listed = {entry.wire_id: entry.name for entry in mesh.wirewarp_names}
    names: dict[int, str] = {}
    taken: set[str] = set()
    for wire in report.wires:
        name = listed.get(wire.wire_id) or listed.get(wire.marked_id) or wire.name
        names[wire.wire_id] = _numbered(name, taken)
        taken.add(names[wire.wire_id])
    return names


def update_names(mesh: bpy.types.Mesh, wire_ids: Iterable[int]) -> None:
    """Make one entry in the list of names for each of these ids, and remove all other entries."""
    write_names(mesh, names_of(mesh, wire_ids))


def write_names(mesh: bpy.types.Mesh, names: Mapping[int, str]) -> None:
    """Make the list of names contain exactly these names, by id. Entries keep their order."""
    for index in reversed(range(len(mesh.wirewarp_names))):
        if mesh.wirewarp_names[index].wire_id not in names:
            mesh.wirewarp_names.remove(index)
    places = list_places(mesh)
    for wire_id, name in names.items():
        entry = mesh.wirewarp_names[places[wire_id]] if wire_id in places else mesh.wirewarp_names.add()
        entry.wire_id, entry.name = wire_id, name


def _names_elsewhere(mesh: bpy.types.Mesh, wire_ids: Sequence[int]) -> dict[int, str]:
    """Return the names of wires that came from joined objects. Joining keeps only one object's list of names, but the
    meshes of the other objects exist until the file is saved."""
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
    """Write the names of joined wires before the file is saved, because the meshes with these names are not saved."""
    for mesh in bpy.data.meshes:
        if mesh.library is None and not mesh.is_editmode and has_marks(mesh):
            update_names(mesh, wires_on(mesh))


@dataclass(frozen=True)
class WireSummary:
    """A wire as Flatten reads it: a run of edges with one id, one tolerance and one ease."""

    wire_id: int
    tolerance: float
    ease: float
    edges: list[int]  # edges of the mesh, in order along the wire
    edge_vectors: np.ndarray  # (k,3) in the mesh's own space
    shares_id: bool  # whether an earlier wire has the same id, because the wire was copied or cut in two

    def length(self, linear: np.ndarray) -> float:
        """Return the length in Blender units. linear (3,3): rotation, scale and shear of the object."""
        return float(np.linalg.norm(self.edge_vectors @ linear.T, axis=1).sum())


def wires_of(target: bpy.types.Object) -> list[WireSummary]:
    """Return the wires in the order of the mesh, kept until the mesh changes. Raises ObjectError if an attribute of
    another add-on has one of our names."""
    return kept(target.data, "wires", lambda _: find_wires(target, kept))


def listed_wires(target: bpy.types.Object) -> list[tuple[str, WireSummary]]:
    """Return the wires with their names, in the order of the list of names. Raises ObjectError like wires_of."""
    wires = wires_of(target)
    named = zip(chain_names(target.data, [wire.wire_id for wire in wires]), wires, strict=True)
    places = list_places(target.data)
    return sorted(named, key=lambda each: places.get(each[1].wire_id, len(places)))  # unnamed wires last


def editable_name(mesh: bpy.types.Mesh, wire: WireSummary) -> bpy.types.PropertyGroup | None:
    """Return the entry in the list of names that belongs to this wire alone; None if there is none."""
    return None if wire.shares_id else find_name(mesh, wire.wire_id)


def find_wires(target: bpy.types.Object, take: Take = read_anew) -> list[WireSummary]:
    """Return the wires in the order of the mesh. take: read_anew or kept. Raises ObjectError like wires_of."""
    mesh, seen, wires = marked_mesh(target, take), set(), []
    places = mesh.places.astype(np.float64)
    for chain in chains_of_marks(mesh.edges, mesh.marks, places):
        ends = places[mesh.edges[chain.edges]]
        vectors, shares_id = ends[:, 1] - ends[:, 0], chain.wire_id in seen
        wires.append(WireSummary(chain.wire_id, chain.tolerance, chain.ease, chain.edges, vectors, shares_id))
        seen.add(chain.wire_id)
    return wires


def repair_names(target: bpy.types.Object) -> dict[int, int]:
    """Write the names of all wires to the list of names, in Object Mode or Edit Mode.

    Return, by edge, new ids for wires that share an id. The caller must write these ids.
    """
    wires, mesh = find_wires(target), target.data
    ids = [wire.wire_id for wire in wires]
    own = own_ids(ids)
    write_names(mesh, dict(zip(own, chain_names(mesh, ids), strict=True)))
    return {edge: wire_id for wire, wire_id in zip(wires, own, strict=True) if wire.shares_id for edge in wire.edges}


def piece_names(source: bpy.types.Object) -> dict[int, str]:
    """Return the names of the pieces by id, in the order of the last report."""
    return {entry.piece_id: entry.name for entry in source.wirewarp_pieces}


def known_pieces(
    source: bpy.types.Object, arrays: MeshArrays, flat: bpy.types.Object | None, model_name: str
) -> KnownPieces:
    """Return the pieces of the last run. Their ids are from the flat pieces if these are given and have ids, otherwise
    from the faces of the model. model_name: the model's name in the last run."""
    ids = _ids_of_flat_pieces(flat.data, len(arrays.piece_ids)) if flat else arrays.piece_ids
    return KnownPieces(ids if ids.any() else arrays.piece_ids, piece_names(source), model_name)


def _ids_of_flat_pieces(mesh: bpy.types.Mesh, face_count: int) -> np.ndarray:
    """Return the piece ids (face_count,) of the model's faces, from the flat mesh; zeros if the number of faces has
    changed."""
    ids, record = np.zeros(face_count, dtype=np.int32), read_record(mesh)
    if record and record.source_faces == face_count and has_attributes(mesh, SOURCE_FACE, PIECE):
        faces = find_values(mesh, SOURCE_FACE)
        inside = (faces >= 0) & (faces < face_count)  # faces that the user has added may name any source face
        ids[faces[inside]] = find_values(mesh, PIECE)[inside]
    return ids


def with_new_names(
    source: bpy.types.Object, known: KnownPieces, identities: Sequence[PieceIdentity]
) -> list[PieceIdentity]:
    """Return the identities with the names that the user has changed since `known` was read."""
    renamed = dict(piece_names(source).items() - known.names.items())
    return [replace(identity, name=renamed.get(identity.piece_id, identity.name)) for identity in identities]


def write_pieces(
    source: bpy.types.Object,
    result: FlattenResult,
    arrays: MeshArrays,
    identities: Sequence[PieceIdentity],
    on_model: bool,
) -> None:
    """Write ids and names of the pieces. on_model: whether the arrays were read from the base mesh, so that ids can be
    written to it."""
    source.wirewarp_pieces.clear()
    for identity in identities:
        entry = source.wirewarp_pieces.add()
        entry.piece_id, entry.name = identity.piece_id, identity.name
    if on_model:
        write_values(source.data, PIECE, ids_by_face(result, arrays, identities))


def seam_names(source: bpy.types.Object) -> dict[int, str]:
    """Return the names of all present and former seams by id."""
    return {entry.seam_id: entry.name for entry in source.wirewarp_seams}


def known_seams(source: bpy.types.Object, arrays: MeshArrays, flat: bpy.types.Object | None) -> KnownSeams:
    """Return the seams of the last run. Their ids are from the flat pieces if these are given and have ids, otherwise
    from the seam edges of the model."""
    ids = _seam_ids_of_flat_pieces(flat.data, arrays) if flat else arrays.seam_ids
    return KnownSeams(ids if ids.any() else arrays.seam_ids, seam_names(source))


def _seam_ids_of_flat_pieces(mesh: bpy.types.Mesh, arrays: MeshArrays) -> np.ndarray:
    """Return the seam ids (k,) of the model's seam edges, from the flat mesh; zeros if the number of faces has
    changed."""
    ids, found = np.zeros(len(arrays.seams), dtype=np.int32), find_values(mesh, SEAM)
    record = read_record(mesh)
    is_same = record is not None and record.source_faces == len(arrays.polygon_starts)
    if found is None or not is_same or not has_attributes(mesh, SOURCE_VERTEX):
        return ids
    marked = np.flatnonzero(found)
    count = len(arrays.vertices)
    sources = find_values(mesh, SOURCE_VERTEX)[edge_vertices(mesh)[marked]]
    inside = ((sources >= 0) & (sources < count)).all(axis=1)  # vertices that the user has added may name any source
    place = find_edges(arrays.seams, sources[inside])
    ids[place >= 0] = found[marked[inside][place[place >= 0]]]
    return ids


def write_seams(
    source: bpy.types.Object, arrays: MeshArrays, identities: Sequence[SeamIdentity], on_model: bool
) -> None:
    """Write ids and names of the seams. Keep names that the user has changed.

    arrays: model with the new ids
    on_model: whether the arrays were read from the base mesh, which then gets the ids
    """
    places = {entry.seam_id: place for place, entry in enumerate(source.wirewarp_seams)}
    for identity in identities:  # accessed by index, because add() moves the entries in memory
        place = places.get(identity.seam_id)
        entry = source.wirewarp_seams.add() if place is None else source.wirewarp_seams[place]
        if not entry.name or GIVEN.fullmatch(entry.name):
            entry.seam_id, entry.name = identity.seam_id, identity.name
    if on_model:
        with current_mesh(source) as mesh:
            ids = read_ids(mesh, SEAM)
        ids[arrays.seam_edges] = arrays.seam_ids
        write_values(source.data, SEAM, ids)
