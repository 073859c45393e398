# SPDX-License-Identifier: GPL-3.0-or-later
"""The measures of the flat mesh on the faces and edges of the model that they come from. No Blender in here."""

from dataclasses import dataclass

import numpy as np

from .edge_keys import edge_keys
from .flat_mesh import FlatMesh, edge_length_variation
from .mesh_arrays import MeshArrays


@dataclass(frozen=True)
class ModelMaps:
    """Zero where there is no layout."""

    placed: np.ndarray  # (f,) bool, faces with a layout
    arap_energy: np.ndarray  # (f,) float32
    energy_density: np.ndarray  # (f,) float32
    aspect_ratio: np.ndarray  # (f,) float32
    stretch: np.ndarray  # (f,) float32
    length_variation: np.ndarray  # (e,) float32, on a seam the larger of its sides


def model_maps(flat: FlatMesh, flat_edges: np.ndarray, arrays: MeshArrays) -> ModelMaps:
    """flat_edges (k,2): all edges of the flat mesh."""
    return ModelMaps(
        placed=_on_faces(flat, np.ones(len(flat.source_face), dtype=bool), arrays),
        arap_energy=_on_faces(flat, flat.arap_energy, arrays),
        energy_density=_on_faces(flat, flat.energy_density, arrays),
        aspect_ratio=_on_faces(flat, flat.aspect_ratio, arrays),
        stretch=_on_faces(flat, flat.stretch, arrays),
        length_variation=_on_edges(flat, flat_edges, edge_length_variation(flat, flat_edges, arrays), arrays),
    )


def _on_faces(flat: FlatMesh, values: np.ndarray, arrays: MeshArrays) -> np.ndarray:
    on_model = np.zeros(len(arrays.polygon_starts), dtype=values.dtype)
    on_model[flat.source_face] = values
    return on_model


def _on_edges(flat: FlatMesh, flat_edges: np.ndarray, values: np.ndarray, arrays: MeshArrays) -> np.ndarray:
    keys = edge_keys(arrays.edges, len(arrays.vertices))
    order = np.argsort(keys)
    flat_keys = edge_keys(flat.source_vertex[flat_edges], len(arrays.vertices))
    on_model = np.zeros(len(keys), dtype=values.dtype)
    np.maximum.at(on_model, order[np.searchsorted(keys[order], flat_keys)], values)
    return on_model
