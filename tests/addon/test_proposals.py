# SPDX-License-Identifier: GPL-3.0-or-later
"""Buttons mark the seams or tolerances that the report of a failure suggests, or are refused in a sentence."""

import json
import math
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from everything import draw_panels, drawn_buttons
from flattening import edge_vertices, fails, flatten_fails, report_after
from mathutils import Matrix
from suggesting import are_mirrored
from surfaces import bump, flat_of, grid, mark, on_line, read, round_bump, select_only, tube

WIRE = on_line(1, 0.0)
CUT = "mark a seam"


def take(what="SEAMS", issue=0):
    return bpy.ops.mesh.wirewarp_take_proposal(what=what, issue=issue)


def seams_of(target):
    return edge_vertices(target.data)[read(target.data.edges, "use_seam", bool)]


def joined(source, *others):
    select_only(source, *others)
    bpy.ops.object.join()
    return source


def test_two_sleeves_are_fixed_at_once_as_mirror_images(addon):
    """Alone, each sleeve would get its seam at the same side of the tube, so the seams would not be mirror images."""
    source, other = tube(place=-2.0), tube("Other", place=2.0)
    for target in (source, other):  # narrower on the inner side, where a seam is best
        for vertex in target.data.vertices:
            vertex.co.y *= 1 + 0.2 * abs(vertex.co.x)
    joined(source, other)
    flatten_fails(CUT)
    assert [issue.both_sides for issue in addon.state.reports.last_report(source).issues] == [True, True]
    assert take(issue=0) == {"FINISHED"}
    assert len(seams_of(source)) and are_mirrored(source, seams_of(source))
    assert take(issue=1) == {"CANCELLED"}  # The seams of both sleeves are marked already.
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}


def test_pairs_without_mirrored_meshes_are_fixed_at_once_each_by_its_own_seam():
    source, other = tube(), tube("Other", place=4.0)
    # Rotated about the origin, this tube is not a mirror image of the first tube across X, Y or Z.
    other.data.transform(Matrix.Rotation(0.1, 4, "Z"))
    joined(source, other)
    flatten_fails(CUT)
    assert take(issue=1) == {"FINISHED"}
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}


def test_the_button_works_from_the_flat_pieces():
    source = joined(tube(), grid("Bump", bump))
    flatten_fails(CUT)
    select_only(flat_of(source))
    bpy.ops.object.mode_set(mode="EDIT")
    assert take() == {"FINISHED"}
    assert len(seams_of(source)) > 0
    assert bpy.context.mode == "OBJECT"  # because undo restores the model only in Object Mode


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_a_changed_model_is_not_marked(mode):
    source = tube()
    flatten_fails(CUT)
    source.data.vertices[20].co.x += 0.01
    bpy.ops.object.mode_set(mode=mode)
    fails(take, '"Tube" has changed since it was flattened. Flatten it again')
    assert source.mode == mode
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(seams_of(source)) == 0


def test_a_report_of_the_mesh_with_modifiers_is_not_used(addon):
    source = tube()
    source.modifiers.new("Finer", "SUBSURF").levels = 1
    flatten_fails(CUT, use_modifiers=True)
    fails(take, "flatten without Modifiers")
    assert "needs edges that modifiers make" in draw_panels(addon)
    assert not {"mesh.wirewarp_take_proposal", "mesh.wirewarp_select_result"} & set(drawn_buttons(addon))


def test_without_proposals_the_button_is_refused():
    grid("Bump", bump)
    fails(take, '"Bump" has not been flattened yet')
    bpy.ops.object.wirewarp_flatten()
    fails(take, "does not suggest a (seam|tolerance) here. Flatten again")


def neighbors(source, pairs):
    """Return whether all pairs are edges of the model, and each pair shares a vertex with the next pair."""
    return all(set(a) & set(b) for a, b in zip(pairs, pairs[1:], strict=False)) and {
        tuple(sorted(pair)) for pair in pairs
    } <= {tuple(sorted(pair)) for pair in edge_vertices(source.data).tolist()}


def test_a_proposed_diagonal_becomes_the_shorter_way_around_its_face(addon):
    """A proposed edge, such as the edge between the vertices 20 and 21, stays as it is."""
    source = grid("Bump", round_bump, faces="ngons")
    arrays = addon.state.read_model.object_to_arrays(source, addon.state.marked_mesh.marked_mesh(source), None)
    around = addon.solve.flatten.seams_on_edges
    assert around([(20, 21), (21, 20)], arrays) == [(20, 21)]
    diagonals = {
        tuple(sorted(map(int, pair)))
        for triangle in arrays.triangles
        for pair in zip(triangle, np.roll(triangle, 1), strict=True)
    } - {tuple(sorted(pair)) for pair in arrays.edges.tolist()}
    assert len(diagonals) == 3 * len(source.data.polygons)

    def length(pairs):
        return sum(np.linalg.norm(arrays.vertices[c] - arrays.vertices[d]) for c, d in pairs)

    for a, b in diagonals:
        way = around([(a, b)], arrays)
        assert neighbors(source, way)
        ends, count = np.unique(way, return_counts=True)
        assert sorted(ends[count == 1]) == [a, b]
        loops = [list(face.vertices) for face in source.data.polygons if {a, b} <= set(face.vertices)]
        around_face = min(length(list(zip(loop, np.roll(loop, 1), strict=True))) for loop in loops)
        assert length(way) <= around_face / 2


