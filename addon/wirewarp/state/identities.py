# SPDX-License-Identifier: GPL-3.0-or-later
"""The lists of pieces and seams on the model's object, where the user renames them, and the ids on its mesh."""

from collections.abc import Sequence
from dataclasses import replace

import bpy
import numpy as np

from ..blender.attributes import find_values, has_attributes, write_values
from ..blender.mesh import edge_vertices
from ..core import FlattenResult
from ..names import PIECE, SEAM, SOURCE_FACE, SOURCE_VERTEX
from ..solve.arrays import MeshArrays
from ..solve.chains import edge_keys
from ..solve.identity import KnownPieces, PieceIdentity, ids_by_face
from ..solve.seams import GIVEN, KnownSeams, SeamIdentity
from .marked_mesh import read_ids
from .record import read_record


def piece_names(source: bpy.types.Object) -> dict[int, str]:
    """By id, in the order of the last report."""
    return {entry.piece_id: entry.name for entry in source.wirewarp_pieces}


def known_pieces(
    source: bpy.types.Object, arrays: MeshArrays, flat: bpy.types.Object | None, model_name: str
) -> KnownPieces:
    """By the ids on the model or, if given, on its flat pieces, which have those of the last run in any case.

    model_name: what the model was called in that run.
    """
    ids = _ids_of_flat_pieces(flat.data, len(arrays.piece_ids)) if flat else arrays.piece_ids
    return KnownPieces(ids if ids.any() else arrays.piece_ids, piece_names(source), model_name)


def _ids_of_flat_pieces(mesh: bpy.types.Mesh, face_count: int) -> np.ndarray:
    """(face_count,) int32 for the model; zeros if it is not, face by face, the one that was flattened."""
    ids, record = np.zeros(face_count, dtype=np.int32), read_record(mesh)
    if record and record.source_faces == face_count and has_attributes(mesh, SOURCE_FACE, PIECE):
        faces = find_values(mesh, SOURCE_FACE)
        inside = (faces >= 0) & (faces < face_count)  # new faces, made by hand, carry none or any
        ids[faces[inside]] = find_values(mesh, PIECE)[inside]
    return ids


def with_new_names(
    source: bpy.types.Object, known: KnownPieces, identities: Sequence[PieceIdentity]
) -> list[PieceIdentity]:
    """What the user has renamed since `known` was read has the new name."""
    renamed = dict(piece_names(source).items() - known.names.items())
    return [replace(identity, name=renamed.get(identity.piece_id, identity.name)) for identity in identities]


def write_pieces(
    source: bpy.types.Object,
    result: FlattenResult,
    arrays: MeshArrays,
    identities: Sequence[PieceIdentity],
    on_model: bool,
) -> None:
    """on_model: the arrays are those of the base mesh, and it may be written."""
    source.wirewarp_pieces.clear()
    for identity in identities:
        entry = source.wirewarp_pieces.add()
        entry.piece_id, entry.name = identity.piece_id, identity.name
    if on_model:
        write_values(source.data, PIECE, ids_by_face(result, arrays, identities))


def seam_names(source: bpy.types.Object) -> dict[int, str]:
    """By id, of all seams there ever were."""
    return {entry.seam_id: entry.name for entry in source.wirewarp_seams}


def known_seams(source: bpy.types.Object, arrays: MeshArrays, flat: bpy.types.Object | None) -> KnownSeams:
    """By the ids on the model or, if given, on its flat pieces, which have those of the last run in any case."""
    ids = _seam_ids_of_flat_pieces(flat.data, arrays) if flat else arrays.seam_ids
    return KnownSeams(ids if ids.any() else arrays.seam_ids, seam_names(source))


def _seam_ids_of_flat_pieces(mesh: bpy.types.Mesh, arrays: MeshArrays) -> np.ndarray:
    """(k,) int32 for the seam edges of the model; zeros if it is not, face by face, the one that was flattened."""
    ids, found = np.zeros(len(arrays.seams), dtype=np.int32), find_values(mesh, SEAM)
    record = read_record(mesh)
    is_same = record is not None and record.source_faces == len(arrays.polygon_starts)
    if found is None or not is_same or not has_attributes(mesh, SOURCE_VERTEX):
        return ids
    marked = np.flatnonzero(found)
    count = len(arrays.vertices)
    sources = find_values(mesh, SOURCE_VERTEX)[edge_vertices(mesh)[marked]]
    inside = ((sources >= 0) & (sources < count)).all(axis=1)  # new edges, made by hand, may carry any
    keys, own = edge_keys(sources[inside], count), edge_keys(arrays.seams, count)
    keys, first = np.unique(keys, return_index=True)
    if len(keys):
        place = np.searchsorted(keys, own).clip(max=len(keys) - 1)
        ids = np.where(keys[place] == own, found[marked[inside]][first[place]], 0).astype(np.int32)
    return ids


def write_seams(
    source: bpy.types.Object, arrays: MeshArrays, identities: Sequence[SeamIdentity], on_model: bool
) -> None:
    """arrays: with the new ids; on_model: they are those of the base mesh, and it may be written.

    Names that the user has given since the model was read stay.
    """
    places = {entry.seam_id: place for place, entry in enumerate(source.wirewarp_seams)}
    for identity in identities:  # by place, because add() moves the entries in memory
        place = places.get(identity.seam_id)
        entry = source.wirewarp_seams.add() if place is None else source.wirewarp_seams[place]
        if not entry.name or GIVEN.fullmatch(entry.name):
            entry.seam_id, entry.name = identity.seam_id, identity.name
    if on_model:
        ids = read_ids(source.data, SEAM)
        ids[arrays.seam_edges] = arrays.seam_ids
        write_values(source.data, SEAM, ids)
