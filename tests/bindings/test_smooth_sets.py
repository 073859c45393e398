# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets of seams as smooth lines across triangles: their figures are those of the mesh that is cut along them."""

import numpy as np
import pytest
from wirewarp import cut_mesh, flatten, propose_seams
from wirewarp.report.make import make_report


def egg() -> tuple[np.ndarray, np.ndarray]:
    """Return an octahedron with each face divided into 64, moved to an ellipsoid."""
    vertices = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float)
    faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
    for _ in range(3):
        middle: dict[tuple[int, int], int] = {}
        points = vertices.tolist()

        def between(a: int, b: int, middle=middle, points=points) -> int:
            key = (min(a, b), max(a, b))
            if key not in middle:
                middle[key] = len(points)
                points.append(np.add(points[a], points[b]) / 2)
            return middle[key]

        divided = []
        for a, b, c in faces:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            divided += [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        vertices, faces = np.array(points, float), divided
    vertices /= np.linalg.norm(vertices, axis=1, keepdims=True)
    return vertices * [1, 0.8, 1.4], np.array(faces)


EGG = egg()


def test_figures_are_those_of_a_run_on_the_cut_mesh():
    sets = propose_seams(*EGG, strain=0.05, smooth=True)
    assert any(len(each.edges) == 0 for each in sets)
    for each in sets:
        vertices, faces, edges, _ = cut_mesh(*EGG, each.paths)
        report = make_report(flatten(vertices, faces, seams=edges), vertices, faces)
        assert len(report.pieces) == each.num_pieces
        assert max(piece.needed for piece in report.pieces) == pytest.approx(each.strain, abs=1e-6)
        length = np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1).sum()
        assert length == pytest.approx(each.length)


def test_edges_that_must_not_be_crossed_stay_whole():
    vertices, faces = EGG
    barred = np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    for each in propose_seams(vertices, faces, strain=0.1, smooth=True, no_crossing=barred):
        assert len(each.edges) > 0
