# SPDX-License-Identifier: GPL-3.0-or-later
"""Calculates target lengths of lines: lengths on the model, changed by ease, tolerance and the fabric's stretch."""

from itertools import pairwise

import numpy as np

from .. import BoundaryReport, Piece, WireReport

# A length counts as kept up to this relative error. The library checks every edge to 1e-9, but the lengths of lines
# include the rounding errors of all their edges.
LENGTH_LIMIT = 1e-8


def kept(line: WireReport | BoundaryReport) -> bool:
    """Return whether each edge of the line has its guaranteed length. Return False if the lengths are NaN."""
    return line.max_edge_error <= LENGTH_LIMIT


def asked_of_wire(wire: WireReport, ease: float) -> float:
    """Return the target length of the wire with its ease, without the change h that its tolerance allows.

    If the wire's lengths are kept, its flat length is used, because only this length contains the fabric's built-in
    stretch.
    """
    return wire.length_2d * (1 + ease) / (1 + wire.variation) if kept(wire) else wire.length_3d * (1 + ease)


def asked_of_outline(piece: Piece, vertices: np.ndarray, sides: dict[tuple[int, int], float]) -> list[float]:
    """Return the target length of each section of the outline, including the change h of wires along the outline.

    vertices (n,3): vertices of the model. sides: eases by directed edge, for edges with an ease on one side.
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
    """Return the mean ratio of the target length to the length on the model, weighted by the lengths of the edges.

    ratios: ratios by directed edge; edges without a ratio have the ratio 1.
    """
    lengths = np.linalg.norm(np.diff(vertices[chain.vertices], axis=0), axis=1)
    own = [ratios.get(step, 1.0) for step in pairwise(chain.vertices.tolist())]
    return float(np.average(own, weights=lengths))
