# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces that are cut as mirrored pairs or on the fold: what is cut is still every piece, in its true shape."""

from dataclasses import replace

import numpy as np
import pytest
import shapely
import wirewarp
from patterns import cut_polygon, line_string, quads, rectangle, sample
from wirewarp.pattern import Pattern
from wirewarp.pattern.geometry import Motion, right_normals
from wirewarp.pattern.make.outline import flat_piece

HALF = np.array([(0, 0), (120, 0), (150, 80), (0, 110)])  # of a symmetric piece, right of its fold


def symmetric(angle, **options):
    """A piece of two halves with a wire across and one on the fold; turned by degrees from an upright fold."""
    points = np.array([*HALF, *(HALF[1:3] * (-1, 1)), (0, 40), (60, 40), (-60, 40)])
    faces = [
        (0, 1, 7),
        (0, 7, 6),
        (1, 2, 7),
        (7, 2, 3),
        (7, 3, 6),
        (4, 0, 6),
        (4, 6, 8),
        (5, 4, 8),
        (3, 5, 8),
        (3, 8, 6),
    ]
    vertices = np.column_stack([points / 1000, np.zeros(len(points))])
    wires = [wirewarp.Wire([8, 6, 7], name="Across"), wirewarp.Wire([0, 6, 3], name="Middle")]
    result = wirewarp.flatten(vertices, np.array(faces), wires=wires)
    cosine, sine = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    turn = np.array([[cosine, sine], [-sine, cosine]])
    piece = flat_piece(result.pieces[0], "Front", 1000.0)
    turned = replace(piece, vertices=points[piece.source_vertex] @ turn, grain=np.array([0.0, 1.0]) @ turn)
    return Pattern.from_pieces([turned], [], **options)


@pytest.mark.parametrize(
    ("quantities", "expected", "words"),
    [
        ({}, (1, 1), "Cut 1 pair (2 pieces, one mirrored)"),
        ({3: (2, 0), 4: (2, 0)}, (2, 2), "Cut 2 pairs"),
        ({3: (3, 1), 4: (0, 2)}, (5, 1), "Cut 5 and 1 mirrored"),
    ],
)
def test_a_pair_is_cut_as_often_as_its_two_pieces(quantities, expected, words):
    """The right sleeve as drawn is the left one mirrored."""
    top = sample("Fitted top")
    assert top.twins() == [(3, 4)]
    paired = top.with_quantities(quantities).cut_as_pairs([(3, 4)])
    assert [piece.quantity for piece in paired.pieces] == [(1, 0), (1, 0), expected]
    assert words in paired.pieces[2].texts[0].lines


def test_pieces_cut_mirrored_alone_say_so():
    (piece,) = Pattern.from_result(rectangle(300, 200)).with_quantities({1: (0, 2)}).pieces
    assert "Cut 2 mirrored" in piece.texts[0].lines


@pytest.mark.parametrize(
    ("pairs", "says"),
    [
        ([(1, 1)], "Pieces 1 and 1 are not a pair"),  # symmetric, so its own mirror image
        ([(3, 4), (3, 4)], "Pieces 3 and 4 are not a pair"),
        ([(3, 9)], "Pieces 3 and 9 are not a pair"),
        ([(1, 2)], "Pieces 1 and 2 are not mirror images"),
    ],
)
def test_what_is_not_a_pair_is_one_sentence(pairs, says):
    with pytest.raises(wirewarp.FlattenError, match=says):
        sample("Fitted top").cut_as_pairs(pairs)


def test_holes_must_fit_too():
    mask = sample("Carnival mask", allowance=2.0)
    assert len(mask.pieces[0].of_role("inner_cut")) == 2 and mask.symmetric() == [1]
    points = [(0, 0), (100, 0), (100, 60), (0, 60), (20, 20), (40, 20), (40, 35), (20, 35)]
    around = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
    assert Pattern.from_result(quads(points, around)).symmetric() == []


def right_of(line):
    way = (line[1] - line[0]) / np.linalg.norm(line[1] - line[0])
    return np.array([way[1], -way[0]])


