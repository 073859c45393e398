# SPDX-License-Identifier: GPL-3.0-or-later
"""The refined method on the samples: its objective, and that no method keeps the lengths with less."""

import math
import sys
from pathlib import Path

import numpy as np
import pytest
import wirewarp
from fairness_term import fairness_term, flip_barrier
from surfaces import half_cylinder, spherical_patch

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "blend_samples"))

import shapes

pytestmark = pytest.mark.core

SAMPLES = {shape.name: shape for shape in shapes.all_shapes()}
LENGTH = 1e-9


def chain_edges(chain) -> list[tuple[int, int]]:
    chain = [int(v) for v in chain]
    return list(zip(chain[:-1], chain[1:], strict=True))


def flatten(shape: shapes.Shape, tolerance: float | None, **options) -> wirewarp.FlattenResult:
    """Flatten the sample with one tolerance for its wires, or with None their own."""
    return wirewarp.flatten(
        shape.vertices,
        shape.triangles(),
        seams=shape.seams,
        wires=[
            wirewarp.Wire(wire.vertices, wire.tolerance if tolerance is None else tolerance, wire.name)
            for wire in shape.wires
        ],
        options=wirewarp.Options(**options),
    )


def fairness_of(
    shape: shapes.Shape, tolerance: float | None, piece: wirewarp.Piece, fairness: float = wirewarp.Options().fairness
) -> float:
    held = [
        edge
        for wire in shape.wires
        if math.isfinite(wire.tolerance if tolerance is None else tolerance)
        for edge in chain_edges(wire.vertices)
    ]
    return fairness_term(piece, shape.vertices, held, fairness)


def objective(shape: shapes.Shape, tolerance: float | None, piece: wirewarp.Piece) -> float:
    beside = fairness_of(shape, tolerance, piece) + flip_barrier(piece, shape.vertices)
    return piece.metrics.arap_energy + beside


@pytest.mark.parametrize("tolerance", [0, 0.05, None], ids=["rigid", "elastic", "as marked"])
@pytest.mark.parametrize("shape", SAMPLES.values(), ids=SAMPLES)
def test_no_shape_with_such_lengths_has_less(shape, tolerance):
    refined, warped = flatten(shape, tolerance), flatten(shape, tolerance, method="wirewarp++")
    for piece, other in zip(refined.pieces, warped.pieces, strict=True):
        assert piece.error is None
        assert piece.report.termination == "converged"
        assert piece.report.factorizations <= 20
        assert piece.report.objective == pytest.approx(objective(shape, tolerance, piece), rel=1e-6, abs=1e-18)
        assert piece.report.objective <= objective(shape, tolerance, other) * (1 + 1e-9) + 1e-18
        for chain in (*piece.wires, *piece.boundaries):
            assert chain.max_edge_error < LENGTH
        for part in piece.wires:
            assert part.kind != "elastic" or abs(part.variation) <= part.tolerance + 1e-12


@pytest.mark.parametrize("fairness", [0.03, 0.1, 0.2])  # for larger values, corners weigh less than in fairness_term
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


def test_free_wires_are_as_if_unmarked():
    vertices, faces = spherical_patch(columns=8, rows=8)
    chains = [range(36, 45), range(4, 81, 9)]
    free = wirewarp.flatten(vertices, faces, wires=[wirewarp.Wire(chain, math.inf) for chain in chains])
    unmarked = wirewarp.flatten(vertices, faces)
    # They may be rotated in the plane, because a piece is aligned with its wires.
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


@pytest.mark.parametrize("wires", [[], [wirewarp.Wire(range(78, 91))]], ids=["outline", "wire"])
def test_cancelled_at_any_moment_a_piece_has_exact_lengths_or_says_so(wires):
    vertices, faces = spherical_patch(columns=12, rows=12)
    calls = []
    wirewarp.flatten(vertices, faces, wires=wires, progress=lambda *call: calls.append(call))
    asked = [stage for stage, _ in calls].count("shape")
    assert asked > 2
    for last in range(1, asked):  # the last call of the stage reports its end
        answers = iter(range(1, asked + 1))
        result = wirewarp.flatten(
            vertices,
            faces,
            wires=wires,
            progress=lambda stage, _, answers=answers, last=last: stage != "shape" or next(answers) < last,
        )
        (piece,) = result.pieces
        assert piece.report.termination == "cancelled"
        if piece.error is None:
            assert any(warning.startswith("Canceled") for warning in piece.report.warnings)
            assert max(boundary.max_edge_error for boundary in piece.boundaries) < LENGTH
        else:
            assert piece.error.code is wirewarp.ErrorCode.cancelled
            assert not piece.error.has_layout
            assert np.isnan(result.corner_uv).all()
    assert piece.error is None  # by the last step the lengths are exact


def test_nothing_is_refined_where_nothing_is_distorted():
    vertices, faces = half_cylinder(columns=8, rows=4)
    (piece,) = wirewarp.flatten(vertices, faces, wires=[wirewarp.Wire(range(18, 27), 0.05)]).pieces
    assert piece.report.objective < 1e-20
    assert piece.report.factorizations <= 2
    assert piece.wires[0].variation == pytest.approx(0, abs=1e-9)
