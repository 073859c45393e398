# SPDX-License-Identifier: GPL-3.0-or-later
"""Which outlines lie over one another, and which only touch."""

import math

import numpy as np
import pytest


def test_outlines_that_cross_or_contain_each_other_overlap(addon):
    polygons = addon.pattern.polygons

    def square(x, y, side):
        corners = np.array([[x, y], [x + side, y], [x + side, y + side], [x, y + side]], dtype=float)
        return polygons.Segments(corners, np.roll(corners, -1, axis=0))

    big = square(0, 0, 10)
    assert polygons.overlap(big, square(8, 8, 10))
    assert polygons.overlap(big, square(4, 4, 1))
    assert polygons.overlap(square(4, 4, 1), big)
    assert not polygons.overlap(big, square(10, 0, 10))  # side by side
    assert not polygons.overlap(big, square(20, 0, 1))
    ring = polygons.Segments(*(np.concatenate([big[k], square(2, 2, 6)[k]]) for k in (0, 1)))
    assert not polygons.overlap(ring, square(3, 3, 1))  # in its hole
    assert not polygons.overlap(ring, square(2, 2, 6))  # that fills it
    assert polygons.overlap(ring, square(1.9, 2, 6))


def polygon(addon, corners, scale=1.0, start=0):
    """Its segments, in single precision as of a mesh."""
    corners = np.roll(np.float32(scale * np.array(corners)).astype(float), -start, axis=0)
    return addon.pattern.polygons.Segments(corners, np.roll(corners, -1, axis=0))


SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]


@pytest.mark.parametrize(
    "other",
    [
        [(1, 0), (3, 0), (3, 2), (1, 2)],  # slid along a side
        SQUARE,
        [(1, 1), (2, 1), (3, 1), (3, 2), (3, 3), (1, 3), (1, 2)],  # corners where they cross
        [(-1, 0.3), (3, 0.3), (3, 0.4), (-1, 0.4)],  # across, no middle of a side inside
        [(1.9, 1.9), (5, 2), (5, 5), (2, 5)],  # one corner
    ],
)
@pytest.mark.parametrize("scale", [0.01, 1000.0])
def test_pieces_over_one_another_overlap_wherever_their_outlines_start(addon, other, scale):
    for first, second in np.ndindex(4, len(other)):
        pair = polygon(addon, SQUARE, scale, first), polygon(addon, other, scale, second)
        assert addon.pattern.polygons.overlap(*pair), (first, second)
        assert addon.pattern.polygons.overlap(*pair[::-1]), (first, second)


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
def test_pieces_that_touch_do_not_overlap_however_they_are_turned(addon, other):
    for degrees in range(0, 360, 3):
        angle = math.radians(degrees)
        turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
        first, second = (polygon(addon, np.array(corners) @ turn + 7, 100.0) for corners in (SQUARE, other))
        assert not addon.pattern.polygons.overlap(first, second), degrees
        assert not addon.pattern.polygons.overlap(second, first), degrees
