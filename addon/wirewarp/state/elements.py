# SPDX-License-Identifier: GPL-3.0-or-later
"""From elements of the model to the same on the flat pieces, and back."""

import numpy as np

from ..core import Elements
from ..solve.chains import edge_keys
from ..solve.outlines import FlatPieces


def on_flat(elements: Elements, flat: FlatPieces) -> Elements:
    """The same on the flat pieces; an edge along a seam is there once a side."""
    in_piece = np.full(len(flat.face_piece), True) if elements.piece is None else flat.face_piece == elements.piece
    if elements.whole_piece:
        return Elements(faces=np.flatnonzero(in_piece))
    sources = flat.source_vertex
    reached = np.zeros(len(sources), dtype=bool)
    reached[flat.loop_vertices[np.repeat(in_piece, flat.face_sizes)]] = True
    count = int(max(sources.max(initial=0), np.max(elements.edges, initial=0))) + 1
    wanted = np.isin(edge_keys(sources[flat.edges], count), edge_keys(elements.edges, count))
    return Elements(
        vertices=np.flatnonzero(np.isin(sources, elements.vertices) & reached),
        edges=flat.edges[wanted & reached[flat.edges].all(axis=1)],
        faces=np.flatnonzero(np.isin(flat.source_face, elements.faces) & in_piece),
    )


def faces_of_piece(piece: int, flat: FlatPieces) -> np.ndarray:
    """On the model."""
    return flat.source_face[flat.face_piece == piece]