@pytest.mark.parametrize("angle", [0.0, 35.0, 90.0, 200.0])
def test_a_piece_on_the_fold_is_one_half_to_the_fold(angle):
    whole = symmetric(angle, allowance=8.0)
    (piece,) = whole.cut_on_fold(whole.symmetric()).pieces
    (fold,) = piece.of_role("fold")
    across, up = fold.points[1] - fold.points[0]
    assert up > 1e-6 or (up > -1e-6 and across > 0)  # the right half is drawn, or the lower one
    area = cut_polygon(whole.pieces[0]).area
    (cut,) = piece.of_role("cut")
    assert shapely.Polygon(cut.points).area == pytest.approx(area / 2, rel=1e-6)
    # The fold goes from cut line to cut line: 110 mm of the piece and an allowance at both ends, wider where it slants.
    slant = 8.0 / np.cos(np.arctan2(30, 150))
    assert np.linalg.norm(fold.points[1] - fold.points[0]) == pytest.approx(110 + 8 + slant, abs=1e-3)
    wires = {line.name: line for line in piece.of_role("wire")}
    assert line_string(wires["Across"]).length == pytest.approx(60) and line_string(wires["Middle"]).length == 110
    for line in (wires["Across"], wires["Middle"], *piece.of_role("sew")):
        beyond = (line.points - fold.points[0]) @ right_of(fold.points)
        assert beyond.min() == pytest.approx(0, abs=1e-6)
    (grain,) = piece.of_role("grain")
    assert ((grain.points - fold.points[0]) @ right_of(fold.points)).tolist() == pytest.approx([15, 15])
    assert piece.on_fold and "Cut 1 on the fold" in piece.texts[0].lines


@pytest.mark.parametrize("angle", [0.0, 35.0, 90.0, 200.0])
def test_a_folded_piece_opens_to_the_whole(angle):
    whole = symmetric(angle, allowance=8.0)
    folded = whole.cut_on_fold([1])
    marker = folded.nested(1400, seconds=0)
    (opened,) = folded.laid_on(marker).pieces
    turned = whole.pieces[0].placed(Motion(np.zeros(2), marker.placements[0].angle))
    outlines = [cut_polygon(piece.moved(-piece.bounds[0])).exterior for piece in (turned, opened)]
    assert outlines[0].hausdorff_distance(outlines[1]) < 0.01
    for role in ("sew", "wire"):
        lengths = [sum(line_string(line).length for line in piece.of_role(role)) for piece in (turned, opened)]
        assert lengths[0] == pytest.approx(lengths[1], abs=1e-6)
    marks = [sorted(point.depth for point in piece.points) for piece in (turned, opened)]
    assert marks[0] == pytest.approx(marks[1])
    assert not opened.on_fold and not opened.of_role("fold")


def opened(result, folds):
    """The half with these marked folds, and the piece that it opens to."""
    half = Pattern.from_result(result, folds=folds, allowance=10.0)
    (piece,) = half.laid_on(half.nested(1400, seconds=0)).pieces
    return half, piece


@pytest.mark.parametrize(
    ("fold", "area"), [((0, 3), 220 * 80), ((1, 2), 220 * 80), ((0, 1), 120 * 140), ((2, 3), 120 * 140)]
)
def test_a_half_opens_at_whichever_of_its_edges_is_the_fold(fold, area):
    half, piece = opened(rectangle(100, 60), [fold])
    cut = cut_polygon(piece)
    assert cut.is_valid and cut.area == pytest.approx(area, rel=1e-6)
    assert piece.size.prod() == pytest.approx(area, rel=1e-6)  # a rectangle
    sewn = piece.of_role("sew")
    assert len(sewn) == 2 * len(half.pieces[0].of_role("sew"))
    inside = shapely.MultiPoint(np.concatenate([line.points for line in sewn])).convex_hull
    for line in sewn:  # the piece is on its left, where names stand
        outside = (line.points[:-1] + line.points[1:]) / 2 + 5 * right_normals(line.points)
        assert all(cut.contains(shapely.Point(point)) for point in outside)
        assert not any(inside.contains(shapely.Point(point)) for point in outside)


def test_a_fold_that_is_a_little_crooked_opens_without_a_slit():
    """Its middle is 0.4 mm off: less than half a millimeter counts as straight."""
    points = [(0, 0), (100, 0), (100, 60), (0, 60), (-0.4, 30)]
    vertices = np.column_stack([np.array(points) / 1000, np.zeros(5)])
    half, piece = opened(wirewarp.flatten(vertices, np.array([(0, 1, 4), (1, 2, 4), (2, 3, 4)])), [(3, 4), (4, 0)])
    assert not half.warnings
    (cut,) = piece.of_role("cut")
    outline = shapely.Polygon(cut.points)
    assert outline.is_valid and outline.area == pytest.approx(220 * 80, rel=2e-3)
    assert outline.exterior.length == pytest.approx(2 * (220 + 80), rel=2e-3)
