# SPDX-License-Identifier: GPL-3.0-or-later
"""Plane geometry finds overlapping outlines, points inside of outlines, and distances from outlines."""

import math

import numpy as np
import pytest
import shapely
from patterns import turn
from wirewarp.pattern.geometry import Rays, are_inside, distances_to, lengths_along, overlap, sampled, signed_area


def test_an_outline_inside_of_another_overlaps_it_unless_it_is_in_a_hole():
    def square(x, y, side):
        return [np.array([[x, y], [x + side, y], [x + side, y + side], [x, y + side]], dtype=float)]

    big = square(0, 0, 10)
    assert overlap(big, square(4, 4, 1)) and overlap(square(4, 4, 1), big)
    assert not overlap(big, square(20, 0, 1))
    ring = big + square(2, 2, 6)
    assert not overlap(ring, square(3, 3, 1))  # a square in the hole of the ring
    assert not overlap(ring, square(2, 2, 6))  # a square that fills the hole
    assert overlap(ring, square(1.9, 2, 6))


def polygon(corners, scale=1.0, start=0):
    """Return a polygon with coordinates rounded to single precision, as Blender rounds them."""
    return [np.roll(np.float32(scale * np.array(corners)).astype(float), -start, axis=0)]


SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]


@pytest.mark.parametrize(
    "other",
    [
        [(1, 0), (3, 0), (3, 2), (1, 2)],  # shifted along a side
        SQUARE,
        [(1, 1), (2, 1), (3, 1), (3, 2), (3, 3), (1, 3), (1, 2)],  # corners at the crossings
        [(-1, 0.3), (3, 0.3), (3, 0.4), (-1, 0.4)],  # a bar across the square
        [(1.9, 1.9), (5, 2), (5, 5), (2, 5)],  # one corner
    ],
)
@pytest.mark.parametrize("scale", [0.01, 1000.0])
def test_pieces_over_one_another_overlap_wherever_their_outlines_start(other, scale):
    for first, second in np.ndindex(4, len(other)):
        pair = polygon(SQUARE, scale, first), polygon(other, scale, second)
        assert overlap(*pair), (first, second)
        assert overlap(*pair[::-1]), (first, second)


@pytest.mark.parametrize(
    "other",
    [
        [(2, 0), (4, 0), (4, 2), (2, 2)],  # side by side
        [(2, 0.7), (4, 0.7), (4, 3), (2, 3)],  # along a part of a side
        [(2, 1), (3, 0), (4, 1), (3, 2)],  # a corner on a side
        [(2, 2), (4, 2), (4, 4), (2, 4)],  # corner to corner
        [(2, 1), (7, 0.99), (7, 1.01)],  # a sharp tip
    ],
)
def test_pieces_that_touch_do_not_overlap_however_they_are_turned(other):
    for degrees in range(0, 360, 3):
        first, second = (polygon(np.array(corners) @ turn(degrees) + 7, 100.0) for corners in (SQUARE, other))
        assert not overlap(first, second), degrees
        assert not overlap(second, first), degrees


def test_outlines_without_area_overlap_nothing():
    for flat in ([(0.5, 0.5), (1, 1), (1.5, 1.5)], [(1, 1)] * 3, [(0, 1), (2, 1), (1, 1)]):
        assert not overlap(polygon(SQUARE), polygon(flat)) and not overlap(polygon(flat), polygon(SQUARE))


@pytest.mark.parametrize("seed", range(5))
def test_points_beside_random_outlines_are_judged_as_by_shapely(seed):
    """The outline is a star, and its hole is a smaller star."""
    random = np.random.default_rng(seed)
    angles = np.sort(random.uniform(0, 2 * np.pi, 40))
    ways = np.column_stack([np.cos(angles), np.sin(angles)])
    outlines = [random.uniform(50, 100, 40)[:, None] * ways, random.uniform(20, 45, 40)[:, None] * ways]
    star = shapely.Polygon(outlines[0], [outlines[1]])
    points = random.uniform(-110, 110, (200, 2))
    assert are_inside(points, outlines).tolist() == shapely.contains_xy(star, points).tolist()
    assert distances_to(points, outlines) == pytest.approx(shapely.distance(star.boundary, shapely.points(points)))
    assert signed_area(outlines[0]) - signed_area(outlines[1]) == pytest.approx(star.area)
    assert signed_area(outlines[0][::-1]) == pytest.approx(-signed_area(outlines[0]))
    line = shapely.LineString(outlines[0])
    assert lengths_along(outlines[0])[-1] == pytest.approx(line.length)
    apart = lengths_along(sampled(outlines[0], 3.0))
    assert len(apart) == math.ceil(line.length / 3.0) + 1
    assert shapely.distance(line, shapely.points(sampled(outlines[0], 3.0))) == pytest.approx(0, abs=1e-9)
    for point, way in zip(points, ways, strict=False):
        ray = shapely.LineString([point, point + 1000 * way]).intersection(star.boundary)
        expected = math.inf if ray.is_empty else ray.distance(shapely.Point(point))
        assert Rays(outlines).length(point, way) == pytest.approx(expected)
