# SPDX-License-Identifier: GPL-3.0-or-later
"""Equal pieces, mirrored pairs and halves on the fold are drawn once, and all pieces are cut in their actual shapes."""

from collections import defaultdict
from dataclasses import replace

import numpy as np
import pytest
import shapely
import wirewarp
from patterns import cut_polygon, grid, line_string, quads, rectangle, sample, turn
from samples import flattened
from wirewarp.pattern import Pattern
from wirewarp.pattern.geometry import Motion, right_normals
from wirewarp.pattern.make.outline import flat_piece

HALF = np.array([(0, 0), (120, 0), (150, 80), (0, 110)])  # half of a symmetric piece, to the right of its fold


def symmetric(angle, **options):
    """Return the pattern of a symmetric piece with a wire across and a wire on the fold.

    angle: rotation of the fold from upright, in degrees.
    """
    points = np.array([*HALF, *(HALF[1:3] * (-1, 1)), (0, 40), (60, 40), (-60, 40)])
    right = [(0, 1, 7), (0, 7, 6), (1, 2, 7), (7, 2, 3), (7, 3, 6)]
    faces = [*right, (4, 0, 6), (4, 6, 8), (5, 4, 8), (3, 5, 8), (3, 8, 6)]
    vertices = np.column_stack([points / 1000, np.zeros(len(points))])
    wires = [wirewarp.Wire([8, 6, 7], name="Across"), wirewarp.Wire([0, 6, 3], name="Middle")]
    result = wirewarp.flatten(vertices, np.array(faces), wires=wires)
    piece = flat_piece(result.pieces[0], "Front", 1000.0)
    grain = np.array([0.0, 1.0]) @ turn(angle)
    turned = replace(piece, vertices=points[piece.source_vertex] @ turn(angle), grain=grain)
    return Pattern.from_pieces([turned], [], **options)


def test_a_pair_is_cut_as_drawn_and_mirrored():
    """Only one sleeve is drawn, because the other sleeve is its mirror image."""
    paired = sample("Fitted top", pairs=True)
    assert [piece.quantity for piece in paired.pieces] == [(1, 0), (1, 0), (1, 1)]
    assert "Cut 1 pair (2 pieces, one mirrored)" in paired.pieces[2].texts[0].lines
    assert paired.pieces[2].copied_names == ("Piece 4",)
    cards = [piece.texts[0].lines for piece in paired.with_quantities({1: (5, 1), 2: (0, 2), 3: (2, 2)}).pieces]
    quantities = ("Cut 5 and 1 mirrored", "Cut 2 mirrored", "Cut 2 pairs")
    assert all(quantity in card for quantity, card in zip(quantities, cards, strict=True))


def test_pieces_of_one_shape_are_cut_several_times():
    """The pieces are a shape without symmetry, a copy, a copy that is rotated by half a turn, and a mirror image."""
    corners = np.array([(0, 0), (90, 0), (80, 40), (0, 60)])
    places = [corners, corners + (200, 0), (490, 60) - corners, (corners * (-1, 1) + (700, 0))[::-1]]
    faces = [tuple(range(4 * place, 4 * place + 4)) for place in range(4)]
    (piece,) = Pattern.from_result(quads(np.concatenate(places), faces), pairs=True).pieces
    assert piece.quantity == (3, 1) and piece.copied_names == ("Piece 2", "Piece 3", "Piece 4")
    lines = piece.texts[0].lines
    assert "Cut 3 and 1 mirrored" in lines and "Piece 1 and 3 more" in lines


def test_the_gores_of_a_ball_are_one_piece():
    (gore,) = sample("Ball of six gores", pairs=True).pieces
    assert gore.quantity == (6, 0) and "Cut 6" in gore.texts[0].lines


def test_holes_must_match_too():
    (mask,) = sample("Carnival mask", allowance=2.0, on_fold=True).pieces
    assert len(mask.of_role("inner_cut")) == 1 and mask.on_fold
    points = [(0, 0), (100, 0), (100, 60), (0, 60), (20, 20), (40, 20), (40, 35), (20, 35)]
    around = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
    assert not Pattern.from_result(quads(points, around), on_fold=True).pieces[0].on_fold


