# SPDX-License-Identifier: GPL-3.0-or-later
"""The samples of the add-on, flattened by the Python package."""

import sys
from pathlib import Path

import wirewarp

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "blend_samples"))

from shapes import Shape, all_shapes

SAMPLES = {shape.name: shape for shape in all_shapes()}


def flatten(shape: Shape, **options) -> wirewarp.FlattenResult:
    return wirewarp.flatten(
        shape.vertices,
        shape.triangles(),
        seams=shape.seams,
        wires=[wirewarp.Wire(wire.vertices, wire.tolerance, wire.name) for wire in shape.wires],
        options=wirewarp.Options(**options),
    )


def flatten_as_made(shape: Shape) -> wirewarp.FlattenResult:
    """With the eases of the sample, and in its cloth."""
    cloth = None
    if shape.cloth:
        cloth = wirewarp.Cloth(**wirewarp.Cloth.preset(shape.cloth).to_dict() | {"stretch": shape.stretch})
    return wirewarp.flatten(
        shape.vertices,
        shape.triangles(),
        seams=shape.seams,
        wires=[wirewarp.Wire(wire.vertices, wire.tolerance, wire.name) for wire in shape.wires],
        eases=[wirewarp.Ease(ease.half_edges, ease.ratio) for ease in shape.eases],
        options=wirewarp.Options(cloth=cloth, fairness=shape.fairness),
    )
