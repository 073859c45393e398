# SPDX-License-Identifier: GPL-3.0-or-later
"""The model's seams and wires on the edges of the flat mesh. No Blender in here."""

from dataclasses import dataclass

import numpy as np

from .edge_keys import edge_keys
from .flat_mesh import FlatMesh
from .mesh_arrays import MeshArrays


@dataclass(frozen=True)
class FlatMarks:
    """One entry per edge of the flat mesh."""

    seams: np.ndarray  # (e,) bool
    wire_ids: np.ndarray  # (e,) int32, 0 none
    tolerances: np.ndarray  # (e,) float32


def flat_marks(flat: FlatMesh, flat_edges: np.ndarray, arrays: MeshArrays) -> FlatMarks:
    """Of the flat edges (e,2), by the edges of the model they come from."""
    count = len(arrays.vertices)
    keys = edge_keys(flat.source_vertex[flat_edges], count)
    is_seam = np.isin(keys, edge_keys(arrays.seams, count))
    wire_ids, tolerances = np.zeros(len(keys), dtype=np.int32), np.zeros(len(keys), dtype=np.float32)
    if not arrays.wires:
        return FlatMarks(is_seam, wire_ids, tolerances)

    chains = [wire.chain for wire in arrays.wires]
    wire_keys = np.concatenate([edge_keys(np.column_stack([c.vertices[:-1], c.vertices[1:]]), count) for c in chains])
    wire_of_key = np.repeat(np.arange(len(chains)), [len(chain.vertices) - 1 for chain in chains])
    order = np.argsort(wire_keys)
    place = np.searchsorted(wire_keys[order], keys).clip(max=len(order) - 1)
    on_wire = wire_keys[order[place]] == keys
    wire = wire_of_key[order[place[on_wire]]]
    wire_ids[on_wire] = np.array([chain.wire_id for chain in chains], dtype=np.int32)[wire]
    tolerances[on_wire] = np.array([chain.tolerance for chain in chains], dtype=np.float32)[wire]
    return FlatMarks(is_seam, wire_ids, tolerances)
