# SPDX-License-Identifier: GPL-3.0-or-later
"""Methods and tolerances on the samples: the reported objective, and the effect of more tolerance on it."""

import math

import numpy as np
import pytest
import wirewarp
from fairness_term import fairness_term, flip_barrier
from samples import SAMPLES, Shape, flatten, flattened
from surfaces import chain_edges, spherical_patch

pytestmark = pytest.mark.core


def fairness_of(
    shape: Shape, tolerance: float | None, piece: wirewarp.Piece, fairness: float = wirewarp.Options().fairness
) -> float:
    held = [
        edge
        for wire in shape.wires
        if math.isfinite(wire.tolerance if tolerance is None else tolerance)
        for edge in chain_edges(list(wire.vertices))
    ]
    return fairness_term(piece, shape.vertices, held, fairness)


def objective(shape: Shape, tolerance: float | None, piece: wirewarp.Piece) -> float:
    beside = fairness_of(shape, tolerance, piece) + flip_barrier(piece, shape.vertices)
    return piece.metrics.arap_energy + beside


@pytest.mark.parametrize("name", SAMPLES)
def test_more_tolerance_never_means_more_distortion(name):
    for method in ("wirewarp++", "refined"):
        before = math.inf
        for tolerance in (0, 0.05, math.inf):  # a free wire has no corners, so the objective has fewer terms
            pieces = flattened(name, tolerance, method=method).pieces
            least = [piece.report.objective if method == "refined" else piece.metrics.arap_energy for piece in pieces]
            assert np.all(least <= np.multiply(before, 1 + 1e-6) + 1e-18), (method, tolerance)
            for piece in pieces:
                assert piece.error is None
                assert piece.report.termination == "converged" and piece.report.gradient_evaluations <= 40
                assert all(abs(part.variation) <= tolerance + 1e-12 for part in piece.wires)
            before = least
    rigid, kept = flattened(name, 0, method="wirewarp++"), flattened(name, math.inf, method="wirewarping")
    assert rigid.corner_uv == pytest.approx(kept.corner_uv, abs=1e-9 * np.ptp(SAMPLES[name].vertices))


@pytest.mark.parametrize("tolerance", [0, 0.05, None], ids=["rigid", "elastic", "as marked"])
@pytest.mark.parametrize("name", SAMPLES)
def test_no_shape_with_these_lengths_has_a_lower_objective(name, tolerance):
    shape = SAMPLES[name]
    refined, warped = flattened(name, tolerance), flattened(name, tolerance, method="wirewarp++")
    for piece, other in zip(refined.pieces, warped.pieces, strict=True):
        assert piece.report.factorizations <= 20
        assert piece.report.objective == pytest.approx(objective(shape, tolerance, piece), rel=1e-6, abs=1e-18)
        assert piece.report.objective <= objective(shape, tolerance, other) * (1 + 1e-9) + 1e-18
        for chain in (*piece.wires, *piece.boundaries):
            assert chain.max_edge_error < 1e-9


# for larger values, corners have less weight than in fairness_term
@pytest.mark.parametrize("fairness", [0.03, 0.1, 0.2])
def test_fairness_trades_distortion_for_smooth_wires(fairness):
    shape = SAMPLES["Quarter sphere"]
    (piece,) = flatten(shape, 0, fairness=fairness).pieces
    (fairer,) = flatten(shape, 0, fairness=2 * fairness).pieces
    assert piece.error is None
    assert fairer.error is None
    # Each minimizes its own E + s F: a larger s gives more E and less F.
    assert fairer.metrics.arap_energy > piece.metrics.arap_energy
    assert fairness_of(shape, 0, fairer) < fairness_of(shape, 0, piece)
    assert fairer.metrics.arap_energy + fairness_of(shape, 0, fairer, fairness) > piece.report.objective


def test_free_wires_have_no_effect():
    vertices, faces = spherical_patch(columns=8, rows=8)
    chains = [range(36, 45), range(4, 81, 9)]
    free = wirewarp.flatten(vertices, faces, wires=[wirewarp.Wire(chain, math.inf) for chain in chains])
    unmarked = wirewarp.flatten(vertices, faces)
    # The two pieces may differ by a rotation, because a piece is aligned with its wires.
    assert free.pieces[0].report.objective == pytest.approx(unmarked.pieces[0].report.objective, rel=1e-12)
    assert free.pieces[0].metrics.face_arap == pytest.approx(unmarked.pieces[0].metrics.face_arap, rel=1e-9)
    for part in free.pieces[0].wires:
        assert part.length_2d == pytest.approx((1 + part.variation) * part.length_3d, rel=1e-12)


def test_a_budget_of_one_factorization_leaves_exact_lengths():
    vertices, faces = spherical_patch(columns=12, rows=12)
    (piece,) = wirewarp.flatten(vertices, faces, options=wirewarp.Options(max_factorizations=1)).pieces
    assert piece.error is None
    assert piece.report.factorizations == 1
    assert piece.report.termination == "stalled"
    assert any("stopped short" in warning for warning in piece.report.warnings)
    (best,) = wirewarp.flatten(vertices, faces).pieces
    assert best.report.objective < piece.report.objective
