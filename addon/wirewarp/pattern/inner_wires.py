# SPDX-License-Identifier: GPL-3.0-or-later
"""The wires inside flat pieces; along an outline there is the cut line already."""

import numpy as np

from ..edge_keys import edge_keys
from ..wire_chains import WireChain, chains_of_marks
from .flat_pieces import FlatPieces, piece_of_vertices
from .outlines import OutlineEdges


def inner_wires(flat: FlatPieces, outline: OutlineEdges) -> dict[int, list[WireChain]]:
    """By piece, each as one run of vertices of the flat pieces."""
    count = len(flat.vertices)
    on_outline = np.isin(edge_keys(flat.edges, count), edge_keys(outline.edges, count))
    piece_of_vertex = piece_of_vertices(count, flat.loop_vertices, flat.face_sizes, flat.face_piece)
    wires: dict[int, list[WireChain]] = {}
    for chain in chains_of_marks(flat.edges, np.where(on_outline, 0, flat.wire_ids), flat.tolerances, flat.vertices):
        wires.setdefault(int(piece_of_vertex[chain.vertices[0]]), []).append(chain)
    return wires
