# SPDX-License-Identifier: GPL-3.0-or-later
"""The narrowest width of a shape is the diameter of the largest disk that can move through the shape."""

from dataclasses import replace

import numpy as np
import pytest
from patterns import turn
from surfaces import chain_edges, column_chain, half_cylinder
from wirewarp import Options, flatten
from wirewarp.pattern import has_room, narrow_pieces, narrowest_width, piece_width, pieces_along
from wirewarp.pattern.make.outline import flat_piece

NEAR = 1e-3  # tolerance of the search, as a share of the width


def circle(radius, center=(0.0, 0.0), first=0.0, last=2 * np.pi, count=128):
    angles = np.linspace(first, last, count, endpoint=last - first < 2 * np.pi)
    return np.array(center) + radius * np.column_stack([np.cos(angles), np.sin(angles)])


def dumbbell(first, second, waist):
    """Return two disks of these radii with centers 4 apart, and a bar of width `waist` between them."""
    left, right = np.arcsin(waist / 2 / first), np.arcsin(waist / 2 / second)
    return np.concatenate(
        [circle(first, (-2, 0), left, 2 * np.pi - left), circle(second, (2, 0), right - np.pi, np.pi - right)]
    )


@pytest.mark.parametrize(
    ("outlines", "width"),
    [
        ([np.array([[0, 0], [3, 0], [3, 1], [0, 1]])], 1.0),
        ([circle(2)], 4.0),
        ([circle(2), circle(1)[::-1]], 1.0),  # a ring
        ([dumbbell(1, 1, 0.3)], 0.3),
        ([dumbbell(1, 0.6, 0.3)], 0.3),
        ([dumbbell(1, 0.2, 0.1)], 2.0),  # the smaller disk is ignored, because it has less than a tenth of the area
    ],
)
def test_the_width_is_the_diameter_of_the_largest_disk_that_moves_through(outlines, width):
    assert narrowest_width(outlines) == pytest.approx(width, rel=NEAR)
    elsewhere = [3.0 + 1000 * outline @ turn(40) for outline in outlines]
    assert narrowest_width(elsewhere) == pytest.approx(1000 * width, rel=NEAR)


def test_an_outline_without_area_has_no_width():
    assert narrowest_width([np.array([[0.0, 0], [1, 0], [2, 0]])]) == 0
    square = [np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])]
    assert 0.5 <= narrowest_width(square, 0.5) < 1 and narrowest_width(square, 1.5) == narrowest_width(square)


def test_a_piece_is_measured_flat():
    vertices, faces = half_cylinder()
    for piece in flatten(vertices, faces, seams=chain_edges(column_chain(8, 4, 4))).pieces:
        sides = np.ptp(piece.vertices, axis=0)
        assert piece_width(piece) == pytest.approx(sides.min(), rel=NEAR)


def sheet(columns, rows, is_hole, options=None):
    """Flatten a flat sheet of unit squares. Return the piece and the vertices of the sheet.

    The sheet lacks the squares with lower left corners x, y for which is_hole(x, y) is true.
    """
    lower, left = np.divmod(np.arange((rows + 1) * (columns + 1)), columns + 1)
    vertices = np.column_stack([left, lower, 0 * lower]).astype(float)
    cells = [(x, y) for y in range(rows) for x in range(columns) if not is_hole(x, y)]
    corners = [y * (columns + 1) + x for x, y in cells]
    faces = [face for a in corners for face in ((a, a + 1, a + columns + 2), (a, a + columns + 2, a + columns + 1))]
    used, faces = np.unique(faces, return_inverse=True)
    (piece,) = flatten(vertices[used], faces.reshape(-1, 3), options=options or Options()).pieces
    return piece, vertices[used]


def test_a_hole_leaves_the_width_beside_it():
    piece, _ = sheet(6, 6, lambda x, y: 2 <= x < 4 and 1 <= y < 5)
    assert piece_width(piece) == pytest.approx(1.0, rel=NEAR)
    assert has_room(piece, 0.49) and not has_room(piece, 0.51)


BAR = 1.0  # width of the bar of an H, between squares three times as wide


@pytest.mark.parametrize("is_mirrored", [False, True])
def test_only_the_allowances_at_the_narrow_place_need_room_there(is_mirrored):
    piece, vertices = sheet(7, 3, lambda x, y: x == 3 and y != 1, Options(mirror=is_mirrored))
    index = {tuple(place): vertex for vertex, place in enumerate(vertices[:, :2].astype(int).tolist())}
    assert piece_width(piece) == pytest.approx(BAR, rel=NEAR)
    assert has_room(piece, 0.49) and not has_room(piece, 0.51)
    # The left end is far away from the bar. A hem there may be twice as wide as the bar.
    far = [(index[0, y + 1], index[0, y]) for y in range(3)]
    assert has_room(piece, 0.4, far, np.full(3, 2 * BAR))
    below = [(index[3, 1], index[4, 1])]  # the lower edge of the bar, with the bar on its left
    assert has_room(piece, 0.4, below, [0.59]) and not has_room(piece, 0.4, below, [0.61])
    assert has_room(piece, 0.4, np.flip(below), [0.61])  # the side without the piece has no allowance
    assert has_room(piece, 0.0) and not has_room(piece, 5.0)


def test_narrow_pieces_have_too_little_room_for_their_own_allowances():
    piece, vertices = sheet(7, 3, lambda x, y: x == 3 and y != 1)
    index = {tuple(place): vertex for vertex, place in enumerate(vertices[:, :2].astype(int).tolist())}
    bar = flat_piece(piece, "Bar", 1.0)
    without_shape = replace(bar, name="Without shape", vertices=np.full_like(bar.vertices, np.nan))
    below = (index[3, 1], index[4, 1])

    def found(allowance=0.4, both=(), sides=(), folds=()):
        return narrow_pieces([bar, without_shape], allowance, both, sides, folds)

    assert found(0.49) == [] and found(0.51) == ["Bar"]
    assert found(both=[(*below, 0.61)]) == found(both=[(*below[::-1], 0.61)]) == ["Bar"]
    assert found(both=[(*below, 0.61)], sides=[(*below, 0.59)]) == []
    assert found(both=[(*below, 0.59)], sides=[(*below, 0.61)]) == ["Bar"]
    assert found(sides=[(*below, 0.61)], folds=[below[::-1]]) == []


def test_pieces_along_edges_contain_a_whole_edge():
    """Two seams divide a half cylinder into three strips. An edge that only ends on a seam is in one strip."""
    vertices, faces = half_cylinder()
    left, right = column_chain(8, 4, 2), column_chain(8, 4, 6)
    pieces = flatten(vertices, faces, seams=[*chain_edges(left), *chain_edges(right)]).pieces
    outer, middle, other = sorted(pieces, key=lambda piece: vertices[piece.source_vertex].mean(axis=0)[0])

    def found(edges):
        return {id(piece) for piece in pieces_along(pieces, edges)}

    assert found(chain_edges(left)) | found(chain_edges(right)) == {id(outer), id(middle), id(other)}
    assert len(found(chain_edges(left))) == len(found(chain_edges(right))) == 2
    assert found(chain_edges(column_chain(8, 4, 4))) == {id(middle)} and found([(2, 3)]) == {id(middle)}
    assert found(np.empty((0, 2), dtype=int)) == set()
