# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the texts of all pieces stand."""

from collections.abc import Mapping

from .flat_pieces import FlatPieces
from .inner_wires import inner_wires
from .interior import place_text
from .outlines import outline_edges, outline_loops
from .pattern import PieceText


def piece_texts(flat: FlatPieces, lines: Mapping[int, tuple[str, ...]], largest: float) -> dict[int, PieceText]:
    """By piece; largest: height of the letters at most."""
    outline = outline_edges(flat.vertices, flat.loop_vertices, flat.face_sizes, flat.face_piece)
    wires = inner_wires(flat, outline)
    texts = {}
    for index, own in lines.items():
        outlines = [flat.vertices[loop] for loop in outline_loops(outline, index)]
        inside = [flat.vertices[wire.vertices] for wire in wires.get(index, [])]
        texts[index] = place_text(own, outlines, inside, largest)
    return texts