def test_a_wire_on_one_half_alone_is_not_lost():
    for wire, on_fold in (([1, 5], False), ([1, 4], True)):  # one wire leads to a corner, the other along the middle
        result = grid([-60, 0, 60], [0, 40], wires=[wirewarp.Wire(wire)])
        assert Pattern.from_result(result, on_fold=True).pieces[0].on_fold == on_fold


@pytest.mark.parametrize("name", ["Fitted top", "Ball of six gores", "Jeans", "Wetsuit upper body", "Swimsuit"])
def test_mirrored_copies_have_their_notches_where_they_are_sewn(name):
    """The test compares pieces on the fabric with a pattern in which every piece is drawn as a whole."""
    drawn, whole = sample(name, pairs=True, on_fold=True), sample(name)
    marker = drawn.nested(5000, seconds=0)
    opened = defaultdict(dict)  # for each drawn piece, a copy on the fabric as drawn (False) and mirrored (True)
    for laid, placement in zip(drawn.laid_on(marker).pieces, marker.placements, strict=True):
        opened[placement.piece - 1][placement.mirrored] = laid
    originals = {piece.name: piece for piece in whole.pieces}
    wanted = [
        (opened[index], originals.pop(name))
        for index, each in enumerate(drawn.pieces)
        for name in (each.name, *each.copied_names)
    ]
    assert not originals  # every piece is a drawn piece or a copy of one
    checked = 0
    for either, original in wanted:
        # Copies may be rotated by half a turn.
        turned = [piece.placed(Motion(np.zeros(2), angle)) for piece in either.values() for angle in (0.0, 180.0)]
        moved = [each.moved(original.bounds[0] - each.bounds[0]) for each in turned]
        shape = cut_polygon(original)
        apart, piece = min(
            ((cut_polygon(each).buffer(0).symmetric_difference(shape).area, each) for each in moved),
            key=lambda each: each[0],
        )
        assert apart < 1e-3 * shape.area
        found = {}
        for point in (each for each in piece.points if each.pair):
            ray = shapely.LineString([point.at - point.direction, point.at + 20 * point.direction])
            hits = [(ray.intersection(line_string(line)), line) for line in original.of_role("sew")]
            met = [(shapely.Point(point.at).distance(hit), hit, line) for hit, line in hits if not hit.is_empty]
            _, hit, line = min(met, key=lambda each: each[0])
            along = line_string(line).project(hit.centroid)
            if line.seam is not None:
                found.setdefault((line.seam, id(line)), []).append(along)
        for (seam, _), places in found.items():
            length = max(whole.walks[seam].lengths)
            expected = sorted(drawn.walks[seam].notches[0])
            mirrored = sorted(length - place for place in expected)
            assert sorted(places) in (pytest.approx(expected, abs=0.3), pytest.approx(mirrored, abs=0.3))
            checked += len(places)
    assert checked > 10


def test_a_copy_keeps_the_grain():
    """Rectangles are copies, or are cut on the fold, only if their grain keeps its direction."""
    points = [(0, 0), (90, 0), (90, 120), (0, 120), (200, 0), (290, 0), (290, 120), (200, 120)]
    result = quads(points, [(0, 1, 2, 3), (4, 5, 6, 7)])
    pieces = [flat_piece(piece, "Front", 1000.0) for piece in result.pieces]

    def drawn(first, second, **options):
        grains = [np.array(grain) / np.linalg.norm(grain) for grain in (first, second)]
        turned = [replace(piece, grain=grain) for piece, grain in zip(pieces, grains, strict=True)]
        return Pattern.from_pieces(turned, [], **options).pieces

    up, down, across, bias, other_bias = (0.0, 1.0), (0.0, -1.0), (1.0, 0.0), (1.0, 1.0), (1.0, -1.0)
    assert len(drawn(up, up, pairs=True)) == len(drawn(up, down, pairs=True)) == 1
    (copies,), (pair,) = drawn(bias, bias, pairs=True), drawn(bias, other_bias, pairs=True)
    assert (copies.quantity, pair.quantity) == ((2, 0), (1, 1))
    assert len(drawn(up, across, pairs=True)) == len(drawn(up, bias, pairs=True)) == 2
    folded, whole = drawn(across, bias, on_fold=True)
    assert (folded.on_fold, whole.on_fold) == (True, False)
    (grain,) = folded.of_role("grain")
    assert np.ptp(grain.points[:, 1]) == pytest.approx(0) and cut_polygon(folded).contains(line_string(grain))