@pytest.fixture
def loosen(addon):
    """Return a model with two wires. Its report suggests tolerances for both wires."""
    source = grid("Bump", bump, wire=WIRE)
    mark(source, on_line(1, 0.5), kind="ELASTIC", tolerance=0.2)
    source.data.wirewarp_names[0].name = "Bust"
    bpy.ops.object.wirewarp_flatten()
    arrays = addon.state.read_model.object_to_arrays(source, addon.state.marked_mesh.marked_mesh(source), None)
    number = {wire.name: index for index, wire in enumerate(arrays.wires)}
    proposed = [(number["Bust"], 0.012341), (number["Wire 2"], 0.05)]
    error = addon.core.library().FlattenError(
        "infeasible_lengths",
        "Too short.",
        proposed_tolerances=proposed,
        arguments={"reason": "wires", "is_refined": True},
    )
    piece = SimpleNamespace(
        error=error, source_face=[], metrics=SimpleNamespace(flipped_faces=[], overlapping_faces=[])
    )
    issue = addon.solve.flatten.issue_of_piece(piece, 0, arrays)
    assert [(wire.name, wire.tolerance) for wire in issue.proposed_tolerances] == [("Bust", 0.0124), ("Wire 2", 0.05)]
    report = addon.solve.report.failure_report(issue)
    report.model_state = addon.state.changes.present_state(source, False)
    addon.state.reports.store(source, report)
    return source


def tolerances_on(source, value):
    places = read(source.data.vertices, "co", np.float32, 3)
    on = [on_line(1, value)(places[a], places[b]) for a, b in edge_vertices(source.data)]
    return read(source.data.attributes["wirewarp_tolerance"].data, "value", np.float32)[on]


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_the_proposed_tolerances_are_written_and_none_becomes_tighter(loosen, addon, mode):
    bpy.ops.object.mode_set(mode=mode)
    assert take("TOLERANCES") == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    assert np.all(tolerances_on(loosen, 0.0) == np.float32(0.0124))
    assert np.all(tolerances_on(loosen, 0.5) == np.float32(0.2)) and np.all(tolerances_on(loosen, -0.5) == 0)
    wires = report_after(addon, loosen).wires
    assert {wire.name: wire.tolerance for wire in wires} == {"Bust": 0.0124, "Wire 2": 0.2}


def inside(a, b):
    """Return whether an edge is inside a grid, not on its outline."""
    return not any(abs(a[k]) > 1 - 1e-6 and abs(a[k] - b[k]) < 1e-6 for k in (0, 1))


def test_tolerances_of_mirror_images_are_widened_at_once(addon):
    saddles = [grid(name, lambda x, y: (x, y, 0.25 * x * y), size=4, faces="triangles") for name in ("Left", "Right")]
    saddles[1].data.transform(Matrix.Scale(-1, 4, (1, 0, 0)))
    saddles[1].data.flip_normals()
    for target, place in zip(saddles, (-2, 2), strict=True):
        select_only(target)
        mark(target, inside)
        target.data.transform(Matrix.Translation((place, 0, 0)))
    source = joined(*saddles)
    flatten_fails("can be flattened with")
    first, second = addon.state.reports.last_report(source).issues
    assert first.both_sides and first.proposed_tolerances == second.proposed_tolerances
    assert len({wire.name for wire in first.proposed_tolerances}) % 2 == 0
    assert take("TOLERANCES") == {"FINISHED"}
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}


def test_a_wire_that_must_be_free_is_proposed_as_free(addon, tmp_path):
    """Rigid wires over a steep peak contradict one another, whatever the tolerance."""
    source = grid("Peak", lambda x, y: (x, y, 3 * (1 - x * x) * (1 - y * y)), size=6, faces="triangles", wire=inside)
    flatten_fails("can be flattened with", report_path=str(tmp_path / "report.json"))
    (entry,) = json.loads((tmp_path / "report.json").read_text())["objects"]
    (issue,) = entry["issues"]
    assert "inf" in {wire["tolerance"] for wire in issue["proposed_tolerances"]}
    assert take("TOLERANCES") == {"FINISHED"}
    tolerances = read(source.data.attributes["wirewarp_tolerance"].data, "value", np.float32)
    assert math.inf in tolerances


def test_a_cleared_wire_gets_no_tolerance(loosen):
    loosen.data.attributes.remove(loosen.data.attributes["wirewarp_wire"])
    assert take("TOLERANCES") == {"CANCELLED"}
    assert np.all(tolerances_on(loosen, 0.0) == 0)
