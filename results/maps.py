# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws maps on flat pieces: length changes of lines, aspect ratio E_r, ARAP energy E_A, and strain of threads."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import wirewarp
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Colormap, Normalize
from measures import piece_areas
from palette import CLOTH, ENERGY_MAP, INK, LENGTH_MAP, RATIO_MAP, TURNED_OVER
from shapes import Shape

ROUND = (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0)  # the end of a scale is one of these numbers times a power of ten


@dataclass(frozen=True)
class PieceLines:
    """Edges of the outline and wires of a piece."""

    edges: np.ndarray  # (k, 2) vertices of the piece
    is_outline: np.ndarray  # (k,) whether the edge is on the outline
    change: np.ndarray  # (k,) relative change of length


@dataclass(frozen=True)
class Map:
    title: str
    colors: Colormap
    values: Callable[[Shape, wirewarp.Piece], np.ndarray]  # by face; by edge of piece_lines() if on_lines
    base: float  # value without distortion
    shown: float  # share of the values that are within the scale
    is_signed: bool
    on_lines: bool


def piece_lines(shape: Shape, piece: wirewarp.Piece) -> PieceLines:
    """Return the edges of outline and wires."""
    sides = np.concatenate([piece.faces[:, [k, (k + 1) % 3]] for k in range(3)])
    edges, count = np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)
    chains = [np.array(wire.vertices) for wire in shape.wires]
    marked = {frozenset(pair) for c in chains for pair in np.stack([c[:-1], c[1:]], axis=1).tolist()}
    on_wire = np.array([frozenset(pair) in marked for pair in piece.source_vertex[edges].tolist()])
    kept = (count == 1) | on_wire
    edges, is_outline = edges[kept], (count == 1)[kept]
    a, b = edges.T
    source = shape.vertices[piece.source_vertex]
    length_3d = np.linalg.norm(source[a] - source[b], axis=1)
    length_2d = np.linalg.norm(piece.vertices[a] - piece.vertices[b], axis=1)
    return PieceLines(edges, is_outline, length_2d / length_3d - 1)


def thread_strain(piece: wirewarp.Piece) -> np.ndarray:
    """Return the absolute strain (q,) of the more strained thread of each triangle, as a fraction."""
    return np.maximum(np.abs(piece.metrics.face_weft_strain), np.abs(piece.metrics.face_warp_strain))


LENGTHS = Map(
    "length of outline\nand wires, %",
    LENGTH_MAP,
    lambda shape, piece: 100 * piece_lines(shape, piece).change,
    base=0.0,
    shown=0.99,
    is_signed=True,
    on_lines=True,
)
ASPECT_RATIO = Map(
    "aspect ratio $E_r$",
    RATIO_MAP,
    lambda shape, piece: piece.metrics.face_aspect_ratio,
    base=1.0,
    shown=0.96,
    is_signed=False,
    on_lines=False,
)
ARAP_ENERGY = Map(
    "ARAP energy $E_A$\nover area",
    ENERGY_MAP,
    lambda shape, piece: piece.metrics.face_arap / piece_areas(shape.vertices, piece),
    base=0.0,
    shown=0.96,
    is_signed=False,
    on_lines=False,
)
THREAD_STRAIN = Map(
    "strain of the more\nstrained thread, %",
    ENERGY_MAP,
    lambda shape, piece: 100 * thread_strain(piece),
    base=0.0,
    shown=0.96,
    is_signed=False,
    on_lines=False,
)
MAPS = (LENGTHS, ASPECT_RATIO, ARAP_ENERGY)


def scale_of(quantity: Map, shape: Shape, results: list[wirewarp.FlattenResult]) -> Normalize:
    """Return one scale for all results. It ends at a round number and omits the most extreme values of each result."""
    needed = 0.0
    for result in results:
        values = np.concatenate([quantity.values(shape, piece) for piece in result.pieces])
        needed = max(needed, np.quantile(np.abs(values - quantity.base), quantity.shown))
    needed = max(needed, 1e-3)
    power = 10.0 ** np.floor(np.log10(needed))
    end = next(power * r for r in (*ROUND, 10.0) if power * r >= needed * (1 - 1e-9))
    return Normalize(quantity.base - end if quantity.is_signed else quantity.base, quantity.base + end)


def draw_piece(
    axes: Axes, quantity: Map, scale: Normalize, shape: Shape, piece: wirewarp.Piece, uv: np.ndarray
) -> None:
    """Draw a piece. uv (p, 2): its vertices in the picture."""
    values = quantity.values(shape, piece)
    triangles = uv[piece.faces]
    colors = [CLOTH] if quantity.on_lines else quantity.colors(scale(values))
    axes.add_collection(_fill(triangles, colors))
    flipped = np.isin(piece.source_face, piece.metrics.flipped_faces)
    axes.add_collection(_fill(triangles[flipped], [TURNED_OVER]))
    lines = piece_lines(shape, piece)
    width = np.where(lines.is_outline, 1.4, 1.6) if quantity.on_lines else np.where(lines.is_outline, 0.7, 0.6)
    colors = quantity.colors(scale(values)) if quantity.on_lines else INK
    axes.add_collection(LineCollection(uv[lines.edges], colors=colors, linewidths=width, capstyle="round"))


def _fill(triangles: np.ndarray, colors: np.ndarray | list[str]) -> PolyCollection:
    """Return triangles without antialiased borders, which would look like a net."""
    return PolyCollection(triangles, facecolors=colors, edgecolors=colors, linewidths=0.3, antialiased=False)


def draw_scale(axes: Axes, quantity: Map, scale: Normalize, is_exceeded: bool) -> None:
    """Draw a vertical color scale with its values."""
    extend = "neither" if not is_exceeded else "both" if quantity.is_signed else "max"
    bar = axes.figure.colorbar(ScalarMappable(scale, quantity.colors), cax=axes, extend=extend, extendfrac=0.06)
    bar.set_label(quantity.title, fontsize=9)
    bar.ax.tick_params(labelsize=8)
    bar.outline.set_linewidth(0.6)
