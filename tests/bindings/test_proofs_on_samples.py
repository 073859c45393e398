# SPDX-License-Identifier: GPL-3.0-or-later
"""Relations of methods and tolerances on the samples: more tolerance never means more distortion."""

import math

import numpy as np
import pytest
import wirewarp
from samples import SAMPLES, flattened

pytestmark = [pytest.mark.core, pytest.mark.parametrize("name", SAMPLES)]


def least_value(piece: wirewarp.Piece, method: str) -> float:
    """Return the value that the method minimizes."""
    return piece.report.objective if method == "refined" else piece.metrics.arap_energy


@pytest.mark.parametrize("method", ["wirewarp++", "refined"])
def test_more_tolerance_never_means_more_distortion(name, method):
    before = None
    for tolerance in (0, 0.01, 0.03, 0.1, math.inf):
        result = flattened(name, tolerance, method=method)
        least = np.array([least_value(piece, method) for piece in result.pieces])
        # A free wire has no corners, so it contributes less to the refined method's objective.
        if before is not None:
            assert np.all(least <= before * (1 + 1e-6) + 1e-18), f"at {tolerance}"
        for piece in result.pieces:
            assert piece.error is None
            assert piece.report.termination == "converged"
            assert piece.report.gradient_evaluations <= 40
            assert all(abs(part.variation) <= tolerance + 1e-12 for part in piece.wires)
        before = least


def test_without_tolerance_the_methods_of_the_paper_agree(name):
    rigid, kept = flattened(name, 0, method="wirewarp++"), flattened(name, math.inf, method="wirewarping")
    assert rigid.corner_uv == pytest.approx(kept.corner_uv, abs=1e-9 * np.ptp(SAMPLES[name].vertices))
