# SPDX-License-Identifier: GPL-3.0-or-later
"""The wires inside flat pieces; along an outline there is the cut line already."""

import numpy as np

from ..edge_keys import edge_keys
from ..wire_chains import WireChain, chains_of_marks
from .flat_pieces import FlatPieces, piece_of_vertices
from .outlines import OutlineEdges


def inner_wires(flat: FlatPieces, outline: OutlineEdges) -> dict[int, list[WireChain]]:
    """By piece, each as one run of vertices of the flat pieces."""
    count, marked = len(flat.vertices), np.flatnonzero(flat.wire_ids)
    edges, ids = flat.edges[marked], flat.wire_ids[marked]
    on_outline = np.isin(edge_keys(edges, count), edge_keys(outline.edges, count))
    piece_of_vertex = piece_of_vertices(count, flat.loop_vertices, flat.face_sizes, flat.face_piece)
    wires: dict[int, list[WireChain]] = {}
    for chain in chains_of_marks(edges, np.where(on_outline, 0, ids), flat.tolerances[marked], flat.vertices):
        wires.setdefault(int(piece_of_vertex[chain.vertices[0]]), []).append(chain)
    return wires