@pytest.mark.parametrize("name", ["Fitted top", "Ball of six gores", "Cushion", "Jeans", "Toy"])
def test_every_seam_is_named_on_paper(name):
    """A piece that is drawn once for several copies has the numbers of all copies' seams."""
    drawn = sample(name, pairs=True, on_fold=True)
    for piece in drawn.pieces:
        numbers = set(" ".join(line.name for line in piece.of_role("sew")).replace("/", " ").split()) - {"Seam"}
        own = {piece.name, *piece.copied_names}
        assert numbers == {walk.name.split()[1] for walk in drawn.walks if own & set(walk.pieces)}


def test_a_line_for_two_seams_joins_the_partners_of_both():
    names = ("Front", "Back", "Left sleeve", "Right sleeve")
    drawn = sample("Fitted top", pairs=True, on_fold=True, piece_names=names)
    joins = {line.name: line.joins for line in drawn.pieces[0].of_role("sew") if line.name}
    assert "Left sleeve – Right sleeve" in joins.values() or "Right sleeve – Left sleeve" in joins.values()


@pytest.mark.parametrize("angle", [0.0, 35.0, 90.0, 200.0])
def test_a_piece_on_the_fold_is_one_half_to_the_fold(angle):
    whole = symmetric(angle, allowance=8.0)
    (piece,) = symmetric(angle, allowance=8.0, on_fold=True).pieces
    (fold,) = piece.of_role("fold")
    across, up = fold.points[1] - fold.points[0]
    assert up > 1e-6 or (up > -1e-6 and across > 0)  # the right or the lower half is drawn
    area = cut_polygon(whole.pieces[0]).area
    (cut,) = piece.of_role("cut")
    assert shapely.Polygon(cut.points).area == pytest.approx(area / 2, rel=1e-6)
    # The fold has 110 mm of the piece, and an allowance at both ends. The allowance at the slanted end is wider.
    slant = 8.0 / np.cos(np.arctan2(30, 150))
    assert np.linalg.norm(fold.points[1] - fold.points[0]) == pytest.approx(110 + 8 + slant, abs=1e-3)
    wires = {line.name: line for line in piece.of_role("wire")}
    assert line_string(wires["Across"]).length == pytest.approx(60) and line_string(wires["Middle"]).length == 110
    right = np.array([up, -across]) / np.hypot(across, up)
    for line in (wires["Across"], wires["Middle"], *piece.of_role("sew")):
        assert ((line.points - fold.points[0]) @ right).min() == pytest.approx(0, abs=1e-6)
    (grain,) = piece.of_role("grain")
    assert piece.deviation < 1e-6
    assert ((grain.points - fold.points[0]) @ right).tolist() == pytest.approx([15, 15])
    assert piece.on_fold and "Cut 1 on the fold" in piece.texts[0].lines


@pytest.mark.parametrize("angle", [0.0, 35.0, 90.0, 200.0])
def test_a_folded_piece_opens_to_the_whole(angle):
    whole, folded = symmetric(angle, allowance=8.0), symmetric(angle, allowance=8.0, on_fold=True)
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
    """Return the pattern of a half with these folds, and the whole piece on the fabric."""
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
    assert piece.size.prod() == pytest.approx(area, rel=1e-6)
    sewn = piece.of_role("sew")
    assert len(sewn) == 2 * len(half.pieces[0].of_role("sew"))
    inside = shapely.MultiPoint(np.concatenate([line.points for line in sewn])).convex_hull
    for line in sewn:  # the piece is on the left of each line
        outside = (line.points[:-1] + line.points[1:]) / 2 + 5 * right_normals(line.points)
        assert all(cut.contains(shapely.Point(point)) for point in outside)
        assert not any(inside.contains(shapely.Point(point)) for point in outside)


def test_a_fold_that_is_a_little_crooked_opens_without_a_slit():
    """The middle of the fold is 0.4 mm off a straight line. Less than 0.5 mm counts as straight."""
    points = [(0, 0), (100, 0), (100, 30), (-0.4, 30), (0, 60), (100, 60)]
    half, piece = opened(quads(points, [(0, 1, 2, 3), (3, 2, 5, 4)]), [(4, 3), (3, 0)])
    assert not half.warnings
    (cut,) = piece.of_role("cut")
    outline = shapely.Polygon(cut.points)
    assert outline.is_valid and outline.area == pytest.approx(220 * 80, rel=2e-3)
    assert outline.exterior.length == pytest.approx(2 * (220 + 80), rel=2e-3)


