# SPDX-License-Identifier: GPL-3.0-or-later
"""The samples of the add-on, flattened by the Python package; tests that share a result only read it."""

import sys
from functools import cache
from pathlib import Path

import wirewarp

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "blend_samples"))

from shapes import Shape, all_shapes

SAMPLES = {shape.name: shape for shape in all_shapes()}


def flatten(shape: Shape, tolerance: float | None = None, eases=(), **options) -> wirewarp.FlattenResult:
    """Flatten a sample. tolerance: of all wires, instead of their own."""
    wires = [
        wirewarp.Wire(wire.vertices, wire.tolerance if tolerance is None else tolerance, wire.name)
        for wire in shape.wires
    ]
    return wirewarp.flatten(
        shape.vertices,
        shape.triangles(),
        seams=shape.seams,
        wires=wires,
        eases=eases,
        options=wirewarp.Options(**options),
    )


@cache
def flattened(name: str, tolerance: float | None = None, **options) -> wirewarp.FlattenResult:
    return flatten(SAMPLES[name], tolerance, **options)


@cache
def flattened_as_made(name: str) -> wirewarp.FlattenResult:
    """Flatten a sample with its eases and in its fabric."""
    shape = SAMPLES[name]
    cloth = None
    if shape.cloth:
        cloth = wirewarp.Cloth(**wirewarp.Cloth.preset(shape.cloth).to_dict() | {"stretch": shape.stretch})
    eases = [wirewarp.Ease(ease.half_edges, ease.ratio) for ease in shape.eases]
    return flatten(shape, eases=eases, cloth=cloth, fairness=shape.fairness)
