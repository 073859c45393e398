# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of flatten() in Python have exact lengths and correct arrays, which outlive their result."""

import gc
import importlib.metadata
import json
import math

import numpy as np
import pytest
import wirewarp
from surfaces import chain_edges, column_chain, half_cylinder, spherical_patch, tetrahedron


def chain_length(points: np.ndarray) -> float:
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


def test_both_sides_of_a_seam_and_a_wire_keep_their_length_on_a_sphere():
    vertices, faces = spherical_patch(columns=8, rows=8)
    seam = column_chain(8, 8, 4)
    row = list(range(36, 45))  # a wire across the middle, over the seam
    result = wirewarp.flatten(vertices, faces, seams=chain_edges(seam), wires=[wirewarp.Wire(row, name="waist")])
    assert [piece.error for piece in result.pieces] == [None, None]

    (seam_report,) = result.seams
    assert sorted(seam_report.pieces) == [0, 1]
    assert seam_report.length_3d == pytest.approx(chain_length(vertices[seam]), rel=1e-12)
    assert seam_report.length_2d == pytest.approx([seam_report.length_3d] * 2, rel=1e-9)
    assert seam_report.mismatch <= 1e-9 * seam_report.length_3d
    assert {tuple(sorted(edge)) for edge in seam_report.edges.tolist()} == set(chain_edges(seam))

    (waist,) = result.wires
    assert (waist.name, waist.wire_index, waist.part, waist.kind) == ("waist", 0, -1, "rigid")
    assert waist.length_3d == pytest.approx(chain_length(vertices[row]), rel=1e-12)
    assert waist.length_2d == pytest.approx(waist.length_3d, rel=1e-9)
    parts = [part for piece in result.pieces for part in piece.wires]
    assert sorted(part.part for part in parts) == [0, 1]
    assert sum(part.length_2d for part in parts) == pytest.approx(waist.length_2d, rel=1e-12)
    assert waist.vertices.tolist() == row
    assert sorted(part.vertices.tolist() for part in parts) == [row[:5], row[4:]]


def test_measuring_a_result_gives_the_same_figures():
    vertices, faces = spherical_patch()
    wires = [wirewarp.Wire(range(36, 45))]
    made = wirewarp.flatten(vertices, faces, wires=wires)
    measured = wirewarp.measure(vertices, faces, made.corner_uv, wires=wires)
    assert np.array_equal(measured.corner_uv, made.corner_uv)
    assert (measured.report["method"], measured.pieces[0].report.termination) == ("measure", "measured")
    assert measured.pieces[0].error is None
    assert measured.pieces[0].metrics.to_dict() == made.pieces[0].metrics.to_dict()


def test_options_reach_the_core():
    def run(**options):
        return wirewarp.flatten(*spherical_patch(columns=6, rows=9), options=wirewarp.Options(**options))

    def area(result):
        a, b, c = np.moveaxis(result.corner_uv, 1, 0)
        return float(np.linalg.det(np.stack([b - a, c - a], axis=-1)).sum() / 2)

    plain, by_length = run(), run(method="wirewarp++", node_weight="length")
    assert area(plain) > 0 and area(run(mirror=True)) == pytest.approx(-area(plain))
    assert by_length.report["method"] == "wirewarp++"
    others = (by_length, run(method="wirewarp++", node_weight="uniform"), run(fairness=0.3))
    energies = [result.pieces[0].metrics.arap_energy for result in (plain, *others)]
    assert min(energies) == energies[0] and len(set(energies)) == 4


