# SPDX-License-Identifier: GPL-3.0-or-later
"""How long lines were to be: as on the model, but for their ease and for the stretch of the cloth when it is worn."""

from itertools import pairwise

import numpy as np

from ..core import BoundaryReport, Piece, WireReport
from ..solve.arrays import MeshArrays
from ..solve.flatten import eased_half_edges

# Chains add up the rounding of their edges; the library itself checks every edge to 1e-9.
LENGTH_LIMIT = 1e-8


def kept(line: WireReport | BoundaryReport) -> bool:
    """Whether each edge has the length that the library promised. NaN has not."""
    return line.max_edge_error <= LENGTH_LIMIT


def asked_of_wire(wire: WireReport, ease: float) -> float:
    """Where h, which its tolerance allows, is its ease.

    The library says of the stretch of the cloth only that it was kept; pieces that do not keep it have no layout.
    """
    return wire.length_2d * (1 + ease) / (1 + wire.variation) if kept(wire) else wire.length_3d * (1 + ease)


def asked_of_outline(piece: Piece, arrays: MeshArrays) -> list[float]:
    """Of each chain of the outline, see asked_of_wire; with the h that its wires have come to."""
    if all(map(kept, piece.boundaries)):
        return [chain.length_2d for chain in piece.boundaries]
    ratios: dict[tuple[int, int], float] = {}
    for wire in piece.wires:
        for a, b in pairwise(wire.vertices):
            ratios[a, b] = ratios[b, a] = 1 + wire.variation
    half_edges, eases = eased_half_edges(arrays)
    for (a, b), ease in zip(half_edges.tolist(), eases.tolist(), strict=True):
        ratios[a, b] = ratios.get((a, b), 1.0) * (1 + ease)
    return [
        chain.length_2d if kept(chain) else chain.length_3d * _mean_ratio(chain, ratios, arrays.vertices)
        for chain in piece.boundaries
    ]


def _mean_ratio(chain: BoundaryReport, ratios: dict[tuple[int, int], float], vertices: np.ndarray) -> float:
    """By length; ratios: of the directed edges that are to be longer or shorter."""
    lengths = np.linalg.norm(np.diff(vertices[list(chain.vertices)], axis=0), axis=1)
    own = [ratios.get((int(a), int(b)), 1.0) for a, b in pairwise(chain.vertices)]
    return float(np.average(own, weights=lengths))
