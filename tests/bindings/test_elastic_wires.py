# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic and free wires through Python. Native tests and test_refined_method.py test tolerances."""

import math

import pytest
import wirewarp
from surfaces import spherical_patch

pytestmark = pytest.mark.core

PATCH = spherical_patch(columns=8, rows=8)
PARALLEL = list(range(36, 45))  # a wire across the middle
MERIDIAN = list(range(4, 81, 9))


def flatten(*tolerances: float, **options) -> wirewarp.Piece:
    """Flatten the patch with these tolerances of its meridian and its parallel."""
    chains = zip((MERIDIAN, PARALLEL), tolerances, strict=True)
    wires = [wirewarp.Wire(chain, tolerance) for chain, tolerance in chains]
    (piece,) = wirewarp.flatten(*PATCH, wires=wires, options=wirewarp.Options(**options)).pieces
    assert piece.error is None
    return piece


@pytest.mark.parametrize("method", ["wirewarp++", "refined"])
def test_wires_are_rigid_elastic_or_free_beside_each_other(method):
    rigid, elastic = flatten(0.0, 0.05, method=method).wires
    assert (rigid.kind, rigid.tolerance, rigid.variation) == ("rigid", 0, 0)
    assert (elastic.kind, elastic.tolerance) == ("elastic", 0.05) and 1e-3 < abs(elastic.variation) <= 0.05 + 1e-12
    free, _ = flatten(math.inf, 0.0, method=method).wires
    assert (free.kind, free.tolerance) == ("super_elastic", math.inf) and free.variation != 0
    for part in (rigid, elastic, free):
        assert part.length_2d == pytest.approx((1 + part.variation) * part.length_3d, rel=1e-9)


@pytest.mark.parametrize("method", ["wirewarp++", "refined"])
def test_each_part_of_a_wire_has_its_own_length(method):
    """The seam is beside the patch's middle, so the two parts of the parallel differ in length and in curvature."""
    seam = [(v, v + 9) for v in range(2, 72, 9)]
    options = wirewarp.Options(method=method)
    result = wirewarp.flatten(*PATCH, seams=seam, wires=[wirewarp.Wire(PARALLEL, 0.5)], options=options)
    short, long = sorted((part for piece in result.pieces for part in piece.wires), key=lambda part: part.length_3d)
    assert abs(short.variation - long.variation) > 1e-3
    (whole,) = result.wires
    assert whole.length_2d == pytest.approx(short.length_2d + long.length_2d, rel=1e-12)
    assert whole.variation == pytest.approx(whole.length_2d / whole.length_3d - 1, rel=1e-9)


def test_the_work_is_counted():
    rigid, elastic = (flatten(0.0, tolerance, method="wirewarp++").report for tolerance in (0.0, 0.05))
    assert rigid.outer_iterations == rigid.gradient_evaluations == 0
    assert elastic.gradient_evaluations > elastic.outer_iterations > 0
    refined = flatten(0.05, 0.05).report
    assert refined.outer_iterations > 0
    assert refined.factorizations > 0
    assert refined.inner_solves == refined.gradient_evaluations == 0
    assert rigid.termination == elastic.termination == refined.termination == "converged"