def test_the_arrays_of_a_piece_refer_to_the_input():
    vertices, faces = spherical_patch()
    result = wirewarp.flatten(vertices, faces, seams=chain_edges(column_chain(8, 8, 4)))
    assert result.corner_uv.shape == (len(faces), 3, 2)
    for piece in result.pieces:
        assert np.array_equal(piece.source_vertex[piece.faces], faces[piece.source_face])
        assert np.array_equal(piece.vertices[piece.faces], result.corner_uv[piece.source_face])
        assert piece.vertices.shape == (len(piece.source_vertex), 2)
        metrics = piece.metrics
        assert metrics.face_arap.sum() == pytest.approx(metrics.arap_energy * metrics.area_3d)
        assert metrics.wire_edges.shape == (len(metrics.edge_length_variation), 2)
        assert metrics.flipped_faces.shape == metrics.overlapping_faces.shape == (0,)
        for boundary in piece.boundaries:
            assert boundary.length_3d == pytest.approx(chain_length(vertices[boundary.vertices]))
    for array in (piece.source_vertex, piece.source_face, piece.faces, metrics.flipped_faces, boundary.vertices):
        assert np.issubdtype(array.dtype, np.integer)


def test_arrays_outlive_their_result_and_its_input():
    vertices, faces = spherical_patch()
    expected = wirewarp.flatten(vertices, faces).to_dict()
    inputs = vertices.copy(), faces.copy()
    result = wirewarp.flatten(*inputs)
    assert np.shares_memory(result.corner_uv, result.corner_uv)  # views of the result, not copies
    assert np.shares_memory(result.pieces[0].metrics.face_arap, result.pieces[0].metrics.face_arap)
    for array in inputs:
        array[:] = 0
    parts = {
        "corner_uv": result.corner_uv,
        "vertices": result.pieces[0].vertices,
        "face_arap": result.pieces[0].metrics.face_arap,
        "boundary": result.pieces[0].boundaries[0].vertices,
    }
    del inputs, array, result
    gc.collect()
    overwriting = [wirewarp.flatten(vertices * 3, faces) for _ in range(3)]
    piece = expected["pieces"][0]
    assert parts["corner_uv"].tolist() == expected["corner_uv"]
    assert parts["vertices"].tolist() == piece["vertices"]
    assert parts["face_arap"].tolist() == piece["metrics"]["face_arap"]
    assert parts["boundary"].tolist() == piece["boundaries"][0]["vertices"]
    del overwriting


def test_a_whole_result_is_json():
    vertices, faces = half_cylinder()
    ball_vertices, ball_faces = tetrahedron()
    result = wirewarp.flatten(
        np.vstack([vertices, ball_vertices + 5]),
        np.vstack([faces, ball_faces + len(vertices)]),
        seams=chain_edges(column_chain(8, 4, 4)),
        wires=[wirewarp.Wire(range(18, 27), math.inf, "waist")],
    )
    bad = next(piece for piece in result.pieces if piece.error)
    assert bad.error is bad.error and bad.report.termination == "failed"
    assert np.isnan(bad.vertices).all() and np.isnan(bad.metrics.arap_energy) and bad.metrics.area_3d > 0
    plain = json.loads(json.dumps(result.to_dict(), allow_nan=False))
    assert list(plain) == ["pieces", "corner_uv", "seams", "wires", "report"]
    assert [piece["error"] and piece["error"]["code"] for piece in plain["pieces"]].count("closed_chart") == 1
    assert plain["corner_uv"][0] == result.corner_uv[0].tolist()
    assert plain["corner_uv"][-1] == [[None, None]] * 3 and plain["wires"][0]["kind"] == "super_elastic"
    assert plain["wires"][0]["tolerance"] is None
    assert plain["seams"][0]["length_2d"] == list(result.seams[0].length_2d)
    assert plain["report"]["seconds"].keys() >= {"total"}


def test_a_repr_is_one_short_line():
    result = wirewarp.flatten(*spherical_patch(columns=30, rows=30))
    for value in (result, result.pieces[0], result.pieces[0].metrics, result.pieces[0].report):
        assert repr(value).startswith(type(value).__name__ + "(") and "\n" not in repr(value)
        assert len(repr(value)) < 600


def test_the_version_is_that_of_the_installed_package():
    assert wirewarp.__version__ == importlib.metadata.version("wirewarp")
