# SPDX-License-Identifier: GPL-3.0-or-later
"""The proof lists the lengths, allowances and notches of every seam, and how far copies differ."""

import math

import numpy as np
import pytest
from patterns import flattened, grid, proof_words, sample
from wirewarp.pattern import Pattern


@pytest.mark.parametrize("paper", ["letter", 700.0])
def test_the_proof_names_every_piece_and_both_sides_of_every_seam(tmp_path, paper):
    pattern = sample("Hat", date="2026-11-22")
    text = proof_words(pattern, tmp_path / "hat.pdf", paper)
    assert "Hat, 2026-11-22" in text
    assert all(piece.name in text for piece in pattern.pieces)
    for walk in pattern.walks:
        assert len(walk.lengths) == 2 and max(walk.lengths) - min(walk.lengths) < 0.001
        assert text.count(f"{walk.lengths[0]:.1f} mm") >= 2
    result = flattened("Hat")
    assert [walk.lengths[0] for walk in pattern.walks] == pytest.approx([1000 * s.length_2d[0] for s in result.seams])


def test_the_proof_states_how_far_copies_are_off(tmp_path):
    pattern = sample("Cushion", pairs=True, on_fold=True)
    text = proof_words(pattern, tmp_path / "a.pdf")
    borders = [piece for piece in pattern.pieces if piece.copied_names and piece.on_fold]
    assert [piece.quantity for piece in borders] == [(4, 0)] and all(0.001 < piece.deviation < 0.1 for piece in borders)
    for piece in borders:
        assert f"A copy differs by up to {piece.deviation:.3f} mm" in text


def test_a_long_proof_has_several_pages_and_long_names_are_cut_off(tmp_path):
    result = grid(range(0, 340, 20), [0, 100], seams=[(x, x + 17) for x in range(1, 16)])
    pattern = Pattern.from_result(result, piece_names=["A very long name of a piece " * 4] * 16)
    pages = pattern.page_sizes("a4", proof=True)[len(pattern.page_sizes("a4")) :]
    assert len(pages) == math.ceil((3 + 16 + 3 + 1 + 1 + 3 * 15 + 2 + 15) / 55)  # all lines, on pages of 55 lines
    assert "..." in proof_words(pattern, tmp_path / "strips.pdf", "a4")


def two_squares(**options):
    """Return the pattern of two squares of 200 mm that are sewn together along the edge 1-4."""
    return Pattern.from_result(grid([0, 200, 400], [0, 200], seams=[(1, 4)]), **options)


def test_allowances_are_listed_if_no_stitching_lines_are_drawn(tmp_path):
    assert "10 mm" in proof_words(two_squares().with_only(["notches"]), tmp_path / "a.pdf")


def test_the_proof_lists_the_places_of_notches(tmp_path):
    pattern = two_squares(notch_spacing=50.0)
    (walk,) = pattern.walks
    assert walk.notches == (pytest.approx((40, 90, 140)), pytest.approx((40, 90, 140)))  # no notch in the middle
    for piece, places in zip(pattern.pieces, walk.notches, strict=True):
        (side,) = [line.points for line in piece.of_role("sew") if line.seam == 0]
        own = [point for point in piece.points if point.pair]
        assert [point.along for point in own] == list(places)
        # A notch on the cutting line is 10 mm beside its place on the seam. All places are measured from one end.
        distances = [[np.hypot(*(point.at - end)) for point in own] for end in (side[0], side[-1])]
        assert pytest.approx([np.hypot(place, 10) for place in places]) in distances
    text = proof_words(pattern, tmp_path / "a.pdf")
    assert "Notches at " + ", ".join(f"{place:.1f} mm" for place in walk.notches[0]) in text


def test_the_proof_of_a_marker_states_the_fabric_that_it_needs(tmp_path):
    pattern = sample("Fitted top")
    laid = pattern.laid_on(pattern.nested(1400, seconds=0))
    text = proof_words(laid, tmp_path / "a.pdf")
    assert laid.marker.sentence(laid.units) in text and "In rows" not in text
    assert "Notches at 55.2 mm, 80.0 mm" in text  # of a sleeve's seam, which joins the sleeve with itself


def test_sides_of_pieces_with_one_name_have_their_own_allowances(tmp_path):
    pattern = two_squares(piece_names=["Cuff", "Cuff"], side_allowances=[(1, 4, 5.0)])
    text = proof_words(pattern, tmp_path / "a.pdf")
    assert text.count("200.0 mm 10 mm") == text.count("200.0 mm 5 mm") == 1


def test_imperial_proofs_have_no_millimeters(tmp_path):
    text = proof_words(two_squares(units="imperial"), tmp_path / "a.pdf")
    assert "7.87 in 3/8 in 0.0000 in" in text and " mm" not in text
