# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds of methods and tolerances, on the samples: more tolerance never means more distortion."""

import math
import sys
from pathlib import Path

import numpy as np
import pytest
import wirewarp

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "blend_samples"))

import shapes

SAMPLES = {shape.name: shape for shape in shapes.all_shapes()}

pytestmark = pytest.mark.parametrize("shape", SAMPLES.values(), ids=SAMPLES)


def flatten(shape: shapes.Shape, tolerance: float, **options) -> wirewarp.FlattenResult:
    """The sample with one tolerance on all its wires."""
    return wirewarp.flatten(
        shape.vertices,
        shape.triangles(),
        seams=shape.seams,
        wires=[wirewarp.Wire(wire.vertices, tolerance, wire.name) for wire in shape.wires],
        options=wirewarp.Options(**options),
    )


def least_value(piece: wirewarp.Piece, method: str) -> float:
    """What the method minimizes."""
    return piece.report.objective if method == "refined" else piece.metrics.arap_energy


@pytest.mark.parametrize("method", ["wirewarp++", "refined"])
def test_more_tolerance_never_means_more_distortion(shape, method):
    before = None
    for tolerance in (0, 0.01, 0.03, 0.1, math.inf):
        result = flatten(shape, tolerance, method=method)
        least = np.array([least_value(piece, method) for piece in result.pieces])
        # A free wire has no corners: it counts for less in what the refined method minimizes.
        if before is not None:
            assert np.all(least <= before * (1 + 1e-6) + 1e-18), f"at {tolerance}"
        for piece in result.pieces:
            assert piece.error is None
            assert piece.report.termination == "converged"
            assert piece.report.gradient_evaluations <= 40
            assert all(abs(part.variation) <= tolerance + 1e-12 for part in piece.wires)
        before = least


def test_without_tolerance_the_methods_of_the_paper_agree(shape):
    rigid, kept = flatten(shape, 0, method="wirewarp++"), flatten(shape, math.inf, method="wirewarping")
    assert rigid.corner_uv == pytest.approx(kept.corner_uv, abs=1e-9 * np.ptp(shape.vertices))
