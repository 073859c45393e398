# SPDX-License-Identifier: GPL-3.0-or-later
"""cut_mesh() and straighten_path() return correct arrays, and refuse invalid paths."""

import pickle
from collections.abc import Callable

import numpy as np
import pytest
import wirewarp
from refusals import error_of
from surfaces import grid, spherical_patch

Lines = list[wirewarp.SurfacePath]


def across(columns: int, at: float, end: float) -> wirewarp.SurfacePath:
    """Return a level path in a grid over the unit square, from the left side to x = `end`, at y = `at`."""
    cell = int(at * columns)
    faces, coordinates = [], []
    fraction = at * columns - cell
    for column in range(int(end * columns)):
        lower = 2 * (cell * columns + column)  # this face has the lower left, lower right and upper right corner
        # The path runs through the upper left triangle to the diagonal, then through the lower right triangle.
        faces += [lower + 1, lower]
        coordinates += [(1 - fraction, 0, fraction), (1 - fraction, 0, fraction)]
    faces.append(lower)
    coordinates.append((0, 1 - fraction, fraction))
    return wirewarp.SurfacePath(faces, coordinates)


def test_attributes_of_vertices_faces_and_corners_are_kept() -> None:
    vertices, faces = grid(4, 4, lambda u, v: (u, v, u * v))
    of_vertices = np.column_stack([vertices, vertices @ [1.0, 2, 3]])
    of_faces = np.arange(len(faces))
    of_corners = 10 * of_faces[:, None, None] + vertices[faces]
    path = across(4, 0.3, 1.0)
    new_vertices, new_faces, edges, sources = wirewarp.cut_mesh(vertices, faces, [path])
    assert new_vertices.shape == (len(vertices) + 9, 3) and (new_vertices[: len(vertices)] == vertices).all()
    assert (edges.shape, edges.dtype) == ((8, 2), np.int32) and (sources.edge_paths == 0).all()
    assert np.allclose(new_vertices[np.unique(edges), 1], 0.3, rtol=0, atol=1e-15)
    mixed = (sources.vertex_weights[:, :, None] * of_vertices[sources.vertices]).sum(axis=1)
    assert np.allclose(mixed, np.column_stack([new_vertices, new_vertices @ [1.0, 2, 3]]), rtol=0, atol=1e-14)
    corners = np.einsum("fij,fjk->fik", sources.corner_weights, of_corners[sources.faces])
    assert np.allclose(corners, 10 * of_faces[sources.faces][:, None, None] + new_vertices[new_faces], atol=1e-12)
    assert (np.bincount(sources.faces, minlength=len(faces))[np.unique(path.faces)] == 3).all()
    uprights, diagonals = {(v, v + 5) for v in range(5, 10)}, {(v, v + 6) for v in range(5, 9)}
    assert {tuple(line[[0, -1]].tolist()) for line in sources.divided_edges} == uprights | diagonals


def test_paths_and_sources_can_be_pickled_and_written_as_json() -> None:
    vertices, faces = grid(2, 2, lambda u, v: (u, v, 0.0))
    path = across(2, 0.3, 1.0)
    sources = wirewarp.cut_mesh(vertices, faces, [path])[3]
    for record in (path, sources):
        again = pickle.loads(pickle.dumps(record))
        assert again.to_dict() == record.to_dict()
    assert path.to_dict()["faces"] == [1, 0, 3, 2, 2]


POINTS = np.eye(3)[:2]  # barycentric coordinates of two corners of a triangle


def check_refusal(code: str, said: str, call: Callable[[], object]) -> None:
    error = error_of(call)
    assert error.code == code and str(error).startswith(said)


@pytest.mark.parametrize(
    ("faces", "coordinates", "code", "said"),
    [
        ([0], [(1, 0, 0)], "invalid_option", "The option path is too short: it must have two points or more."),
        ([0, 1], [(1, 0, 0)], "invalid_option", "The option path is a line of 2 faces and 1 coordinates: it must have"),
        ([0, 0.5], POINTS, "invalid_type", "SurfacePath faces must be whole numbers, not float64."),
        ([[0, 0]], POINTS, "invalid_shape", "SurfacePath faces has the shape (1, 2): it must be (n,)."),
        ([0, 0], [(1, 0), (0, 1)], "invalid_shape", "SurfacePath coordinates has the shape (2, 2): it must be (n, 3)."),
        ([0, 0], [(1, 0, 0), (0, np.nan, 1)], "invalid_option", "The option path is at point 1 at 0, nan, 1: it must"),
        ([0, 10**12], POINTS, "invalid_option", "The option SurfacePath faces is a list with 1000000000000: it"),
    ],
)
def test_invalid_paths_are_refused(faces: object, coordinates: object, code: str, said: str) -> None:
    check_refusal(code, said, lambda: wirewarp.SurfacePath(faces, coordinates))


@pytest.mark.parametrize(
    ("paths", "snap", "code", "said"),
    [
        ([(0, 1)], 0.05, "invalid_type", "paths[0] must be a SurfacePath, not tuple."),
        (None, 0.05, "invalid_type", "paths must be a list of SurfacePath, not NoneType."),
        ([], "much", "invalid_type", "snap must be a number, not str."),
        ([], 1.0, "invalid_option", "The option snap is 1: it must be from 0.0001 to 0.25."),
        ([wirewarp.SurfacePath([0, 99], POINTS)], 0.05, "invalid_option", "The option paths[0] is a line in"),
    ],
)
def test_invalid_arguments_of_cut_mesh_are_refused(paths: Lines, snap: float, code: str, said: str) -> None:
    check_refusal(code, said, lambda: wirewarp.cut_mesh(*spherical_patch(4, 4), paths, snap=snap))


def test_a_straightened_dart_is_shorter_with_the_same_ends():
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
def test_paths_that_cannot_be_straightened_are_refused(path, code, sentence):
    check_refusal(code, sentence, lambda: wirewarp.straighten_path(*spherical_patch(4, 4), path))
