# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on describes the library's errors in the words of Blender's users."""

import math

import pytest

HIP, BUST = 0, 1
OUTLINE, STRETCH = {"reason": "outline"}, {"reason": "stretch"}


@pytest.fixture
def said(addon):
    """Return a function that makes the sentence of an error. faces, flipped, overlapping: numbers of faces."""

    def sentence(code, arguments, faces=0, flipped=0, overlapping=0, **elements):
        error = addon.core.library().FlattenError(code, "The library's sentence.", **elements, arguments=arguments)
        units = addon.core.LengthText("mm", 1000.0)
        facts = addon.solve.error_sentences.ErrorFacts(error, faces, flipped, overlapping, ["Hip", "Bust"], units)
        return addon.solve.error_sentences.error_sentence(facts)

    return sentence


def test_every_code_with_a_sentence_is_one_of_the_library(addon):
    codes = {str(code) for code in addon.core.library().ErrorCode}
    assert set(addon.solve.error_sentences.SENTENCES) <= codes


def test_an_error_of_scripts_keeps_the_sentence_of_the_library(said):
    assert said("invalid_type", {"name": "faces"}) == "The library's sentence."


@pytest.mark.parametrize(
    ("code", "arguments", "others", "expected"),
    [
        ("zero_area_face", {}, {"faces": 1}, "1 face has no area. In Edit Mode, use"),
        ("zero_area_face", {}, {"faces": 3}, "3 faces have no area."),
        ("non_finite_coordinates", {"limit": 1e60}, {"vertices": [1, 2]}, "The coordinates of 2 vertices are not"),
        ("inconsistent_orientation", {"is_one_sided": True}, {"edges": [(0, 1)]}, "one-sided like a Möbius strip."),
        ("inconsistent_orientation", {"is_one_sided": False}, {"edges": [(0, 1)]}, "Recalculate Outside."),
        ("handles", {"num_handles": 1}, {"proposed_seams": [(0, 1)]}, "has 1 handle like a torus"),
        # The sentence does not mention the suggested seam, because this seam is not always drawn.
        ("closed_chart", {}, {"proposed_seams": [(0, 1)]}, "choose where to cut it."),
        ("not_solvable", {"reason": "sizes", "face": 7}, {"faces": 2}, "At 2 faces, merge vertices"),
        ("overlapping_faces", {}, {"faces": 2}, "overlaps itself at 2 faces. Cut it in two"),
        ("infeasible_lengths", OUTLINE | {"has_wires": True}, {}, "even with its wires free. Mark a seam."),
        ("infeasible_lengths", OUTLINE | {"has_wires": False}, {}, "the length of its outline. Mark a seam."),
        ("infeasible_lengths", STRETCH | {"is_good_unstretched": True}, {}, "requires. Use less stretch, or mark"),
        ("infeasible_lengths", STRETCH | {"is_good_unstretched": False}, {}, "requires. Mark a seam."),
        ("infeasible_lengths", {"reason": "method"}, {}, "Use the method Refined"),
    ],
)
def test_elements_are_counted_and_the_remedy_depends_on_the_reason(said, code, arguments, others, expected):
    assert expected in said(code, arguments, **others)


@pytest.mark.parametrize(
    ("lengths", "expected"),
    [
        ([0.5], "cannot be flattened: mark another seam. The outline is too short to surround the flat piece: 500 mm."),
        ([0.3134, 1.2e-05], "is a tube: mark a seam from one opening to the other. The outlines are too short to "),
        ([0.3134, 1.2e-05], "surround the flat piece: 313 mm and 0.012 mm."),
        ([0.1] * 7, "7 openings. The outlines are too short to surround the flat piece: 100 mm, 100 mm, 100 mm, 100"),
        ([0.1] * 7, "100 mm and 2 more."),
    ],
)
def test_outlines_have_the_units_of_the_scene(said, lengths, expected):
    arguments = {"lengths": lengths, "share": 0.06, "least_energy": 0.8}
    assert expected in said("boundary_too_short", arguments, vertices=range(len(lengths)))


@pytest.mark.parametrize(
    ("proposed", "expected"),
    [
        ([(HIP, 0.012)], 'with a tolerance of 1.2% on wire "Hip".'),
        ([(HIP, 0.01), (BUST, 0.03)], 'with a tolerance of 1% to 3% on wires "Hip" and "Bust".'),
        ([(HIP, 0.01), (BUST, math.inf)], 'with a tolerance of 1% on wire "Hip" and with wire "Bust" free.'),
        ([(HIP, math.inf), (BUST, math.inf)], 'with wires "Hip" and "Bust" free.'),
    ],
)
def test_wires_have_their_names(said, proposed, expected):
    arguments = {"reason": "wires", "is_refined": True}
    assert said("infeasible_lengths", arguments, proposed_tolerances=proposed).endswith(expected)


def test_broken_guarantees_are_reported_together(said):
    wrong = {"wires": [HIP], "difference": -0.003, "num_flipped": 1, "num_overlapping": 4, "has_wires": True}
    assert said("lengths_not_kept", wrong, flipped=1, overlapping=2, edges=[(0, 1), (1, 2)]) == (
        'The piece does not keep the length of 2 edges (the worst, on wire "Hip", is 0.3% too short), has 1 flipped '
        "face and overlaps itself at 2 faces. Add a seam where the piece curves most, or widen the tolerance of its "
        "wires."
    )
    assert "(the worst, on the outline, is 2% too long). Add" in said(
        "lengths_not_kept", wrong | {"wires": [], "difference": 0.02}, edges=[(0, 1)]
    )
    beyond = {"wires": [BUST], "tolerance": 0.05, "num_flipped": 0, "num_overlapping": 0, "has_wires": True}
    assert 'keep the length of wire "Bust" within its tolerance of 5%. Add' in said("lengths_not_kept", beyond)


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        ({"reason": "strain", "strain": 0.021, "limit": 1.0}, "its stretch is 2.1%, and 100% is accepted."),
        ({"reason": "too_long", "length": 1.5, "limit": 1.0}, "with seams of 1.5 m, but no more than 1 m are"),
        ({"reason": "no_room", "kind": "dart", "is_restricted": False}, "no room for a dart. Every line along edges"),
        (
            {"reason": "no_gain", "kind": "dart", "strain": 0.149, "wires": [BUST]},
            'No dart helps the piece, which must stretch by 14.9%: loosen wire "Bust" or divide the piece by a seam.',
        ),
        (
            {"reason": "no_gain", "kind": "dart", "strain": 0.149, "wires": [0, 1] * 5},
            '14.9%: loosen wires "Hip", "Bust", "Hip", "Bust", "Hip" and 5 more or divide',
        ),
        ({"reason": "no_gain", "kind": "seam", "strain": 0.149, "wires": []}, "14.9%: move a seam to"),
        ({"reason": "too_strained"}, "by over 100%"),
        ({"reason": "no_set", "is_restricted": True}, "Mark a first seam."),
        ({"reason": "unfolded"}, "is unfolded without distortion."),
    ],
)
def test_the_reason_for_no_suggestion_is_reported(said, arguments, expected):
    assert expected in said("no_proposal", arguments)
