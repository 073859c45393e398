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
