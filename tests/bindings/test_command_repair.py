# SPDX-License-Identifier: GPL-3.0-or-later
"""--repair and --take-proposals repair faults, mark suggestions, and report both."""

import json
from types import SimpleNamespace

import numpy as np
import pytest
from commands import FOLDED
from commands import flatten as run
from wirewarp import Options, Wire
from wirewarp.command import proposals
from wirewarp.command.lines import Lines
from wirewarp.command.model import Model
from wirewarp.command.repair import repaired

pytest.importorskip("trimesh")
SQUARE = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], dtype=float)


def model_of(vertices, faces, corner_uv=None):
    return Model(np.asarray(vertices, dtype=float), np.asarray(faces), corner_uv)


def areas(model):
    a, b, c = model.vertices[model.faces].transpose(1, 0, 2)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def torn_sheet():
    """Return a square and a triangle, whose common edge has two vertices at each end, less than 1e-5 apart."""
    apart = [*SQUARE, (1 + 1e-6, 0, 0), (2, 0, 0), (1, 1 + 1e-6, 0)]
    return model_of(apart, [(0, 1, 2), (0, 2, 3), (4, 5, 6)])


HALVES, TWO = [[0, 1, 2], [0, 2, 3]], [[0, 1, 2], [4, 5, 6]]
REPAIRED = {  # model, the repairs that are reported, and the remaining faces
    "a good mesh": (model_of(SQUARE, HALVES), [], HALVES),
    "vertices closer than files are precise": (torn_sheet(), ["2 overlapping vertices merged"], [*HALVES, [1, 5, 2]]),
    "vertices that are merely near": (model_of([*SQUARE, (1.001, 0, 0), (2, 0, 0), (1.001, 1, 0)], TWO), [], TWO),
    "duplicates that face the other way": (
        model_of(SQUARE, [(0, 1, 2), (2, 1, 0), (0, 2, 3)]),
        ["1 duplicate face removed"],
        HALVES,
    ),
}


@pytest.mark.parametrize("case", REPAIRED)
def test_only_faults_are_repaired_and_vertices_keep_their_numbers(case):
    model, done, faces = REPAIRED[case]
    found = repaired(model)
    assert (found.done, found.seams.tolist(), found.model.faces.tolist()) == (done, [], faces)


def test_a_face_without_area_is_removed_and_its_neighbor_divided():
    """A vertex is in the middle of a square's diagonal. The triangle on the left of the diagonal does not use it."""
    vertices = [*SQUARE, (0.5, 0.5, 0)]
    uv = np.array([SQUARE[list(face), :2] for face in [(0, 2, 3)]] + [np.zeros((3, 2))] * 3)
    faces = [(0, 2, 3), (0, 4, 2), (0, 1, 4), (1, 2, 4)]
    found = repaired(model_of(vertices, faces, uv))
    assert found.done == ["1 zero-area face removed"] and areas(found.model) == pytest.approx([0.25] * 4)
    new = [row for row, face in enumerate(found.model.faces.tolist()) if {3, 4} <= set(face)]
    for row in new:  # the UV map is divided at the same place
        for corner, vertex in enumerate(found.model.faces[row]):
            assert found.model.corner_uv[row, corner] == pytest.approx(np.array(vertices[vertex])[:2])


