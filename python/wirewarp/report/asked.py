# SPDX-License-Identifier: GPL-3.0-or-later
"""Target lengths of lines: those on the model, changed by ease, tolerance and the built-in stretch of the fabric."""

from itertools import pairwise

import numpy as np

from .. import BoundaryReport, Piece, WireReport

# Lengths of chains include the rounding errors of their edges, so this is larger than the 1e-9 to which the library
# checks every edge.
LENGTH_LIMIT = 1e-8


def kept(line: WireReport | BoundaryReport) -> bool:
    """Return whether each edge has the length that the library guarantees; False for NaN."""
    return line.max_edge_error <= LENGTH_LIMIT


def asked_of_wire(wire: WireReport, ease: float) -> float:
    """Return the target length of the wire with its ease, before the change h that its tolerance allows.

    The flat length is used if the wire kept its length, because it contains the stretch of the fabric, which the
    library does not report.
    """
    return wire.length_2d * (1 + ease) / (1 + wire.variation) if kept(wire) else wire.length_3d * (1 + ease)


def asked_of_outline(piece: Piece, vertices: np.ndarray, sides: dict[tuple[int, int], float]) -> list[float]:
    """Return the target length of each chain of the outline, with the change h of its wires.

    vertices (n,3): vertices of the model; sides: eases of directed edges that have an ease on one side.
    """
    if all(map(kept, piece.boundaries)):
        return [chain.length_2d for chain in piece.boundaries]
    ratios: dict[tuple[int, int], float] = {}
    for wire in piece.wires:
        for a, b in pairwise(wire.vertices.tolist()):
            ratios[a, b] = ratios[b, a] = 1 + wire.variation
    for edge, ease in sides.items():
        ratios[edge] = ratios.get(edge, 1.0) * (1 + ease)
    return [
        chain.length_2d if kept(chain) else chain.length_3d * _mean_ratio(chain, ratios, vertices)
        for chain in piece.boundaries
    ]


def _mean_ratio(chain: BoundaryReport, ratios: dict[tuple[int, int], float], vertices: np.ndarray) -> float:
    """Return the mean weighted by length. ratios: ratios of the directed edges that have a longer or shorter target."""
    lengths = np.linalg.norm(np.diff(vertices[chain.vertices], axis=0), axis=1)
    own = [ratios.get(step, 1.0) for step in pairwise(chain.vertices.tolist())]
    return float(np.average(own, weights=lengths))
