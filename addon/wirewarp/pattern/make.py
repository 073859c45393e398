# SPDX-License-Identifier: GPL-3.0-or-later
"""From the flat pieces to a pattern."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from .chains import WireChain, chains_of_marks, edge_keys
from .line_names import Room, seam_names, wire_name
from .notches import place_notches
from .outlines import FlatPieces, OutlineEdges, outline_loops, outline_of, piece_of_vertices
from .pattern import Pattern, PatternPiece, PatternWire, Ruler
from .piece_texts import piece_texts
from .seam_sides import seam_sides

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
    ruler: Ruler,
) -> Pattern:
    """flat: in millimeters; labels by piece: the pieces wanted; wire_names by id; seams: of each the edges, as vertex
    pairs of the model; spacing: of notches along seams, 0 for none.

    Raises ObjectError where the spacing is too small to be cut, or a seam is not found on pieces changed by hand.
    """
    outline = outline_of(flat)
    sides = seam_sides(flat, outline, seams)
    notches = place_notches(flat, outline, sides, spacing)
    wires = {
        index: [PatternWire(wire_names[wire.wire_id], _kind(wire), flat.vertices[wire.vertices]) for wire in own]
        for index, own in inner_wires(flat, outline).items()
    }
    inside = {
        index: [wire.points for wire in wires.get(index, [])] + [notch.line for notch in notches.get(index, [])]
        for index in labels
    }
    texts = piece_texts(flat, outline, inside, {index: label.lines for index, label in labels.items()}, TEXT_HEIGHT)
    outlines = {index: [flat.vertices[loop] for loop in outline_loops(outline, index)] for index in labels}
    rooms = {index: Room(outlines[index], inside[index], [texts[index]]) for index in labels}
    at_seams = seam_names(flat, outline, sides, rooms)
    pieces = []
    for index, label in labels.items():
        own = wires.get(index, [])
        names = at_seams.get(index, []) + [name for wire in own if (name := wire_name(wire, rooms[index]))]
        pieces.append(PatternPiece(label.name, outlines[index], own, notches.get(index, []), texts[index], names))
    return Pattern(title, pieces, ruler)


def _kind(chain: WireChain) -> str:
    if chain.tolerance == 0:
        return "rigid"
    return "free" if math.isinf(chain.tolerance) else "elastic"


def inner_wires(flat: FlatPieces, outline: OutlineEdges) -> dict[int, list[WireChain]]:
    """By piece, each as one run of vertices of the flat pieces."""
    count, marks = len(flat.vertices), flat.marks.take(flat.marks.rows)
    edges = flat.edges[flat.marks.rows]
    on_outline = np.isin(edge_keys(edges, count), edge_keys(outline.edges, count))
    piece_of_vertex = piece_of_vertices(count, flat.loop_vertices, flat.face_sizes, flat.face_piece)
    wires: dict[int, list[WireChain]] = {}
    for chain in chains_of_marks(edges, marks.without(on_outline), flat.vertices):
        wires.setdefault(int(piece_of_vertex[chain.vertices[0]]), []).append(chain)
    return wires
