# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of pieces on the model's object, where the user renames them, and the ids on its faces."""

from collections.abc import Sequence
from dataclasses import replace

import bpy
import numpy as np

from ..blender.attributes import find_values, has_attributes, write_values
from ..core import FlattenResult
from ..names import PIECE, SOURCE_FACE
from ..solve.arrays import MeshArrays
from ..solve.identity import KnownPieces, PieceIdentity, ids_by_face
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
