# SPDX-License-Identifier: GPL-3.0-or-later
"""straighten_path: arrays in and out; tests/native/test_straighten_path.cpp tests the lines."""

import numpy as np
import pytest
import wirewarp
from surfaces import spherical_patch


def test_a_dart_gets_shorter_with_the_same_ends_and_can_be_cut_again():
    vertices, faces = spherical_patch(12, 12)
    dart = wirewarp.propose_darts(vertices, faces, count=1)[0]
    path = [int(dart.edges[0][0]), *(int(each[1]) for each in dart.edges)]
    edges, t = wirewarp.straighten_path(vertices, faces, np.array(path, dtype=np.uint16))
    assert (edges.shape, edges.dtype, t.shape, t.dtype) == ((len(t), 2), np.int32, (len(edges),), np.float64)
    assert (edges[[0, -1]] == [[path[0]] * 2, [path[-1]] * 2]).all()
    places = (1 - t)[:, None] * vertices[edges[:, 0]] + t[:, None] * vertices[edges[:, 1]]
    assert np.linalg.norm(np.diff(places, axis=0), axis=1).sum() <= dart.length * (1 + 1e-12)
    is_vertex = edges[:, 0] == edges[:, 1]
    assert (t[is_vertex] == 0).all() and (t[~is_vertex] >= 0.05).all() and (t[~is_vertex] <= 0.95).all()


@pytest.mark.parametrize(
    ("path", "code", "sentence"),
    [
        ([0], "invalid_option", "The option path is too short: it must have two vertices or more."),
        ([0, 1.5], "invalid_type", "Path vertex 1 must be a whole number, not float."),
        ("01", "invalid_type", "Path vertices must be a sequence of whole numbers, not str."),
        (np.zeros((2, 2), dtype=int), "invalid_shape", "Path vertices has the shape (2, 2): it must be (n,)."),
        ([0, 1], "invalid_option", "The option path is through 0, 1: it must run inside a piece"),
        ([0, 10**12], "vertex_out_of_range", "Path vertex 1 names vertex 1000000000000"),
    ],
)
def test_invalid_paths_are_refused(path, code, sentence):
    vertices, faces = spherical_patch(4, 4)
    with pytest.raises(wirewarp.FlattenError) as caught:
        wirewarp.straighten_path(vertices, faces, path)
    assert caught.value.code == code
    assert str(caught.value).startswith(sentence)
