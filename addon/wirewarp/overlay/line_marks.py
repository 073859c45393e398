# SPDX-License-Identifier: GPL-3.0-or-later
"""Marked edges of a model or of flat pieces: sorted by kind to be drawn, and named. No Blender in here."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..tolerance_text import tolerance_text
from ..wire_chains import shortest_double


@dataclass(frozen=True)
class LineMarks:
    """Every edge that is a seam or part of a wire."""

    ends: np.ndarray  # (k,2,3) float32, in the object's own space
    normals: np.ndarray  # (k,3) float32, of the surface
    vertices: np.ndarray  # (k,2) int32, of the model
    pieces: np.ndarray  # (k,) int32, on the flat pieces; 0 on the model
    seams: np.ndarray  # (k,) bool
    wire_ids: np.ndarray  # (k,) int32, 0 none
    tolerances: np.ndarray  # (k,) float32


@dataclass(frozen=True)
class Name:
    """A text at a point of the surface."""

    text: str
    place: np.ndarray  # (3,)
    normal: np.ndarray  # (3,)


def lines_by_kind(marks: LineMarks) -> dict[str, np.ndarray]:
    """The ends (2k,3) of the edges of each kind that there is, two rows an edge."""
    wires = marks.wire_ids != 0
    members = {
        "seam": marks.seams,
        "rigid": wires & (marks.tolerances == 0),
        "elastic": wires & (marks.tolerances > 0) & np.isfinite(marks.tolerances),
        "free": wires & np.isinf(marks.tolerances),
    }
    return {kind: marks.ends[mask].reshape(-1, 3) for kind, mask in members.items() if mask.any()}


def wire_line_names(marks: LineMarks, names: Mapping[int, str]) -> list[Name]:
    """Of each wire in each piece, in the middle of it; elastic ones with their tolerance."""
    named = []
    for wire_id, tolerance, piece in _groups(marks.wire_ids, marks.tolerances, marks.pieces):
        members = (marks.wire_ids == wire_id) & (marks.tolerances == tolerance) & (marks.pieces == piece)
        text = names[int(wire_id)]
        if 0 < tolerance < np.inf:
            text += f" {tolerance_text(shortest_double(tolerance))}"
        named.append(_name_in_middle(text, marks, members))
    return named


def seam_line_names(marks: LineMarks, seam_of_edge: Mapping[tuple[int, int], int]) -> list[Name]:
    """The number of each seam, in all its pieces. seam_of_edge: index of the seam by an edge's vertices, ascending."""
    pairs = np.sort(marks.vertices, axis=1).tolist()
    numbers = np.array([1 + seam_of_edge.get((a, b), -1) for a, b in pairs], dtype=np.int32)
    return [
        _name_in_middle(f"Seam {number}", marks, (numbers == number) & (marks.pieces == piece))
        for number, piece in _groups(numbers, marks.pieces)
    ]


def _groups(first: np.ndarray, *others: np.ndarray) -> list[tuple]:
    """Every combination that there is of the arrays' entries, with the first not 0."""
    present = np.flatnonzero(first)
    return list(dict.fromkeys(zip(*(column[present] for column in (first, *others)), strict=True)))


def _name_in_middle(text: str, marks: LineMarks, members: np.ndarray) -> Name:
    """At the edge nearest to the mean of all, so that it is on the line, however that bends."""
    rows = np.flatnonzero(members)
    middles = marks.ends[rows].mean(axis=1)
    nearest = np.argmin(np.linalg.norm(middles - middles.mean(axis=0), axis=1))
    return Name(text, middles[nearest], marks.normals[rows[nearest]])
