# SPDX-License-Identifier: GPL-3.0-or-later
"""Edges in any order become chains of vertices."""

import math

import numpy as np
import pytest


@pytest.fixture
def chains(addon):
    return addon.solve.chains


def vertices_of(chains, edges, positions):
    found = chains.split_into_chains(np.array(edges), np.array(positions, dtype=float))
    return sorted(min(chain.vertices, chain.vertices[::-1]) for chain in found)


def test_shuffled_edges_of_a_path_are_put_in_order_and_a_ring_repeats_its_first_vertex(chains):
    assert vertices_of(chains, [(3, 2), (0, 1), (2, 1)], np.eye(4, 3)) == [[0, 1, 2, 3]]
    ((first, *_, last),) = rings = vertices_of(chains, [(0, 1), (2, 1), (2, 0)], np.eye(3))
    assert first == last and len(rings[0]) == 4


def test_a_ring_with_a_tail_ends_where_three_edges_meet(chains):
    square = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (-1, -1, 0)]
    found = vertices_of(chains, [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4)], square)
    assert found == [[0, 1, 2, 3, 0], [0, 4]] or found == [[0, 3, 2, 1, 0], [0, 4]]


@pytest.mark.parametrize(
    ("degrees", "found"),
    [
        ((0, 80, 180, 260), [[1, 0, 3], [2, 0, 4]]),
        ((0, 10, 180, 190), [[1, 0, 3], [2, 0, 4]]),
        ((0, 60, 120, 180, 240, 300), [[1, 0, 4], [2, 0, 5], [3, 0, 6]]),
        ((0, 90, 180), [[0, 2], [1, 0, 3]]),
        ((0, 120, 240), [[0, 1], [0, 2], [0, 3]]),
        ((0, 90, 180, 270, 45), [[0, 5], [1, 0, 3], [2, 0, 4]]),
    ],
)
def test_lines_that_meet_go_straight_on_or_end(chains, degrees, found):
    """degrees: directions of edges from vertex 0 to the vertices 1, 2 and so on."""
    places = [(0, 0, 0), *((math.cos(math.radians(d)), math.sin(math.radians(d)), 0) for d in degrees)]
    assert vertices_of(chains, [(0, k) for k in range(1, len(places))], places) == found


def test_marks_of_one_id_with_two_tolerances_or_two_eases_are_two_wires(chains):
    edges, ids = np.array([(0, 1), (1, 2), (2, 3)]), np.array([7, 7, 7])
    differing, alike = np.array([0, 0.03, 0.03], dtype=np.float32), np.zeros(3, dtype=np.float32)
    for kinds in ((differing, alike), (alike, differing)):
        wires = chains.chains_of_marks(edges, chains.EdgeMarks(ids, *kinds), np.eye(4, 3))
        assert [(wire.wire_id, wire.vertices) for wire in wires] == [(7, [0, 1]), (7, [1, 2, 3])]
        assert [(wire.tolerance, wire.ease) for wire in wires][1] == (kinds[0][1] and 0.03, kinds[1][1] and 0.03)


def test_one_id_in_two_places_is_two_wires_and_unmarked_edges_are_not_wires(chains):
    edges = np.array([(0, 1), (1, 2), (2, 3)])
    marks = chains.EdgeMarks(np.array([9, 0, 9]), np.full(3, np.inf, np.float32), np.zeros(3, np.float32))
    wires = chains.chains_of_marks(edges, marks, np.eye(4, 3))
    assert [(wire.tolerance, wire.vertices) for wire in wires] == [(math.inf, [0, 1]), (math.inf, [2, 3])]
