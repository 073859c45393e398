# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures as colors, and from the flat mesh to the model."""

from dataclasses import dataclass

import numpy as np

from ..pattern.chains import edge_keys
from .arrays import MeshArrays
from .flat_mesh import FlatMesh, edge_length_variation

# Linear RGB at equal steps. From no distortion to the upper end: near white, yellow, orange, red, dark.
_RISING = ((0.93, 0.93, 0.90), (0.98, 0.80, 0.35), (0.93, 0.42, 0.10), (0.65, 0.07, 0.08), (0.18, 0.01, 0.09))
# From eased in over unchanged to stretched: blue, near white, orange.
_TWO_SIDED = ((0.002, 0.08, 0.33), (0.10, 0.33, 0.66), (0.92, 0.90, 0.86), (0.89, 0.35, 0.05), (0.38, 0.05, 0.002))


@dataclass(frozen=True)
class ColorMap:
    """A color attribute of the flat mesh and the values at the two ends of its scale."""

    attribute: str
    label: str
    low: float
    high: float
    is_percent: bool = False
    stops: tuple[tuple[float, float, float], ...] = _RISING

    def colors(self, values: np.ndarray) -> np.ndarray:
        """(k,4) float32 linear RGBA; values beyond the scale get its end's color."""
        stops = np.array(self.stops, dtype=np.float32)
        place = np.clip((values - self.low) / (self.high - self.low), 0, 1) * (len(stops) - 1)
        colors = np.ones((len(values), 4), dtype=np.float32)
        for channel in range(3):
            colors[:, channel] = np.interp(place, np.arange(len(stops)), stops[:, channel])
        return colors

    def number(self, value: float, digits: int = 4) -> str:
        """A value as the scale writes it; of a scale with two sides, with its sign."""
        sign = "+" if self.low < 0 < value else ""
        return f"{sign}{100 * value:.{digits}g} %" if self.is_percent else f"{sign}{value:.{digits}g}"


ASPECT_RATIO = ColorMap("aspect_ratio_color", "Worst direction, as a factor", 1.0, 1.5)
STRETCH = ColorMap("stretch_color", "Stretch of the cloth", -0.1, 0.1, is_percent=True, stops=_TWO_SIDED)
LENGTH_VARIATION = ColorMap("length_variation_color", "Change of length", 0.0, 0.1, is_percent=True)
ARAP_ENERGY = ColorMap("arap_energy_color", "Distortion", 0.0, 0.1)
COLOR_MAPS = (ASPECT_RATIO, STRETCH, LENGTH_VARIATION, ARAP_ENERGY)
NO_LAYOUT = np.array([0.16, 0.18, 0.22, 1.0], dtype=np.float32)  # on none of the scales


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
