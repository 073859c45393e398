# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens the add-on's samples with the Python package. Tests share the results, so no test may change a result."""

import sys
from functools import cache
from pathlib import Path

import wirewarp

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "blend_samples"))

from shapes import Shape, all_shapes

SAMPLES = {shape.name: shape for shape in all_shapes()}


def wires_of(shape: Shape, tolerance: float | None = None) -> list[wirewarp.Wire]:
    """Return the wires of a sample. tolerance: if it is not None, it replaces the tolerances of all wires."""
    tolerances = [wire.tolerance if tolerance is None else tolerance for wire in shape.wires]
    return [wirewarp.Wire(wire.vertices, own, wire.name) for wire, own in zip(shape.wires, tolerances, strict=True)]


def eases_of(shape: Shape) -> list[wirewarp.Ease]:
    return [wirewarp.Ease(ease.half_edges, ease.ratio) for ease in shape.eases]


def cloth_of(shape: Shape) -> wirewarp.Cloth | None:
    if not shape.cloth:
        return None
    return wirewarp.Cloth(**wirewarp.Cloth.preset(shape.cloth).to_dict() | {"stretch": shape.stretch})


def flatten(shape: Shape, tolerance: float | None = None, eases=(), **options) -> wirewarp.FlattenResult:
    mesh, options = (shape.vertices, shape.triangles()), wirewarp.Options(**options)
    return wirewarp.flatten(*mesh, seams=shape.seams, wires=wires_of(shape, tolerance), eases=eases, options=options)


def flattened(name: str, tolerance: float | None = None, **options) -> wirewarp.FlattenResult:
    """Return the flattened sample. Each result is computed once."""
    return _flattened(name, tolerance, tuple(sorted(({"method": "refined"} | options).items())))


@cache
def _flattened(name: str, tolerance: float | None, options: tuple) -> wirewarp.FlattenResult:
    return flatten(SAMPLES[name], tolerance, **dict(options))


@cache
def flattened_with_eases(name: str) -> wirewarp.FlattenResult:
    return flatten(SAMPLES[name], eases=eases_of(SAMPLES[name]))


@cache
def flattened_as_made(name: str) -> wirewarp.FlattenResult:
    """Return the sample flattened with its eases and in its fabric."""
    shape = SAMPLES[name]
    return flatten(shape, eases=eases_of(shape), cloth=cloth_of(shape), fairness=shape.fairness)
