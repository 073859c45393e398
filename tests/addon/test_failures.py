# SPDX-License-Identifier: GPL-3.0-or-later
"""If some pieces fail, the other pieces are written, the report names the faults, and failed pieces are red."""

import json
import math
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from drawing import Drawing
from flattening import fails, flatten_fails, uv_of
from surfaces import bump, flat_of, grid, make_object, mark, on_line, read, select_only

CUBE = (
    [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)],
    [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)],
)


def cube(name="Cube"):
    return make_object(name, *CUBE)


def bump_and_cube():
    """Return a model with two parts. One can be flattened, the other is closed."""
    source = grid("Both", bump)
    other = cube()
    select_only(source, other)
    bpy.ops.object.join()
    return source


def test_other_pieces_are_written_if_one_is_bad(tmp_path):
    source = bump_and_cube()
    flatten_fails("Both, Left: .*choose where to cut it", report_path=str(tmp_path / "r.json"))
    faces = read(flat_of(source).data.attributes["piece"].data, "value", np.int32)
    assert (len(faces), set(faces)) == (64, {0})
    starts = read(source.data.polygons, "loop_start", np.int32)
    assert np.all(uv_of(source.data)[starts[64] :] == 0) and uv_of(source.data).max() == 1
    (entry,) = json.loads((tmp_path / "r.json").read_text())["objects"]
    assert [piece["ok"] for piece in entry["pieces"]] == [True, False]
    assert [(issue["code"], issue["piece"]) for issue in entry["issues"]] == [("closed_chart", 1)]
    assert (entry["ok"], entry["flat_object"]) == (False, "Both Flat")


@pytest.mark.parametrize("is_alone", [False, True])
def test_only_the_report_is_written_for_an_object_without_a_good_piece(tmp_path, is_alone):
    others = [] if is_alone else [grid("Good", bump)]
    bad = cube("Bad")
    select_only(*others, bad)
    flatten_fails("Error: Bad: ", report_path=str(tmp_path / "report.json"))
    assert [len(flat_of(each).data.polygons) for each in others] == [64] * len(others)
    assert "wirewarp_report" not in bad and not bad.data.uv_layers
    assert {*bpy.data.objects} == {bad, *others, *map(flat_of, others)}
    report = json.loads((tmp_path / "report.json").read_text())
    (entry,) = (each for each in report["objects"] if each["object"] == "Bad")
    assert not report["ok"] and entry["issues"][0]["code"] == "closed_chart"


def test_select_issues_selects_the_elements_of_the_error():
    def selected(elements):
        bpy.ops.mesh.wirewarp_select_issues()
        assert bpy.context.mode == "EDIT_MESH"
        bpy.ops.object.mode_set(mode="OBJECT")
        return set(np.flatnonzero(read(getattr(source.data, elements), "select", bool)))

    source = grid("Bump", bump, wire=on_line(1, 0.0))
    source.data.attributes["wirewarp_tolerance"].data.foreach_set("value", [math.nan] * len(source.data.edges))
    flatten_fails("tolerance")
    assert selected("vertices") == {v.index for v in source.data.vertices if abs(v.co.y) < 1e-6}
    source = bump_and_cube()
    source.data.vertices[0].co = source.data.vertices[1].co
    flatten_fails("Both, Top: 1 face has no area")
    select_only(source)
    assert 0 in selected("polygons")


def test_select_issues_without_issues_selects_nothing():
    grid("Bump", bump)
    fails(bpy.ops.mesh.wirewarp_select_issues, "has not been flattened yet")
    bpy.ops.object.wirewarp_flatten()
    assert bpy.ops.mesh.wirewarp_select_issues() == {"CANCELLED"}
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide()
    fails(bpy.ops.mesh.wirewarp_select_issues, '"Bump" has changed since it was flattened')


def test_flipped_and_overlapping_faces_are_counted_and_selected_as_faces(addon):
    source = grid("Bump", bump)
    arrays = addon.state.read_model.object_to_arrays(source, addon.state.marked_mesh.marked_mesh(source), None)
    # Triangles 10 and 11 are face 5 of the grid, and triangle 12 is a half of face 6. Triangles 20 and 21 are face 10.
    arguments = {"num_overlapping": 2, "has_wires": False}
    flips = {"faces": [10, 11, 12], "has_layout": True, "arguments": arguments}
    error = addon.core.library().FlattenError("flipped_faces", "The library's sentence.", **flips)
    metrics = SimpleNamespace(flipped_faces=[10, 11, 12], overlapping_faces=[20, 21])
    piece = SimpleNamespace(error=error, source_face=np.arange(128), metrics=metrics)
    issue = addon.solve.flatten.issue_of_piece(piece, 0, arrays)
    assert issue.sentence == (
        "The piece is flipped at 2 faces, and overlaps itself at 1 face. Add a seam or a dart there."
    )
    assert issue.faces == [5, 6, 10]


@pytest.fixture
def half_failed():
    """Return a model of two pieces after a run of WireWarping.

    One piece is good. The other is a steep spike, on which a cross of rigid wires makes WireWarping flip faces.
    """
    target, other = grid("Both", bump), grid("Spike", lambda x, y: (x + 3, y, 2 * (1 - x * x) * (1 - y * y)))
    mark(other, on_line(0, 3.0), on_line(1, 0.0))
    select_only(target, other)
    bpy.ops.object.join()
    flatten_fails("Both, Top Left: The piece is flipped", method="WIREWARPING")
    return target


def red_pieces(source):
    flat = flat_of(source).data
    slots = read(flat.polygons, "material_index", np.int32)
    red = [i for i, material in enumerate(flat.materials) if material and material.name == "WireWarp Failed Piece"]
    return set(read(flat.attributes["piece"].data, "value", np.int32)[np.isin(slots, red)])


def test_only_the_failed_piece_is_red_and_materials_of_the_user_stay(half_failed, addon):
    assert [piece.has_layout for piece in addon.state.reports.last_report(half_failed).pieces] == [True, True]
    assert red_pieces(half_failed) == {1}
    flat, mesh = flat_of(half_failed).data, half_failed.data
    assert len(flat.materials) == 2
    flat.materials[0] = bpy.data.materials.new("Felt")
    flatten_fails("Both, Top Left: The piece is flipped", method="WIREWARPING")
    assert [material.name for material in flat.materials] == ["Felt", "WireWarp Failed Piece"]
    assert red_pieces(half_failed) == {1}
    mesh.attributes.remove(mesh.attributes["wirewarp_wire"])
    places = read(mesh.vertices, "co", np.float32, 3)
    places[81:, 2] *= 0.05
    mesh.vertices.foreach_set("co", places.ravel())
    bpy.ops.object.wirewarp_flatten()
    assert red_pieces(half_failed) == set()
    assert "WireWarp Failed Piece" not in flat.materials


def test_failed_pieces_are_written_only_on_request(half_failed, tmp_path):
    path = tmp_path / "pattern.svg"
    fails(bpy.ops.object.wirewarp_export_svg, "Failed: Top Left. The report names the faults", filepath=str(path))
    assert not path.exists()
    bpy.ops.object.wirewarp_export_svg(filepath=str(path), failed_pieces=True)
    assert set(Drawing(path).pieces) == {"Top Left", "Top Right"}
