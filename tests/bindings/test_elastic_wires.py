# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic and free wires have lengths within their tolerance, with the least distortion."""

import math

import numpy as np
import pytest
import wirewarp
from surfaces import Mesh, half_cylinder, spherical_patch

pytestmark = pytest.mark.core

PARALLEL = list(range(36, 45))  # across the middle of an 8 by 8 patch
MERIDIAN = list(range(4, 81, 9))


METHODS = pytest.mark.parametrize("method", ["wirewarp++", "refined"])


def flatten(mesh: Mesh, *tolerances: float, **options) -> wirewarp.Piece:
    """Flatten the patch with its meridian and its parallel at these tolerances; one tolerance is for both."""
    wires = [
        wirewarp.Wire(chain, tolerance) for chain, tolerance in zip((MERIDIAN, PARALLEL), tolerances * 2, strict=False)
    ]
    (piece,) = wirewarp.flatten(*mesh, wires=wires, options=wirewarp.Options(**options)).pieces
    assert piece.error is None
    return piece


def energy(piece: wirewarp.Piece) -> float:
    return piece.metrics.arap_energy


@pytest.fixture
def patch() -> Mesh:
    return spherical_patch(columns=8, rows=8)


def test_the_default_method_uses_the_tolerances(patch):
    result = wirewarp.flatten(*patch, wires=[wirewarp.Wire(PARALLEL, 0.02)])
    assert wirewarp.Options().method == result.report["method"] == "refined"
    assert abs(result.wires[0].variation) > 1e-3


@METHODS
@pytest.mark.parametrize("tolerance", [0.001, 0.01, 0.05, 0.5])
def test_an_elastic_wire_has_its_length_within_the_tolerance(patch, tolerance, method):
    piece = flatten(patch, tolerance, method=method)
    for part in piece.wires:
        assert (part.kind, part.tolerance) == ("elastic", tolerance)
        assert abs(part.variation) <= tolerance + 1e-12
        assert part.length_2d == pytest.approx((1 + part.variation) * part.length_3d, rel=1e-9)
        assert part.max_edge_error < 1e-9  # all edges change by the same share
    for boundary in piece.boundaries:
        assert boundary.length_2d == pytest.approx(boundary.length_3d, rel=1e-9)


@METHODS
def test_more_tolerance_never_means_more_distortion(patch, method):
    energies = [energy(flatten(patch, tolerance, method=method)) for tolerance in (0, 0.01, 0.02, 0.05, 0.2, math.inf)]
    assert np.all(np.diff(energies) <= 1e-6 * energies[0])
    assert energies[-1] < 0.8 * energies[0]


@METHODS
def test_a_narrow_tolerance_is_used_up_and_a_wide_one_is_not(patch, method):
    narrow, wide = flatten(patch, 0.001, method=method), flatten(patch, 0.5, method=method)
    assert [abs(part.variation) for part in narrow.wires] == pytest.approx([0.001, 0.001], abs=1e-9)
    assert all(abs(part.variation) < 0.4 for part in wide.wires)


def test_of_the_paper_a_free_wire_goes_where_a_wide_tolerance_lets_it(patch):
    free, wide = flatten(patch, math.inf, method="wirewarp++"), flatten(patch, 0.5, method="wirewarp++")
    assert [part.kind for part in free.wires] == ["super_elastic", "super_elastic"]
    assert energy(free) == pytest.approx(energy(wide), rel=1e-5)
    for part in free.wires:
        assert part.length_2d == pytest.approx((1 + part.variation) * part.length_3d, rel=1e-9)


@METHODS
def test_a_wire_beside_an_elastic_one_stays_rigid(patch, method):
    meridian, parallel = flatten(patch, 0.0, 0.05, method=method).wires
    assert (meridian.kind, meridian.variation) == ("rigid", 0)
    assert meridian.length_2d == pytest.approx(meridian.length_3d, rel=1e-9)
    assert abs(parallel.variation) > 1e-3


@pytest.mark.parametrize("node_weight", ["length", "uniform"])
def test_tolerance_0_is_the_rigid_method(patch, node_weight):
    elastic = flatten(patch, 0.0, method="wirewarp++", node_weight=node_weight)
    rigid = flatten(patch, 0.0, method="wirewarping", node_weight=node_weight)
    assert elastic.vertices == pytest.approx(rigid.vertices, abs=1e-9)


@pytest.mark.parametrize("tolerance", [0.05, math.inf])
def test_the_rigid_method_uses_no_tolerance(patch, tolerance):
    kept = flatten(patch, tolerance, method="wirewarping")
    assert kept.vertices == pytest.approx(flatten(patch, 0.0, method="wirewarp++").vertices, abs=1e-9)
    for part in kept.wires:
        assert (part.tolerance, part.variation) == (tolerance, 0)
        assert part.length_2d == pytest.approx(part.length_3d, rel=1e-9)


@METHODS
def test_each_part_of_a_wire_has_its_own_length(method):
    """The patch is divided off the middle, so the two parts of the parallel differ in length and in curvature."""
    vertices, faces = spherical_patch(columns=8, rows=8)
    seam = [(v, v + 9) for v in range(2, 72, 9)]
    result = wirewarp.flatten(
        vertices,
        faces,
        seams=seam,
        wires=[wirewarp.Wire(PARALLEL, 0.5)],
        options=wirewarp.Options(method=method),
    )
    short, long = sorted((part for piece in result.pieces for part in piece.wires), key=lambda part: part.length_3d)
    assert abs(short.variation - long.variation) > 1e-3
    (whole,) = result.wires
    assert whole.length_2d == pytest.approx(short.length_2d + long.length_2d, rel=1e-12)
    assert whole.variation == pytest.approx(whole.length_2d / whole.length_3d - 1, rel=1e-9)


def test_what_was_done_is_counted(patch):
    rigid, elastic = (flatten(patch, tolerance, method="wirewarp++").report for tolerance in (0.0, 0.05))
    assert rigid.outer_iterations == rigid.gradient_evaluations == 0
    assert elastic.outer_iterations > 0
    assert elastic.gradient_evaluations > elastic.outer_iterations
    assert elastic.termination == "converged"
    refined = flatten(patch, 0.05).report
    assert refined.outer_iterations > 0  # near the end, several steps use one factor
    assert 0 < refined.factorizations <= 8
    assert refined.inner_solves == refined.gradient_evaluations == 0
    assert refined.termination == "converged"


def test_where_nothing_is_distorted_no_length_is_changed():
    vertices, faces = half_cylinder(columns=8, rows=4)
    wires = [wirewarp.Wire(range(18, 27), 0.05)]
    (piece,) = wirewarp.flatten(vertices, faces, wires=wires, options=wirewarp.Options(method="wirewarp++")).pieces
    assert piece.wires[0].variation == 0
    assert piece.report.gradient_evaluations == 0
    assert piece.report.termination == "converged"


def test_a_run_can_be_cancelled_while_lengths_are_chosen(patch):
    calls = []

    def progress(stage: str, _fraction: float) -> bool:
        calls.append(stage)
        return calls.count("lengths") < 4

    wires = [wirewarp.Wire(PARALLEL, 0.05)]
    options = wirewarp.Options(method="wirewarp++")
    (piece,) = wirewarp.flatten(*patch, wires=wires, options=options, progress=progress).pieces
    assert piece.error.code is wirewarp.ErrorCode.cancelled
    assert calls.count("lengths") == 4
