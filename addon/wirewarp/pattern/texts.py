# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the texts of all pieces stand."""

from collections.abc import Mapping

import numpy as np

from .flat_pieces import FlatPieces
from .interior import place_text
from .outlines import OutlineEdges, outline_loops
from .pattern import PieceText


def piece_texts(
    flat: FlatPieces,
    outline: OutlineEdges,
    lines_inside: Mapping[int, list[np.ndarray]],
    lines: Mapping[int, tuple[str, ...]],
    largest: float,
) -> dict[int, PieceText]:
    """By piece; lines_inside (k,2): wires and what else is drawn in it; largest: height of the letters at most."""
    texts = {}
    for index, own in lines.items():
        outlines = [flat.vertices[loop] for loop in outline_loops(outline, index)]
        texts[index] = place_text(own, outlines, lines_inside.get(index, []), largest)
    return texts
