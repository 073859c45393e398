# SPDX-License-Identifier: GPL-3.0-or-later
"""From the flat pieces to a pattern."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

from ..wire_chains import WireChain
from .flat_pieces import FlatPieces
from .inner_wires import inner_wires
from .line_names import seam_names, wire_name
from .notches import place_notches
from .outlines import outline_loops, outline_of
from .pattern import Pattern, PatternPiece, PatternWire
from .texts import piece_texts

TEXT_HEIGHT = 8.0  # at most, in millimeters


@dataclass(frozen=True)
class PieceLabel:
    name: str
    lines: tuple[str, ...]  # the text inside the piece


def make_pattern(
    title: str,
    flat: FlatPieces,
    labels: Mapping[int, PieceLabel],
    wire_names: Mapping[int, str],
    seams: list[list],
    spacing: float,
) -> Pattern:
    """flat: in millimeters; labels by piece: the pieces wanted; wire_names by id; seams, spacing: see place_notches."""
    outline = outline_of(flat)
    notches = place_notches(flat, outline, seams, spacing)
    wires = inner_wires(flat, outline)
    texts = piece_texts(flat, outline, wires, {index: label.lines for index, label in labels.items()}, TEXT_HEIGHT)
    at_seams = seam_names(flat, outline, seams)
    pieces = []
    for index, label in labels.items():
        outlines = [flat.vertices[loop] for loop in outline_loops(outline, index)]
        lines = [
            PatternWire(wire_names[wire.wire_id], _kind(wire), flat.vertices[wire.vertices])
            for wire in wires.get(index, [])
        ]
        line_names = at_seams.get(index, []) + [name for name in map(wire_name, lines) if name is not None]
        pieces.append(PatternPiece(label.name, outlines, lines, notches.get(index, []), texts[index], line_names))
    return Pattern(title, pieces)


def _kind(chain: WireChain) -> str:
    if chain.tolerance == 0:
        return "rigid"
    return "free" if math.isinf(chain.tolerance) else "elastic"
