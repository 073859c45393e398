# SPDX-License-Identifier: GPL-3.0-or-later
"""Samples with eases, and in fabric that is stretched when worn, are cut with the requested lengths."""

from collections import defaultdict

import numpy as np
import pytest
import wirewarp
from samples import SAMPLES, flattened, flattened_as_made

pytestmark = pytest.mark.core

EASED = [name for name, shape in SAMPLES.items() if shape.eases]
STRETCHED = [name for name, shape in SAMPLES.items() if any(shape.stretch)]


def flat_half_edges(result: wirewarp.FlattenResult) -> dict[tuple[int, int], np.ndarray]:
    """Return planar vectors (2,), by the vertices on the model in the order of their triangle."""
    return {
        (int(piece.source_vertex[a]), int(piece.source_vertex[b])): piece.vertices[b] - piece.vertices[a]
        for piece in result.pieces
        for a, b in np.concatenate([piece.faces[:, [k, (k + 1) % 3]] for k in range(3)]).tolist()
    }


@pytest.mark.parametrize("name", [*EASED, *STRETCHED])
def test_every_piece_is_good(name):
    for piece in flattened_as_made(name).pieces:
        assert piece.error is None
        assert piece.report.termination == "converged"
        assert piece.report.warnings == []


@pytest.mark.parametrize("name", EASED)
def test_eased_sides_and_no_others_are_longer(name):
    shape, flat = SAMPLES[name], flat_half_edges(flattened_as_made(name))
    ratios = {tuple(pair): ease.ratio for ease in shape.eases for pair in ease.half_edges.tolist()}
    assert ratios.keys() <= flat.keys()
    for a, b in shape.seams.tolist():
        length = np.linalg.norm(shape.vertices[a] - shape.vertices[b])
        for side in ((a, b), (b, a)):
            assert np.linalg.norm(flat[side]) == pytest.approx((1 + ratios.get(side, 0)) * length, rel=1e-9)


@pytest.mark.parametrize("name", [*EASED, *STRETCHED])
def test_sides_of_seams_are_equal_after_their_ease(name):
    for seam in flattened_as_made(name).seams:
        left, right = (length / (1 + ease) for length, ease in zip(seam.length_2d, seam.eases, strict=True))
        assert left == pytest.approx(right, rel=1e-12)
        assert seam.mismatch <= 1e-12


def test_the_sleeve_head_is_eased_by_two_to_three_centimeters():
    seams = flattened_as_made("Set-in sleeve").seams
    head = [seam for seam in seams if any(seam.eases)]
    assert len(head) == 2  # two sides, to the front and to the back
    assert 0.020 <= sum(max(seam.length_2d) - min(seam.length_2d) for seam in head) <= 0.030


def test_the_skirt_is_twice_as_wide_as_its_waistband():
    for seam in flattened_as_made("Gathered skirt").seams:
        if any(seam.eases):
            assert max(seam.length_2d) == pytest.approx(2 * min(seam.length_2d), rel=1e-12)


@pytest.mark.parametrize("name", STRETCHED)
def test_negative_ease_follows_the_direction_on_the_cloth(name):
    """The length of an edge across or along the grain is divided by 1 + stretch, that of others by a value in between.

    The length of a seam is divided by the mean of the values of its sides.
    """
    shape = SAMPLES[name]
    unstretched, flat = flat_half_edges(flattened(name, cloth=shape.cloth)), flat_half_edges(flattened_as_made(name))
    shares = defaultdict(list)
    for (a, b), side in unstretched.items():
        is_inside = (b, a) in unstretched and np.allclose(unstretched[b, a], -side, atol=1e-12)
        if not is_inside:
            across = side / np.linalg.norm(side) / (1 + np.array(shape.stretch))
            shares[min(a, b), max(a, b)].append(np.linalg.norm(across))
    for wire in shape.wires:
        for a, b in zip(wire.vertices[:-1], wire.vertices[1:], strict=True):
            direction = unstretched[a, b] / np.linalg.norm(unstretched[a, b])
            shares[min(a, b), max(a, b)].append(np.linalg.norm(direction / (1 + np.array(shape.stretch))))
    for (a, b), found in shares.items():
        length = np.linalg.norm(shape.vertices[a] - shape.vertices[b])
        for side in {(a, b), (b, a)} & flat.keys():
            assert np.linalg.norm(flat[side]) == pytest.approx(np.mean(found) * length, rel=1e-9)
