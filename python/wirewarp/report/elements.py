# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the elements of the model that an entry of a report is about."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from .model import Report
from .names import open_edges

Indices = Sequence[int] | np.ndarray  # (k,)
EdgePairs = Sequence[tuple[int, int]] | np.ndarray  # (k,2) vertices


@dataclass(frozen=True)
class Elements:
    """Elements of a mesh, to select. An entry about a whole piece names only the piece."""

    vertices: Indices = ()
    edges: EdgePairs = ()
    faces: Indices = ()
    piece: int | None = None  # index of the piece with the elements; None: any piece
    whole_piece: bool = False


def elements_of(report: Report, what: str, index: int) -> Elements | None:
    """Return the elements of one entry of a report; None if the report has no such entry.

    - what="SEAM", "WIRE", "PIECE", "ISSUE" or "HINT": an entry of this kind
    - what="OUTLINE": an open edge
    - what="STRETCH" or "EASE": the place in a piece with the largest stretch or compression
    - index: index among the entries of this kind
    """
    try:
        match what:
            case "SEAM":
                return Elements(edges=report.seams[index].edges)
            case "WIRE":
                return Elements(edges=list(pairwise(report.wires[index].vertices)))
            case "OUTLINE":
                _, piece, chain = open_edges(report)[index]
                return Elements(edges=list(pairwise(chain.vertices)), piece=piece)
            case "PIECE":
                return Elements(piece=report.pieces[index].index, whole_piece=True)
            case "STRETCH":
                return Elements(faces=report.pieces[index].stretch_faces, piece=index)
            case "EASE":
                return Elements(faces=report.pieces[index].ease_faces, piece=index)
            case _:
                entry = (report.issues if what == "ISSUE" else report.hints)[index]
                return Elements(entry.vertices, entry.edges, entry.faces, entry.piece)
    except IndexError:
        return None
