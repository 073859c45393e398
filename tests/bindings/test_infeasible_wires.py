# SPDX-License-Identifier: GPL-3.0-or-later
"""The error of rigid wires that contradict one another names them, and its proposal works."""

import pytest
from surfaces import grid
from wirewarp import ErrorCode, Wire, flatten

pytestmark = pytest.mark.core


def test_the_proposed_tolerances_can_be_taken_as_they_are():
    vertices, faces = grid(5, 5, lambda u, v: (u, v, 0.5 * (u - 0.5) * (v - 0.5)))
    sides = {(int(face[k]), int(face[(k + 1) % 3])) for face in faces for k in range(3)}
    wires = [Wire([a, b]) for a, b in sorted(sides) if a < b and (b, a) in sides]
    (piece,) = flatten(vertices, faces, wires=wires).pieces
    assert piece.error.code is ErrorCode.infeasible_lengths
    assert "flattened with" in str(piece.error)
    proposed = dict(piece.error.proposed_tolerances)
    named = {tuple(sorted(wires[index].vertices.tolist())) for index in proposed}
    assert {tuple(sorted(edge)) for edge in piece.error.edges} == named
    assert max(proposed.values()) <= 0.03  # an amount that elastic fabric stretches easily

    looser = [Wire(wire.vertices, proposed.get(i, 0)) for i, wire in enumerate(wires)]
    result = flatten(vertices, faces, wires=looser)
    assert result.pieces[0].error is None or result.pieces[0].error.code in (
        ErrorCode.flipped_faces,
        ErrorCode.overlapping_faces,
    )
    for wire, report in zip(looser, result.wires, strict=True):
        assert abs(report.variation) <= wire.tolerance + 1e-9
