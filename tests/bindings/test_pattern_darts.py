# SPDX-License-Identifier: GPL-3.0-or-later
"""The darts of a pattern are closed, cut out or slit."""

import math

import numpy as np
import pytest
import shapely
import wirewarp
from patterns import cut_polygon, grid, line_string, marks, sample, sew_polygon
from wirewarp.pattern import Chain, FlatPiece, Pattern


def dart(mouth: float, depth: float) -> wirewarp.FlattenResult:
    """Flatten a cone into a rectangle of 300 x 200 mm with a dart in the middle of its lower edge.

    mouth, depth: millimeters on the flat piece
    """
    half = mouth / 2
    leg = math.hypot(half, depth)
    rise = math.sqrt(leg**2 - depth**2)
    points = np.array(
        [(-150 + half, 0, 0), (0, 0, 0), (150 - half, 0, 0), (-150, depth, 0), (0, depth, rise), (150, depth, 0)]
        + [(-150, 200, 0), (0, 200, rise), (150, 200, 0)]
    )
    faces = [(0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4), (3, 4, 7), (3, 7, 6), (4, 5, 8), (4, 8, 7)]
    return wirewarp.flatten(points / 1000, np.array(faces), seams=[(1, 4)])


def test_a_dart_is_closed_cut_out_or_slit():
    result = dart(40, 100)
    areas = {}
    for how, count in (("close", 1), ("cut", 0), ("slit", 1)):
        (piece,) = Pattern.from_result(result, darts=how, allowance=3).pieces
        areas[how] = cut_polygon(piece).area
        assert len(marks(piece, "drill")) == count
    assert areas["close"] > areas["cut"] > areas["slit"]
    (piece,) = Pattern.from_result(result, allowance=0.0).pieces
    gap = cut_polygon(piece).difference(sew_polygon(piece))
    (hole,) = marks(piece, "drill")
    assert gap.contains(shapely.Point(hole.at))  # in the dart's fold, which is hidden after sewing


@pytest.mark.parametrize("mouth", [50, 100])
def test_closed_darts_have_notches_on_the_extensions_of_their_legs(mouth):
    """When the dart is folded, its legs meet, and so do its notches."""
    (piece,) = Pattern.from_result(dart(mouth, 120), allowance=12.0).pieces
    notches = marks(piece, "notch")
    legs = [line.points for line in piece.of_role("sew") if line.width is None]
    ends = [leg if np.array_equal(leg[-1], legs[1 - number][0]) else leg[::-1] for number, leg in enumerate(legs)]
    assert len(notches) == len(ends) == 2
    for notch, (start, after) in zip(notches, (leg[:2] for leg in ends), strict=True):
        assert line_string(piece.of_role("cut")[0]).distance(shapely.Point(notch.at)) < 1e-3
        inward = (after - start) / np.linalg.norm(after - start)
        assert notch.direction == pytest.approx(inward)
        assert start - notch.at == pytest.approx(inward * np.linalg.norm(start - notch.at), abs=1e-6)
        assert notch.depth == pytest.approx(5.0)
    for how in ("cut", "slit"):
        (piece,) = Pattern.from_result(dart(mouth, 120), darts=how, notch_spacing=0).pieces
        assert not marks(piece, "notch")


@pytest.mark.parametrize(("mouth", "is_folded"), [(120, True), (140, False)])
def test_a_dart_that_would_fold_over_50_mm_is_cut_out(mouth, is_folded):
    result = dart(mouth, 190)
    (flat,) = result.pieces
    ends = flat.vertices[flat.source_vertex == 1]
    assert (1000 * np.linalg.norm(ends[1] - ends[0]) <= 50) == is_folded
    closed, out = (Pattern.from_result(result, darts=how, allowance=3).pieces[0] for how in ("close", "cut"))
    assert cut_polygon(closed).equals(cut_polygon(out)) != is_folded


def test_a_closed_dart_without_a_gap_has_one_notch():
    sheet = grid([-100, 0, 100], [0, 100, 200], seams=[(1, 4)])
    (piece,) = Pattern.from_result(sheet).pieces
    (notch,), (hole,) = marks(piece, "notch"), marks(piece, "drill")
    assert notch.direction == pytest.approx((hole.at - notch.at) / np.linalg.norm(hole.at - notch.at))


def least_distance(piece):
    """Return the smallest distance in millimeters of a point of a stitching line from the cutting line."""
    (cut,) = piece.of_role("cut")
    points = np.concatenate([line.points for line in piece.of_role("sew")])
    return shapely.distance(line_string(cut), shapely.points(points)).min()


def test_closed_darts_that_begin_at_one_point_have_their_allowance_there():
    """On three pieces of the toy, two darts begin at one point of the outline."""
    assert min(map(least_distance, sample("Toy", allowance=10.0).pieces)) > 9.99


def test_closed_darts_are_cut_out_if_nothing_else_is_on_the_outline():
    """The piece is a star. Its 8 outer points are one point of the model, so its outline has only legs of darts."""
    count = 8
    rows = np.arange(2 * count)
    is_inner, angles = rows % 2 == 1, np.pi / count * rows
    points = np.where(is_inner, 10.0, 100.0)[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
    sources, edges = np.where(is_inner, rows, 0), np.column_stack([rows, np.roll(rows, -1)])
    chains = [Chain(sources[edge], row // 2) for row, edge in enumerate(edges)]
    star = FlatPiece("Star", points, sources, edges, chains, [])
    names = [f"Seam {number + 1}" for number in range(count)]
    closed, out = (Pattern.from_pieces([star], names, darts=how).pieces[0] for how in ("close", "cut"))
    assert cut_polygon(closed).equals(cut_polygon(out)) and least_distance(closed) > 9.99


def test_no_notch_starts_on_a_distant_cutting_line():
    # Between the legs of a narrow dart that is cut out, the allowances merge, so there can be no notches.
    (piece,) = Pattern.from_result(dart(40, 100), darts="cut").pieces
    outline = sew_polygon(piece)
    assert all(outline.distance(shapely.Point(point.at)) < 10.01 for point in piece.points)
    assert not any(point.pair for point in piece.points)
