# SPDX-License-Identifier: GPL-3.0-or-later
"""From the flat pieces to a pattern."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..edge_keys import edge_keys
from ..wire_chains import WireChain, chains_of_marks
from .flat_pieces import FlatPieces
from .interior import place_text
from .notches import place_notches
from .outlines import outline_edges, outline_loops
from .pattern import Pattern, PatternPiece, PatternWire

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
    outline = outline_edges(flat.vertices, flat.loop_vertices, flat.face_sizes, flat.face_piece)
    notches = place_notches(flat, outline, seams, spacing)
    wires = _wires_by_piece(flat, outline.edges, wire_names)
    pieces = []
    for index, label in labels.items():
        outlines = [flat.vertices[loop] for loop in outline_loops(outline, index)]
        inside = wires.get(index, [])
        text = place_text(label.lines, outlines, [wire.points for wire in inside], TEXT_HEIGHT)
        pieces.append(PatternPiece(label.name, outlines, inside, notches.get(index, []), text))
    return Pattern(title, pieces)


def _wires_by_piece(flat: FlatPieces, outline: np.ndarray, names: Mapping[int, str]) -> dict[int, list[PatternWire]]:
    """Wires inside the pieces; on an outline the cut line is there already."""
    count = len(flat.vertices)
    on_outline = np.isin(edge_keys(flat.edges, count), edge_keys(outline, count))
    wire_ids = np.where(on_outline, 0, flat.wire_ids)
    piece_of_vertex = np.zeros(count, dtype=np.int64)
    piece_of_vertex[flat.loop_vertices] = np.repeat(flat.face_piece, flat.face_sizes)
    wires: dict[int, list[PatternWire]] = {}
    for chain in chains_of_marks(flat.edges, wire_ids, flat.tolerances, flat.vertices):
        wire = PatternWire(names[chain.wire_id], _kind(chain), flat.vertices[chain.vertices])
        wires.setdefault(int(piece_of_vertex[chain.vertices[0]]), []).append(wire)
    return wires


def _kind(chain: WireChain) -> str:
    if chain.tolerance == 0:
        return "rigid"
    return "free" if math.isinf(chain.tolerance) else "elastic"