AROUND = 2 * np.pi * np.arange(16) / 16
ROUND = 50 * np.column_stack([np.cos(AROUND), np.sin(AROUND)])  # millimeters
EGG = ROUND * (1 + 0.2 * np.sin(AROUND + 0.3) + 0.1 * np.cos(2 * AROUND))[:, None]  # no symmetry
ALONG_TUBE = 60  # millimeters
UP = wirewarp.Options(orientation="up")


def capped_tubes(ring, *seam_rows):
    """Flatten tubes side by side, each with a cap below. Every second tube is a mirror image.

    ring: (n, 2) points around a tube
    seam_rows: for each tube, index of the point of the ring at which a seam opens the tube
    """
    count, vertices, faces, seams = len(ring), [], [], []
    for number, row in enumerate(seam_rows):
        below = np.column_stack([ring, np.zeros(count)])
        tube = np.concatenate([below, below + (0, 0, ALONG_TUBE), [(0, 0, 0)]])
        first, mirror = number * (2 * count + 1), number % 2
        vertices.append(tube * (-1 if mirror else 1, 1, 1) + (300 * number, 0, 0))
        for a, b in zip(range(count), np.roll(range(count), -1), strict=True):
            around = np.array([(a, b, count + b), (a, count + b, count + a), (2 * count, b, a)]) + first
            faces.append(around[:, ::-1] if mirror else around)
            seams.append((first + a, first + b))
        seams.append((first + row, first + count + row))
    return wirewarp.flatten(np.concatenate(vertices) / 1000, np.concatenate(faces), seams=seams, options=UP)


def test_caps_of_mirrored_tubes_are_a_pair():
    """The egg's edges differ in length, so its notches are between vertices. The walks have the places of notches."""
    result = capped_tubes(EGG, 5, 5)
    drawn, whole = Pattern.from_result(result, pairs=True), Pattern.from_result(result)
    assert [piece.quantity for piece in drawn.pieces] == [(1, 1), (1, 1)]
    rings = [walk for walk in drawn.walks if len(set(walk.pieces)) == 2]
    assert len(rings) == 2 and len(rings[0].notches[0]) == 2
    first, second = (np.sort(walk.notches) for walk in rings)
    turned = rings[1].lengths[0] - second[:, ::-1]  # places on the mirror image, measured from the other end
    assert first == pytest.approx(turned) and first[0] == pytest.approx(first[1])
    assert [piece.quantity for piece in whole.pieces] == [(1, 0)] * 4


def test_a_cushion_of_two_faces_is_a_pair():
    """Two cushions have four faces of one shape. The seam of a cushion must have equal notches on both its faces."""
    count, vertices, faces, seams = len(EGG), [], [], []
    for number in range(2):
        first, around = number * (count + 2), range(count)
        middle = [(0, 0, 20), (0, 0, -20)]
        rim = np.roll(np.column_stack([EGG, np.zeros(count)]), 7 * number, axis=0)  # numbered from another vertex
        vertices.append(np.vstack([rim, middle]) + (300 * number, 0, 0))
        for a, b in zip(around, np.roll(around, -1), strict=True):
            faces += [(first + a, first + b, first + count), (first + b, first + a, first + count + 1)]
            seams.append((first + a, first + b))
    result = wirewarp.flatten(np.concatenate(vertices) / 1000, np.array(faces), seams=seams, options=UP)
    (drawn,) = Pattern.from_result(result, pairs=True).pieces
    assert sum(drawn.quantity) == 4 and min(drawn.quantity) == 2


def test_the_bear_has_one_sole_and_one_paw_on_paper():
    result = flattened("Toy", orientation="up")
    quantities = {piece.name: piece.quantity for piece in Pattern.from_result(result, pairs=True).pieces}
    assert quantities == {
        **dict.fromkeys(["Piece 1", "Piece 2", "Piece 3", "Piece 4"], (1, 0)),
        **dict.fromkeys(["Piece 5", "Piece 7"], (1, 1)),  # a leg and an arm, with their mirror images
        **dict.fromkeys(["Piece 6", "Piece 8"], (2, 0)),  # a sole and a paw, each cut twice
        "Piece 9": (2, 2),  # an ear
    }