def test_two_faces_without_area_are_removed_and_their_neighbors_joined():
    """Both faces without area are on one line. Each of them has a vertex on the long edge of the other."""
    vertices = [(0, 0, 0), (3, 0, 0), (1, 0, 0), (2, 0, 0), (1, 1, 0), (1, -1, 0)]
    faces = [(0, 1, 2), (1, 0, 3), (0, 2, 4), (2, 1, 4), (0, 5, 3), (3, 5, 1)]
    found = repaired(model_of(vertices, faces))
    assert found.done == ["2 zero-area faces removed"]
    edges = np.sort(found.model.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    edges, counts = np.unique(edges, axis=0, return_counts=True)
    on_line = (edges < 4).all(axis=1)
    assert (counts[on_line] == 2).all()
    assert areas(found.model).sum() == pytest.approx(3.0)


def test_a_moebius_strip_does_not_change():
    count = 12
    angles = np.pi * np.arange(count) / count  # the strip makes half a turn, so it is a Möbius strip
    middle = np.column_stack([np.cos(2 * angles), np.sin(2 * angles), np.zeros(count)])
    across = np.column_stack([np.cos(angles)[:, None] * middle[:, :2], np.sin(angles)]) / 3
    vertices = np.concatenate([middle - across, middle + across])
    faces = []
    for k in range(count):
        a, b = (k, k + count), ((k + 1) % count, (k + 1) % count + count)
        b = b[::-1] if k == count - 1 else b
        faces += [(a[0], b[0], b[1]), (a[0], b[1], a[1])]
    assert repaired(model_of(vertices, faces)).done == []


def test_lines_of_the_file_are_translated():
    apart = repaired(torn_sheet())
    assert apart.chain(np.array([0, 4, 6])) == [0, 1, 2]
    assert apart.pairs(np.array([(4, 6), (1, 4)])).tolist() == [[1, 2]]
    divided = repaired(model_of([*SQUARE, (0.5, 0.5, 0)], [(0, 2, 3), (0, 4, 2), (0, 1, 4), (1, 2, 4)]))
    assert divided.chain(np.array([3, 0, 2])) == [3, 0, 4, 2]
    flipped = repaired(model_of([*SQUARE, (2, 0, 0)], [(0, 1, 2), (0, 2, 3), (1, 2, 4)]))
    assert flipped.done == ["1 face flipped"]
    assert flipped.sides(np.array([(2, 4), (0, 1)])).tolist() == [[4, 2], [0, 1]]


def test_the_smaller_part_is_flipped_to_match_the_rest():
    grid = np.array([(x, y, 0) for y in range(3) for x in range(3)], dtype=float)
    faces = [(a, a + 1, a + 4) for a in (0, 1, 3, 4)] + [(a, a + 4, a + 3) for a in (0, 1, 3, 4)]
    faces[5] = faces[5][::-1]
    found = repaired(model_of(grid, faces))
    assert found.done == ["1 face flipped"]
    a, b, c = found.model.vertices[found.model.faces].transpose(1, 0, 2)
    assert (np.cross(b - a, c - a)[:, 2] > 0).all()


def test_edges_of_three_faces_become_seams():
    found = repaired(model_of([*SQUARE, (0.5, 0.5, 1)], [(0, 1, 2), (0, 2, 3), (0, 2, 4)]))
    assert found.seams.tolist() == [[0, 2]]
    assert found.done == ["1 edge of three or more faces marked as seams"]


def test_a_model_that_fails_is_repaired_on_request(tmp_path):
    path = tmp_path / "double.obj"
    path.write_text(FOLDED + "f 1/1 2/2 5/3 4/4\n")
    ((line,), _) = run(path, "--out", tmp_path / "out", code=1)
    assert line["verdict"] == "not ready to cut"
    ((line,), _) = run(path, "--out", tmp_path / "out", "--repair")
    assert line["repairs"] == ["2 duplicate faces removed"]  # triangles of the repeated quad
    assert line["pieces"] == 1 and "repairs" in json.loads((tmp_path / "out" / "double.json").read_text())["line"]


def test_suggested_seams_are_marked_on_request(tmp_path):
    count = 12
    turn = 2 * np.pi * np.arange(count) / count
    rings = [f"v {np.cos(a) / 20} {np.sin(a) / 20} {z}" for z in (0, 0.1) for a in turn]
    sides = [f"f {k + 1} {(k + 1) % count + 1} {(k + 1) % count + 1 + count} {k + 1 + count}" for k in range(count)]
    (tmp_path / "tube.obj").write_text("\n".join(rings + sides) + "\n")
    ((line,), _) = run(tmp_path / "tube.obj", "--out", tmp_path / "out", code=1)
    assert line["verdict"] == "not ready to cut" and "repairs" not in line
    ((line,), _) = run(tmp_path / "tube.obj", "--out", tmp_path / "out", "--take-proposals")
    assert line["verdict"] == "ready to cut" and line["repairs"] == ["1 suggested edge marked as seams"]


def test_the_widest_of_several_suggested_tolerances_is_used_once(monkeypatch):
    def result(*suggested):
        errors = [SimpleNamespace(proposed_seams=[], proposed_tolerances=[pair]) for pair in suggested]
        return SimpleNamespace(pieces=[SimpleNamespace(error=error) for error in errors])

    rounds = []

    def flattened_again(*_, wires, **__):
        rounds.append([wire.tolerance for wire in wires])
        return result((0, 0.05))  # less than the tolerance that the wire has by now

    monkeypatch.setattr(proposals, "flatten", flattened_again)
    lines = Lines([Wire([0, 1]), Wire([1, 2])])
    seams = np.empty((0, 2), dtype=np.int64)
    model = model_of(SQUARE, [(0, 1, 2)])
    _, lines, done = proposals.with_proposals(model, result((0, 0.05), (0, 0.1), (0, 0.02)), seams, lines, Options())
    assert rounds == [[0.1, 0.0]] and [wire.tolerance for wire in lines.wires] == [0.1, 0.0]
    assert done == ["tolerance of 1 wire widened as suggested"]


def test_blender_files_are_repaired_in_blender(tmp_path):
    (tmp_path / "a.blend").write_bytes(b"BLENDER")
    ((line,), _) = run(tmp_path / "a.blend", "--out", tmp_path / "out", "--repair", code=2)
    assert "Check and Repair in Blender" in line["problems"][0]
