# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens samples by all methods of docs/results.md, and measures the results with the same code."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import wirewarp
from arap import arap_map
from shapes import Shape
from true_size import at_true_size

Unwraps = dict[str, np.ndarray]  # output of unwrap_in_blender.py: (m, 3, 2) corner UVs by "SAMPLE/METHOD"


def wires_of(shape: Shape) -> list[wirewarp.Wire]:
    return [wirewarp.Wire(wire.vertices, wire.tolerance, wire.name) for wire in shape.wires]


def flatten(shape: Shape, more_wires: Sequence[wirewarp.Wire] = (), **options: str | float) -> wirewarp.FlattenResult:
    """Flatten by WireWarp with the sample's wires and `more_wires`. options: fields of wirewarp.Options."""
    return wirewarp.flatten(
        shape.vertices,
        shape.triangles(),
        seams=shape.seams,
        wires=[*wires_of(shape), *more_wires],
        options=wirewarp.Options(**options),
    )


def flatten_as_made(shape: Shape, cloth: str = "", stretch: tuple[float, float] = (0, 0)) -> wirewarp.FlattenResult:
    """Flatten with the sample's eases and fairness in this fabric. flatten() uses neither eases nor fairness."""
    chosen = wirewarp.Cloth(**wirewarp.Cloth.preset(cloth).to_dict() | {"stretch": stretch}) if cloth else None
    return wirewarp.flatten(
        shape.vertices,
        shape.triangles(),
        seams=shape.seams,
        wires=wires_of(shape),
        eases=[wirewarp.Ease(ease.half_edges, ease.ratio) for ease in shape.eases],
        options=wirewarp.Options(cloth=chosen, fairness=shape.fairness),
    )


def paper_warping(shape: Shape) -> wirewarp.FlattenResult:
    """Flatten by WireWarping as in the paper: the first angles that close all loops, with equal node weights."""
    return flatten(shape, method="wirewarping", inner="least-norm", node_weight="uniform")


def measure(shape: Shape, corner_uv: np.ndarray) -> wirewarp.FlattenResult:
    """Return the measures of a layout (m, 3, 2) in meters, made by any method."""
    return wirewarp.measure(shape.vertices, shape.triangles(), corner_uv, seams=shape.seams, wires=wires_of(shape))


def blender(shape: Shape, unwraps: Unwraps, method: str) -> wirewarp.FlattenResult:
    """Return Blender's unwrap with every island scaled to its area on the model."""
    corner_uv = unwraps[f"{shape.name}/{method}"]
    return measure(shape, at_true_size(corner_uv, measure(shape, corner_uv)))


def arap(shape: Shape, unwraps: Unwraps) -> wirewarp.FlattenResult:
    """Return libigl's ARAP of each piece, which starts from Blender's angle-based unwrap."""
    start = blender(shape, unwraps, "ANGLE_BASED")
    corner_uv = np.empty_like(start.corner_uv)
    for piece in start.pieces:
        uv = arap_map(shape.vertices[piece.source_vertex], piece.faces, piece.vertices)
        corner_uv[piece.source_face] = uv[piece.faces]
    return measure(shape, corner_uv)


METHODS: dict[str, Callable[[Shape, Unwraps], wirewarp.FlattenResult]] = {
    "Blender angle-based": lambda shape, unwraps: blender(shape, unwraps, "ANGLE_BASED"),
    "Blender conformal": lambda shape, unwraps: blender(shape, unwraps, "CONFORMAL"),
    "ARAP": arap,
    "WireWarping": lambda shape, unwraps: flatten(shape, method="wirewarping"),
    "WireWarping++": lambda shape, unwraps: flatten(shape, method="wirewarp++"),
    "Refined": lambda shape, unwraps: flatten(shape, method="refined"),
}
KEEPING_LENGTHS = ("WireWarping", "WireWarping++", "Refined")
