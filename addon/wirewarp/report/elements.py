# SPDX-License-Identifier: GPL-3.0-or-later
"""From an entry of a report to the elements it is about, on the model and on the flat pieces."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from ..pattern.chains import edge_keys
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


@dataclass(frozen=True)
class FlatSources:
    """Where the elements of a flat mesh come from."""

    vertices: np.ndarray  # (p,) of the model
    edges: np.ndarray  # (e,2) vertices of the flat mesh
    faces: np.ndarray  # (f,) of the model
    piece: np.ndarray  # (f,)
    loop_vertices: np.ndarray  # (l,) vertices of the flat mesh, face by face
    face_sizes: np.ndarray  # (f,)


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


def on_flat(elements: Elements, flat: FlatSources) -> Elements:
    """The same on the flat pieces; an edge along a seam is there once a side."""
    in_piece = np.full(len(flat.faces), True) if elements.piece is None else flat.piece == elements.piece
    if elements.whole_piece:
        return Elements(faces=np.flatnonzero(in_piece))
    reached = np.zeros(len(flat.vertices), dtype=bool)
    reached[flat.loop_vertices[np.repeat(in_piece, flat.face_sizes)]] = True
    count = int(max(flat.vertices.max(initial=0), np.max(elements.edges, initial=0))) + 1
    wanted = np.isin(edge_keys(flat.vertices[flat.edges], count), edge_keys(elements.edges, count))
    return Elements(
        vertices=np.flatnonzero(np.isin(flat.vertices, elements.vertices) & reached),
        edges=flat.edges[wanted & reached[flat.edges].all(axis=1)],
        faces=np.flatnonzero(np.isin(flat.faces, elements.faces) & in_piece),
    )


def faces_of_piece(piece: int, flat: FlatSources) -> np.ndarray:
    """On the model."""
    return flat.faces[flat.piece == piece]
