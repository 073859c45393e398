# SPDX-License-Identifier: GPL-3.0-or-later
"""The sewing order on the proof is possible, and the finished measures are those of the model."""

import numpy as np
import pytest
import wirewarp
from patterns import cut_polygon, grid, proof_words, sample
from samples import SAMPLES, flattened
from wirewarp.pattern import Pattern


def euler_characteristic(faces):
    edges = np.unique(np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1), axis=0)
    return len(np.unique(faces)) - len(edges) + len(faces)


CONNECTED = ["Fitted top", "Ball of six gores", "Cushion", "Hat", "Jeans", "Wetsuit upper body", "Toy", "Swimsuit"]


@pytest.mark.parametrize("name", CONNECTED)
def test_the_kinds_of_steps_add_up_to_the_model(name):
    """The Euler characteristic of the model is the sum over the pieces, changed by the steps:

    - Joining two pieces or closing a ring subtracts one.
    - Closing a body adds one.
    """
    steps, result = sample(name).steps, flattened(name)
    assert sorted(step.seam for step in steps) == sorted(f"Seam {n}" for n in range(1, len(result.seams) + 1))
    kinds = [step.kind for step in steps]
    pieces = sum(euler_characteristic(np.asarray(piece.faces)) for piece in result.pieces)
    model = euler_characteristic(np.asarray(SAMPLES[name].triangles()))
    assert model == pieces - (len(result.pieces) - 1) - kinds.count("ring") + kinds.count("closing")


def test_the_top_is_sewn_in_the_usual_order():
    """The order is: shoulders, sleeves while they are flat, sides, and the seams under the arms."""
    names = ("Front", "Back", "Left sleeve", "Right sleeve")
    steps = sample("Fitted top", piece_names=names).steps
    pieces = [set(step.pieces) for step in steps]
    body, sleeves = {"Front", "Back"}, {"Left sleeve", "Right sleeve"}
    assert pieces[:2] == [body, body] and all(own & sleeves and own & body for own in pieces[2:6])
    assert pieces[6:8] == [body, body] and [len(own) for own in pieces[8:]] == [1, 1]
    assert not any(step.has_gap for step in steps)


@pytest.mark.parametrize("name", ["Ball of six gores", "Cushion", "Toy"])
def test_a_closed_body_has_one_gap_to_turn_it_through(name, tmp_path):
    pattern = sample(name)
    (gap,) = (step for step in pattern.steps if step.has_gap)
    lengths = {walk.name: walk.lengths[0] for walk in pattern.walks}
    assert lengths[gap.seam] > 150 or lengths[gap.seam] == max(lengths.values())
    words = proof_words(pattern, tmp_path / "a.pdf")
    assert words.count("leave a gap for turning") == 1 and "close the gap by hand" in words


def test_a_dart_is_closed_first(tmp_path):
    """The dart is in the upper of two pieces, from the free edge to the middle of the piece."""
    pattern = Pattern.from_result(grid([0, 100, 200], [-80, 0, 50, 100], seams=[(3, 4), (4, 5), (7, 10)]))
    assert [step.kind for step in pattern.steps] == ["dart", "flat"]
    areas = sorted(cut_polygon(piece).area for piece in pattern.pieces)
    assert areas == pytest.approx([220 * 100, 220 * 120], rel=1e-6)  # the closed dart leaves no gap
    assert "Close the dart in Piece" in proof_words(pattern, tmp_path / "a.pdf")


def test_a_closed_body_beside_an_open_one_has_its_gap():
    """The bodies are a tetrahedron of four triangles and a strip of two pieces."""
    corners = 0.1 * np.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)])
    strip = np.array([(x, y, 0) for y in (1.0, 1.1) for x in (0.0, 0.1, 0.2)])
    faces = [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2), (4, 5, 8), (4, 8, 7), (5, 6, 9), (5, 9, 8)]
    seams = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3), (5, 8)]
    result = wirewarp.flatten(np.concatenate([corners, strip]), np.array(faces), seams=seams)
    steps = Pattern.from_result(result).steps
    assert sum(step.has_gap for step in steps) == 1 and [step.kind for step in steps].count("closing") == 1


def test_steps_are_numbered_and_rigid_wires_measured(tmp_path):
    top = sample("Fitted top", pairs=True, on_fold=True, units="imperial")
    words = proof_words(top, tmp_path / "a.pdf")
    assert "Sewing order" in words and f"{len(top.steps)} {top.steps[-1].seam}" in words
    rigid = [wire for wire in SAMPLES["Fitted top"].wires if wire.tolerance == 0]
    vertices = np.asarray(SAMPLES["Fitted top"].vertices)
    assert len(rigid) == len(top.measures) > 5
    for wire in rigid:
        length = np.linalg.norm(np.diff(vertices[list(wire.vertices)], axis=0), axis=1).sum()
        assert f"{wire.name}" in words and f"{length / 0.0254:.2f} in" in words
