# SPDX-License-Identifier: GPL-3.0-or-later
"""Requests with a known solution, which was found independently of this code. Skipped if they are not available."""

import json
from pathlib import Path

import numpy as np
import pytest
import wirewarp

CASES = Path(__file__).parents[2].parent / "shared" / "cases"
NAMES = [
    "false_infeasible",
    "flip_glove",
    "flip_pot_lid",
    "flip_sofa_panel",
    "flip_toy",
    "looser_fails_rigid_is_fine",
    "overlap_overalls",
    "overlap_skirt",
    "overlap_suit_panel",
    "overlap_trouser_panel",
]

pytestmark = pytest.mark.skipif(not CASES.exists(), reason="the requests are not at hand")


def request_of(name: str) -> tuple[np.ndarray, np.ndarray, list[wirewarp.Wire]]:
    """Return vertices, faces and wires."""
    request = json.loads((CASES / f"{name}.json").read_text())
    wires = [wirewarp.Wire(wire["vertices"], wire["tolerance"]) for wire in request["wires"]]
    return np.array(request["vertices"]), np.array(request["faces"]), wires


@pytest.mark.parametrize("name", NAMES)
def test_requests_with_a_solution_are_flattened(name: str) -> None:
    vertices, faces, wires = request_of(name)
    for piece in wirewarp.flatten(vertices, faces, wires=wires).pieces:
        assert piece.error is None


@pytest.mark.parametrize("seed", range(12))
def test_the_order_of_faces_does_not_matter(seed: int) -> None:
    vertices, faces, wires = request_of("face_order_glove")
    shuffled = np.random.default_rng(seed).permutation(faces)
    (piece,) = wirewarp.flatten(vertices, shuffled, wires=wires).pieces
    assert piece.error is None


@pytest.mark.parametrize("name", ["dead_end_trousers", "dead_end_shirt", "dead_end_dress"])
def test_proposed_seams_lead_to_an_answer(name: str) -> None:
    vertices, faces, wires = request_of(name)
    seams: list[tuple[int, int]] = []
    for _ in range(4):
        errors = [piece.error for piece in wirewarp.flatten(vertices, faces, seams=seams, wires=wires).pieces]
        seams += [seam for error in errors if error for seam in error.proposed_seams]
    assert not any(errors)
