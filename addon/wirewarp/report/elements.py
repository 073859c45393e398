# SPDX-License-Identifier: GPL-3.0-or-later
"""From an entry of a report to the elements it is about, on the model and on the flat pieces."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from ..pattern.chains import edge_keys
from ..pattern.outlines import FlatPieces
from .names import open_edges

Indices = Sequence[int] | np.ndarray  # (k,)
Pairs = Sequence[tuple[int, int]] | np.ndarray  # (k,2) vertices
LISTS = {  # where the report keeps what can be selected
    "SEAM": "seams",
    "WIRE": "wires",
    "PIECE": "pieces",
    "STRETCH": "pieces",
    "EASE": "pieces",
    "ISSUE": "issues",
    "HINT": "hints",
}


@dataclass(frozen=True)
class Elements:
    """Of the model, or of the flat mesh; a whole piece has no elements of its own."""

    vertices: Indices = ()
    edges: Pairs = ()
    faces: Indices = ()
    piece: int | None = None  # only in this one
    whole_piece: bool = False


def elements_of(report: dict, what: str, index: int) -> Elements | None:
    """Of the model; None if the report has no such entry."""
    entries: Sequence[Any] = open_edges(report) if what == "OUTLINE" else report[LISTS[what]]
    if index >= len(entries):
        return None
    entry = entries[index]
    match what:
        case "SEAM":
            return Elements(edges=entry["edges"])
        case "WIRE":
            return Elements(edges=list(pairwise(entry["vertices"])))
        case "OUTLINE":
            _, piece, chain = entry
            return Elements(edges=list(pairwise(chain["vertices"])), piece=piece)
        case "PIECE":
            return Elements(piece=index, whole_piece=True)
        case "STRETCH" | "EASE":
            return Elements(faces=entry[f"{what.lower()}_faces"], piece=index)
        case _:  # ISSUE, HINT
            return Elements(entry["vertices"], entry["edges"], entry["faces"], entry["piece"])


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
