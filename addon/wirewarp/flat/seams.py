# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of seams on the model's object, where the user renames them, and the ids on its edges."""

from collections.abc import Sequence

import bpy
import numpy as np

from ..blender.attributes import find_values, has_attributes, write_values
from ..blender.mesh import edge_vertices
from ..model.attributes import read_ids
from ..names import SEAM, SOURCE_VERTEX
from ..pattern.chains import edge_keys
from ..solve.arrays import MeshArrays
from ..solve.seams import GIVEN, KnownSeams, SeamIdentity
from .record import read_record


def seam_names(source: bpy.types.Object) -> dict[int, str]:
    """By id, of all seams there ever were."""
    return {entry.seam_id: entry.name for entry in source.wirewarp_seams}


def known_seams(source: bpy.types.Object, arrays: MeshArrays, flat: bpy.types.Object | None) -> KnownSeams:
    """By the ids on the model or, if given, on its flat pieces, which have those of the last run in any case."""
    ids = _ids_of_flat_pieces(flat.data, arrays) if flat else arrays.seam_ids
    return KnownSeams(ids if ids.any() else arrays.seam_ids, seam_names(source))


def _ids_of_flat_pieces(mesh: bpy.types.Mesh, arrays: MeshArrays) -> np.ndarray:
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
    entries = {entry.seam_id: entry for entry in source.wirewarp_seams}
    for identity in identities:
        entry = entries.get(identity.seam_id) or source.wirewarp_seams.add()
        if not entry.name or GIVEN.fullmatch(entry.name):
            entry.seam_id, entry.name = identity.seam_id, identity.name
    if on_model:
        ids = read_ids(source.data, SEAM)
        ids[arrays.seam_edges] = arrays.seam_ids
        write_values(source.data, SEAM, ids)
