# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the texts of all pieces stand."""

from collections.abc import Mapping

from ..wire_chains import WireChain
from .flat_pieces import FlatPieces
from .interior import place_text
from .outlines import OutlineEdges, outline_loops
from .pattern import PieceText


def piece_texts(
    flat: FlatPieces,
    outline: OutlineEdges,
    wires: Mapping[int, list[WireChain]],
    lines: Mapping[int, tuple[str, ...]],
    largest: float,
) -> dict[int, PieceText]:
    """By piece; wires: inside it; largest: height of the letters at most."""
    texts = {}
    for index, own in lines.items():
        outlines = [flat.vertices[loop] for loop in outline_loops(outline, index)]
        inside = [flat.vertices[wire.vertices] for wire in wires.get(index, [])]
        texts[index] = place_text(own, outlines, inside, largest)
    return texts
