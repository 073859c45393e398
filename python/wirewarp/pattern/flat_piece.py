# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat pieces as a pattern is made of them, wherever they come from."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from .._wirewarp import Piece


@dataclass(frozen=True)
class Chain:
    """A part of an outline between junctions."""

    sources: np.ndarray  # (k,) vertices of the model; a closed chain repeats its first
    seam: int | None  # index of the seam; None where nothing is sewn to it


@dataclass(frozen=True)
class FlatWire:
    """A wire inside of the piece; along the outline there is the sew line already."""

    name: str
    kind: str  # "rigid", "elastic" or "super_elastic"
    vertices: np.ndarray  # (k,) of the piece


@dataclass(frozen=True)
class FlatPiece:
    name: str
    vertices: np.ndarray  # (p,2) millimeters, y upwards
    source_vertex: np.ndarray  # (p,) vertices of the model
    outline: np.ndarray  # (b,2) vertices of the piece at both ends of each edge that one face has, as that face runs
    chains: list[Chain]  # which run as these edges do
    wires: list[FlatWire]
    grain: np.ndarray = field(default_factory=lambda: np.array([0.0, 1.0]))  # (2,) unit vector; upright, as laid out


def flat_piece(piece: "Piece", name: str, scale: float) -> FlatPiece:
    """Of a piece that has a layout. scale: millimeters per scene unit."""
    sides = np.concatenate([piece.faces[:, [0, 1]], piece.faces[:, [1, 2]], piece.faces[:, [2, 0]]]).astype(np.int64)
    count = len(piece.vertices)
    forward, backward = sides[:, 0] * count + sides[:, 1], sides[:, 1] * count + sides[:, 0]
    outline = sides[~np.isin(forward, backward)]
    chains = [Chain(boundary.vertices, boundary.seam) for boundary in piece.boundaries]
    return FlatPiece(name, piece.vertices * scale, piece.source_vertex, outline, chains, _wires(piece, sides))


def _wires(piece: "Piece", sides: np.ndarray) -> list[FlatWire]:
    ends = {}
    for a, b in sides.tolist():
        key = (int(piece.source_vertex[a]), int(piece.source_vertex[b]))
        ends[key], ends[key[::-1]] = (a, b), (b, a)
    found = []
    for wire in piece.wires:
        if wire.kind != "boundary":
            pairs = list(zip(wire.vertices[:-1].tolist(), wire.vertices[1:].tolist(), strict=True))
            vertices = np.array([ends[pairs[0]][0], *(ends[pair][1] for pair in pairs)])
            found.append(FlatWire(wire.name, str(wire.kind), vertices))
    return found
