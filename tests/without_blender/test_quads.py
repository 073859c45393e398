# SPDX-License-Identifier: GPL-3.0-or-later
"""Only the corners of a quad decide how it is split."""

import numpy as np
import pytest


@pytest.mark.parametrize("turn", range(4))
def test_a_quad_with_a_reflex_corner_is_split_inside(addon, turn):
    """The second face is an arrowhead. The diagonal between its outer corners is outside of the face."""
    arrow = np.roll([(0.0, 0.0, 0.0), (2.0, 1.0, 0.0), (0.0, 2.0, 0.0), (1.0, 1.0, 0.0)], turn, axis=0)
    places = np.vstack([[(5.0, 0.0, 0.0), (6.0, 0.0, 0.0), (6.0, 1.0, 0.0)], arrow]).astype(np.float32)
    starts, sizes = np.array([0, 3], np.int32), np.array([3, 4], np.int32)
    for given in ([(0, 1, 2), (3, 4, 5), (3, 5, 6)], [(0, 1, 2), (3, 4, 6), (4, 5, 6)]):
        corners = addon.solve.arrays.with_split_quads(np.array(given, np.int32), starts, sizes, places)
        assert corners.dtype == np.int32 and corners[0].tolist() == [0, 1, 2]
        a, b, c = places[corners[1:]].transpose(1, 0, 2)
        assert (np.cross(b - a, c - a)[:, 2] > 0).all()
        assert sorted(np.unique(corners[1:]).tolist()) == [3, 4, 5, 6]
