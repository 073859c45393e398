# SPDX-License-Identifier: GPL-3.0-or-later
"""Where notches are: at the ends of wires, and at equal lengths along both sides of each seam."""

import numpy as np

from ..edge_keys import edge_keys
from ..issues import object_error
from .flat_pieces import FlatPieces
from .outlines import OutlineEdges
from .pattern import Notch
from .seam_sides import SeamFinder, SeamSide

LEAST_SPACING = 1.0  # millimeters
TOO_CLOSE = "Notches so close cannot be cut: choose 1 mm or more, or 0 for none along seams."
CLEAR = 0.2  # of the spacing: so close to a wire's end, or to the end of the seam, there is no other notch


def place_notches(flat: FlatPieces, outline: OutlineEdges, seams: list[list], spacing: float) -> dict[int, list[Notch]]:
    """By piece. seams: of each the edges, as vertex pairs of the model; spacing: along seams, 0 for none.

    Raises ObjectError where the spacing is too small to be cut.
    """
    if 0 < spacing < LEAST_SPACING:
        raise object_error("notch_spacing", TOO_CLOSE)
    at_wires = vertices_at_wires(flat, outline)
    notches: dict[int, list[Notch]] = {}
    for vertex in sorted(at_wires):
        touching = np.flatnonzero((outline.edges == vertex).any(axis=1))
        notch = Notch(flat.vertices[vertex], _unit(outline.inward[touching].sum(axis=0)), "wire")
        notches.setdefault(int(outline.piece[touching[0]]), []).append(notch)
    finder = SeamFinder(flat, outline)
    for sides in [sides for seam in seams for sides in finder.sides(seam)] if spacing > 0 else []:
        lengths = _lengths(flat, sides, at_wires, spacing)
        for side in sides:
            notches.setdefault(side.piece, []).extend(_notches_at(flat, outline, side, lengths))
    return notches


def vertices_at_wires(flat: FlatPieces, outline: OutlineEdges) -> set[int]:
    """On outlines: where a wire that runs through a piece ends, and the same places on the other sides of a seam."""
    count = len(flat.vertices)
    inside = (flat.wire_ids != 0) & ~np.isin(edge_keys(flat.edges, count), edge_keys(outline.edges, count))
    on_outline = np.unique(outline.edges)
    ends = np.intersect1d(flat.edges[inside], on_outline)
    return set(on_outline[np.isin(flat.source_vertex[on_outline], flat.source_vertex[ends])].tolist())


def _lengths(flat: FlatPieces, sides: list[SeamSide], at_wires: set[int], spacing: float) -> list[float]:
    """At which lengths from the start of the seam; the same for all its sides."""
    if not sides:
        return []
    along = sides[0].lengths(flat)
    taken = [along[-1], *(along[place] for place, vertex in enumerate(sides[0].vertices) if vertex in at_wires)]
    lengths = spacing * np.arange(1, int(along[-1] / spacing) + 1)
    return [length for length in lengths.tolist() if np.abs(np.array(taken) - length).min() > CLEAR * spacing]


def _notches_at(flat: FlatPieces, outline: OutlineEdges, side: SeamSide, lengths: list[float]) -> list[Notch]:
    along = side.lengths(flat)
    points = flat.vertices[side.vertices]
    notches = []
    for length, place in zip(lengths, np.searchsorted(along, lengths, side="right") - 1, strict=True):
        share = (length - along[place]) / (along[place + 1] - along[place])
        point = points[place] + share * (points[place + 1] - points[place])
        notches.append(Notch(point, outline.inward[side.edges[place]], "seam"))
    return notches


def _unit(vector: np.ndarray) -> np.ndarray:
    """At the tip of a slit the two sides cancel out: any direction is as good."""
    length = np.linalg.norm(vector)
    return vector / length if length > 1e-9 else np.array([1.0, 0.0])
