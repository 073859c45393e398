# SPDX-License-Identifier: GPL-3.0-or-later
"""What tolerances gain on the samples: the same tolerance on every wire, none to free.

python blend_samples/compare_tolerances.py        (a Python with the wheel of WireWarp)
"""

from __future__ import annotations

import math

import wirewarp
from shapes import Shape, all_shapes

TOLERANCES = {"rigid": 0.0, "1 %": 0.01, "3 %": 0.03, "5 %": 0.05, "free": math.inf}


def flatten_with(shape: Shape, tolerance: float) -> wirewarp.FlattenResult:
    """Raises FlattenError if a piece breaks a promise."""
    wires = [wirewarp.Wire(wire.vertices, tolerance, wire.name) for wire in shape.wires]
    result = wirewarp.flatten(shape.vertices, shape.triangles(), seams=shape.seams, wires=wires)
    for piece in result.pieces:
        if piece.error:
            raise piece.error
    return result


def distortion(result: wirewarp.FlattenResult) -> str:
    """Energy over the area of all pieces, the worst aspect ratio, and the largest change of a wire part's length."""
    metrics = [piece.metrics for piece in result.pieces]
    energy = sum(m.arap_energy * m.area_3d for m in metrics) / sum(m.area_3d for m in metrics)
    aspect = max(m.face_aspect_ratio.max() for m in metrics)
    change = max(abs(part.variation) for piece in result.pieces for part in piece.wires)
    return f"{energy:.5f}, {aspect:.2f}, {100 * change:.1f} %"


print("ARAP energy over area, worst aspect ratio, largest change of a wire's length\n")
print(f"{'':20}" + "".join(f"{name:>24}" for name in TOLERANCES))
for sample in all_shapes():
    cells = [distortion(flatten_with(sample, tolerance)) for tolerance in TOLERANCES.values()]
    print(f"{sample.name:20}" + "".join(f"{cell:>24}" for cell in cells))
