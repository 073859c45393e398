# SPDX-License-Identifier: GPL-3.0-or-later
"""A notch is at the same place of the model on all pieces that meet there, even on round pieces."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
import wirewarp
from patterns import grid, marks
from wirewarp.pattern import Pattern
from wirewarp.pattern.make.notches import check_spacing, drill_hole, places_along, symmetric_places
from wirewarp.pattern.make.outline import Side
from wirewarp.pattern.make.sections import Dart

CORNERS, RADIUS = 24, 100.0  # millimeters


def flat(points, faces, **options):
    """Flatten a flat mesh. points: (n,2) millimeters."""
    return wirewarp.flatten(np.column_stack([np.array(points) / 1000, np.zeros(len(points))]), faces, **options)


def disc_in_ring(*more_seams):
    """Flatten a disc in a ring, with a seam between them.

    Vertex 0 is the center. The vertices of the inner circle and then of the outer circle follow.
    """
    angles = 2 * math.pi * np.arange(CORNERS) / CORNERS
    circle = RADIUS * np.column_stack([np.cos(angles), np.sin(angles)])
    points = np.concatenate([[(0, 0)], circle, 2 * circle])
    around = [(k, (k + 1) % CORNERS) for k in range(CORNERS)]
    inner = [(0, 1 + a, 1 + b) for a, b in around]
    outer = [(1 + a, 1 + CORNERS + a, 1 + CORNERS + b, 1 + b) for a, b in around]
    faces = [*inner, *((a, b, c) for a, b, c, _ in outer), *((a, c, d) for a, _, c, d in outer)]
    seams = [(1 + a, 1 + b) for a, b in around] + list(more_seams)
    return flat(points, faces, seams=seams)


def notches(result, spacing):
    pattern = Pattern.from_result(result, allowance=0, darts="cut", notch_spacing=spacing)
    return [marks(piece, "notch") for piece in pattern.pieces]


def test_a_seam_all_around_begins_at_a_notch_and_has_a_second_notch():
    ring = disc_in_ring()
    found = notches(ring, 1000.0)
    assert [len(own) for own in found] == [2, 2]
    apart = [np.linalg.norm(first.at - second.at) for first, second in found]
    assert apart[0] == pytest.approx(apart[1], abs=0.01)
    assert RADIUS < apart[0] < 1.95 * RADIUS  # if the notches were opposite, the ring could be sewn on half a turn off
    assert [len(own) for own in notches(ring, 0.0)] == [0, 0]


def test_seams_that_meet_on_a_smooth_outline_end_at_notches():
    halves = disc_in_ring((1, 1 + CORNERS), (1 + CORNERS // 2, 1 + CORNERS + CORNERS // 2))
    # The disc has notches at the ends and middles of two seams. Each half of the ring has corners at the ends of three
    # seams, and notches only in their middles.
    assert sorted(len(own) for own in notches(halves, 1000.0)) == [3, 3, 4]


def strap(length, **options):
    """Flatten two strips of 100 mm that are sewn together."""
    return grid([-100, 0, 100], [0, length], seams=[(1, 4)], **options)


@pytest.mark.parametrize(("length", "count", "place"), [(14, 0, 0.0), (16, 1, 5.5), (40, 1, 16.0)])
def test_a_seam_shorter_than_the_spacing_has_a_notch_beside_its_middle_if_it_has_15_mm(length, count, place):
    found = notches(strap(length), 100.0)
    assert [len(own) for own in found] == [count, count]
    # If one side were reversed, its notch would be 5 mm, or a fifth of the seam's length, from the other side's notch.
    assert all(min(point.along, length - point.along) == pytest.approx(place) for own in found for point in own)


@pytest.mark.parametrize(
    ("length", "taken", "spacing", "found"),
    [
        (100, [], 30, [30, 60, 90]),
        (96, [], 30, [30, 60]),  # a notch at 90 would be only a fifth of the spacing from the end
        (120, [], 30, [24, 54, 84]),  # 30, 60 and 90 would be the same on the reversed seam
        (15, [], 100, [5]),
        (65, [30], 100, []),  # the wire's notch suffices, because it would be 5 mm off on the reversed seam
        (64, [30], 100, [23.68]),
        (100, [50], 1000, [37]),
        (100, [42, 58], 1000, []),  # a notch at 37 would be too close to 42
        (100, [], 0, []),
    ],
)
def test_notches_of_a_seam_show_if_it_is_reversed(length, taken, spacing, found):
    assert places_along(length, taken, spacing) == pytest.approx(found)


@pytest.mark.parametrize(
    ("length", "taken", "spacing", "found"),
    [
        (100, [], 30, [20, 50, 80]),
        (100, [50], 30, [20, 80]),
        (72, [], 30, [36]),  # a notch at 6 would be only a fifth of the spacing from the end
        (120, [], 30, [30, 60, 90]),
        (15, [], 30, [7.5]),
        (14, [], 30, []),
        (100, [], 0, []),
    ],
)
def test_notches_of_a_seam_that_a_mirror_reverses_are_the_same_from_both_ends(length, taken, spacing, found):
    assert symmetric_places(length, taken, spacing) == pytest.approx(found)


def test_notches_are_at_least_1_mm_apart_and_at_most_10_000():
    for spacing, length in ((1.0, 10_000.0), (0.0, 10_001.0), (2.0, 20_000.0)):
        check_spacing(spacing, ["Seam 1"], [[SimpleNamespace(along=[0.0, 1.0, length])]])
    for spacing, length in ((0.99, 10.0), (1.0, 10_001.0), (math.inf, 10.0)):
        with pytest.raises(wirewarp.FlattenError, match="mm"):
            check_spacing(spacing, ["Seam 1"], [[SimpleNamespace(along=[0.0, 1.0, length])]])


def test_a_notch_without_its_partner_is_left_out():
    """A wedge is sewn into a narrow gap of a piece. The wider the allowance, the more of the gap it fills."""
    points = [(-100, -50), (100, -50), (100, 100), (4, 100), (0, 0), (-4, 100), (-100, 100)]
    faces = np.array([(0, 1, 4), (1, 2, 4), (2, 3, 4), (4, 5, 6), (0, 4, 6), (4, 3, 5)])
    result = flat(points, faces, seams=[(3, 4), (4, 5)])
    counts = []
    for allowance in (0.0, 2.0, 10.0):
        pattern = Pattern.from_result(result, allowance=allowance, notch_spacing=15.0)
        around, wedge = ({point.pair for point in piece.points if point.pair} for piece in pattern.pieces)
        assert around == wedge
        counts.append(len(wedge))
    assert counts[0] > counts[1] > counts[2] == 0


def test_a_wire_on_a_seam_changes_no_notch():
    plain, wired = strap(200), strap(200, wires=[wirewarp.Wire([1, 4])])
    along = [[[point.along for point in own] for own in notches(result, 30.0)] for result in (plain, wired)]
    assert along[0] == along[1] and len(along[0][0]) >= 5


def test_a_wire_that_ends_at_a_seam_has_a_notch_on_the_other_side_too():
    result = grid([-100, 0, 100], [0, 60, 200], seams=[(1, 4), (4, 7)], wires=[wirewarp.Wire([4, 5])])
    assert sorted(len(own) for own in notches(result, 0.0)) == [1, 2]  # the wire's other end is on the outline
    sewn = [point.along for own in notches(result, 0.0) for point in own if point.pair]
    assert sewn == pytest.approx([60, 60]) or sewn == pytest.approx([140, 140])


def test_if_four_pieces_meet_the_straight_piece_has_a_notch():
    """One piece is below a straight line. Three pieces with corners of 60 degrees are above it."""
    rim = [(100 * math.cos(math.radians(60 * k)), 100 * math.sin(math.radians(60 * k))) for k in range(6)]
    faces = [(0, 1 + k, 1 + (k + 1) % 6) for k in range(6)]
    result = flat([(0, 0), *rim], faces, seams=[(0, 1), (0, 2), (0, 3), (0, 4)])
    pattern = Pattern.from_result(result, allowance=0, notch_spacing=1000.0)
    for piece, solved in zip(pattern.pieces, result.pieces, strict=True):
        of_seams = [point for point in piece.points if point.pair]
        assert len(of_seams) == 2  # in the middles of both seams of the piece
        assert len(piece.points) - len(of_seams) == (1 if len(solved.faces) == 3 else 0)


def hole_of(first, second):
    """Return the hole of a dart. first, second: points (n,2) of its legs, in millimeters; the tip is between them."""
    numbers = np.arange(len(first))
    sides = [Side(0, ids, np.array(leg), 0, False) for ids, leg in ((numbers, first), (numbers[::-1], second))]
    return drill_hole(Dart(*sides))


@pytest.mark.parametrize(("depth", "before"), [(80, 13), (26.5, 13), (20, 10), (4, 2)])
@pytest.mark.parametrize("mouth", [8.0, 0.0])
def test_a_hole_is_drilled_13_mm_before_the_tip_of_a_dart_or_halfway(depth, before, mouth):
    """Dressmakers use 1/2 in. A dart without a mouth has its hole on the line of its legs."""
    tip = (30.0, depth)
    hole = hole_of([(30 - mouth / 2, 0.0), tip], [tip, (30 + mouth / 2, 0.0)])
    assert hole.role == "drill" and hole.at == pytest.approx([30, depth - before])


def test_the_hole_of_a_curved_dart_is_where_its_legs_lead_from_the_tip():
    tip = np.array([2.0, 3.0])
    legs = [[(-20.0, -60.0), (x, -30.0), tip] for x in (6.0, 10.0)]
    back = np.array([8.0, -30.0]) - tip
    assert hole_of(legs[0], legs[1][::-1]).at == pytest.approx(tip + 13 * back / np.linalg.norm(back))


def test_the_hole_of_legs_in_one_line_is_on_the_first_leg():
    """The legs have opposite directions, so there is no direction between them."""
    places = [(30.0, y) for y in (-15.0, -5.0, 5.0, 15.0, 25.0)]
    assert hole_of(places[:3], places[2:]).at == pytest.approx([30, 5 - 20 / 2])
