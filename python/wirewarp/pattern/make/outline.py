# SPDX-License-Identifier: GPL-3.0-or-later
"""Defines flat pieces in millimeters, and divides their outlines into chains between junctions."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from ..._errors import FlattenError
from ..checks import problem
from ..geometry import lengths_along, signed_area
from ..narrow import outline_sides, piece_sides

if TYPE_CHECKING:
    from ..._wirewarp import Piece


@dataclass(frozen=True)
class Chain:
    """A part of an outline between two junctions: one side of a seam, or a part that is not sewn."""

    sources: np.ndarray  # (k,) vertices of the model; a closed chain repeats its first vertex
    seam: int | None  # index of the seam; None if nothing is sewn to it


@dataclass(frozen=True)
class FlatWire:
    """A wire inside a piece. Wires along the outline are shown by the stitching line instead."""

    name: str
    kind: str  # "rigid", "elastic" or "super_elastic"
    vertices: np.ndarray  # (k,) vertices of the piece


@dataclass(frozen=True)
class FlatPiece:
    name: str
    vertices: np.ndarray  # (p,2) places in millimeters, y upwards
    source_vertex: np.ndarray  # (p,) vertices of the model
    # These are the edges (b,2) that belong to only one face, as vertices of the piece in the direction of the face.
    outline: np.ndarray
    chains: list[Chain]  # chains in the direction of the outline edges
    wires: list[FlatWire]
    grain: np.ndarray = field(default_factory=lambda: np.array([0.0, 1.0]))  # (2,) unit vector, upright by default


def flat_piece(piece: "Piece", name: str, scale: float) -> FlatPiece:
    """Return the flat piece in millimeters. piece: must have a layout; scale: millimeters in a unit of the model."""
    chains = [Chain(boundary.vertices, boundary.seam) for boundary in piece.boundaries]
    wires = _wires(piece, piece_sides(piece))
    return FlatPiece(name, piece.vertices * scale, piece.source_vertex, outline_sides(piece), chains, wires)


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


# Largest absolute coordinate of a point, in millimeters. Every fabric is smaller, and Clipper's integers allow a
# million times this value.
FARTHEST = 1e8


@dataclass(frozen=True)
class Side:
    """A part of an outline between two junctions, in millimeters. The piece is on its left."""

    piece: int
    sources: np.ndarray  # (k,) vertices of the model; a closed side repeats its first vertex
    points: np.ndarray  # (k,2)
    seam: int | None  # index into the result's seams; None if nothing is sewn to it
    is_turned: bool  # whether the side runs against the direction of the triangles (in a mirrored piece)

    @property
    def is_closed(self) -> bool:
        """Return whether the side is a whole outline, which ends where it starts."""
        return bool(self.sources[0] == self.sources[-1] and np.array_equal(self.points[0], self.points[-1]))

    @property
    def along(self) -> np.ndarray:
        return lengths_along(self.points)


def outlines_of(index: int, piece: FlatPiece) -> list[list[Side]]:
    """Return the closed outlines of a piece, each as its sides in order. Outer outlines run counterclockwise.

    Raises FlattenError for chains off the outline, and for coordinates that are not finite or too large.
    """
    points, ends = piece.vertices, _outline_edges(piece)
    if not np.isfinite(points[piece.outline]).all():
        raise problem(f'"{piece.name}" has NaN or infinite coordinates.')
    farthest = float(np.abs(points[piece.outline]).max())
    if farthest > FARTHEST:
        raise problem(
            f'"{piece.name}" reaches {farthest / 1e6:.4g} km far, but patterns may reach only {FARTHEST / 1e6:g} km: '
            "check the unit of the model."
        )
    chains = []
    for chain in piece.chains:
        sources = chain.sources
        pairs = list(zip(sources[:-1].tolist(), sources[1:].tolist(), strict=True))
        missing = [pair for pair in pairs if pair not in ends]
        if missing:
            raise _not_cut(piece.name, missing, chain.seam is not None)
        vertices = [ends[pairs[0]][0], *(ends[pair][1] for pair in pairs)]
        chains.append((vertices, Side(index, sources, points[vertices], chain.seam, False)))
    loops = _joined(chains)
    areas = [signed_area(np.concatenate([side.points[:-1] for side in loop])) for loop in loops]
    return loops if sum(areas) > 0 else [[_turned(side) for side in reversed(loop)] for loop in loops]


def _not_cut(name: str, edges: list[tuple[int, int]], is_seam: bool) -> FlattenError:
    a, b = edges[0]
    if is_seam:
        message = f'Edge {a}-{b} is a seam inside "{name}" that opens nothing: clear it, or make it longer.'
    else:
        message = f'Edge {a}-{b} should be on the outline of "{name}", but it is not: flatten the model again.'
    return FlattenError("invalid_option", message, edges=edges)


def _outline_edges(piece: FlatPiece) -> dict[tuple[int, int], tuple[int, int]]:
    """Return each outline edge as vertices of the piece, by its vertices of the model."""
    sources = piece.source_vertex[piece.outline]
    return {(a, b): (c, d) for (a, b), (c, d) in zip(sources.tolist(), piece.outline.tolist(), strict=True)}


def _joined(chains: list[tuple[list[int], Side]]) -> list[list[Side]]:
    """Return the sides in closed loops. Each side begins where the side before it ends."""
    waiting: dict[int, list[tuple[list[int], Side]]] = {}
    for chain in chains:
        waiting.setdefault(chain[0][0], []).append(chain)
    loops = []
    while waiting:
        start = next(iter(waiting))
        at, loop = start, []
        while at in waiting:
            vertices, side = waiting[at].pop()
            if not waiting[at]:
                del waiting[at]
            loop.append(side)
            at = vertices[-1]
            if at == start:
                break
        loops.append(loop)
    return loops


def _turned(side: Side) -> Side:
    return Side(side.piece, side.sources[::-1], side.points[::-1], side.seam, True)
