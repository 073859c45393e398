# SPDX-License-Identifier: GPL-3.0-or-later
"""Wires are marked and cleared in Edit Mode, and edges that cannot be marked are reported."""

import math

import bmesh
import bpy
import pytest
from flattening import edited, fails, wire_marks
from surfaces import bump, everywhere, flat_of, grid, mark, on_edges, on_line, select_edges, select_only

pytestmark = pytest.mark.api

EAST_WEST, NORTH_SOUTH = on_line(1, 0.0), on_line(0, 0.0)


def names(target):
    return [entry.name for entry in target.data.wirewarp_names]


@pytest.mark.parametrize(
    ("kind", "tolerance", "line"),
    [
        ("RIGID", 0, EAST_WEST),
        ("ELASTIC", 0.05, NORTH_SOUTH),  # on a seam
        ("SUPER_ELASTIC", math.inf, on_line(1, 1.0)),  # on the outline
    ],
)
def test_a_line_becomes_one_wire_of_its_kind(kind, tolerance, line):
    target = grid("Bump", bump, seam=NORTH_SOUTH)
    mark(target, line, kind=kind, tolerance=0.05)
    (((wire, found), count),) = wire_marks(target.data).items()
    assert found == pytest.approx(tolerance, rel=1e-6) and count == 8
    assert 0 < wire < 2**31


@pytest.mark.parametrize("name", ["mark", "clear", "allowance", "ease"])
def test_without_selected_edges_edit_mode_stays(name):
    target = grid("Bump", bump)
    select_edges(target)
    edit = bmesh.from_edit_mesh(target.data)
    try:
        assert getattr(bpy.ops.mesh, f"wirewarp_{name}")() == {"CANCELLED"}
    except RuntimeError as error:
        assert "Nothing to mark" in str(error)
    assert edit.is_valid


@pytest.mark.parametrize("at_once", [True, False])
def test_crossing_lines_are_two_wires_however_they_are_marked(at_once):
    target = grid("Bump", bump)
    target.scale.z = 0
    for lines in [(EAST_WEST, NORTH_SOUTH)] if at_once else [(EAST_WEST,), (NORTH_SOUTH,)]:
        mark(target, *lines)
    assert list(wire_marks(target.data).values()) == [8, 8] and names(target) == ["Wire 1", "Wire 2"]


def test_marking_a_whole_wire_again_changes_its_kind_and_keeps_its_id_and_name():
    target = grid("Bump", bump)
    mark(target, EAST_WEST, NORTH_SOUTH)
    target.data.wirewarp_names[0].name = "Bust"
    before = {wire for wire, _ in wire_marks(target.data)}
    mark(target, EAST_WEST, NORTH_SOUTH, kind="SUPER_ELASTIC")
    assert {wire for wire, _ in wire_marks(target.data)} == before
    assert sorted(names(target)) == ["Bust", "Wire 2"]


def test_marking_a_part_of_a_wire_makes_a_wire_of_its_own():
    target = grid("Bump", bump, wire=EAST_WEST)
    mark(target, lambda a, b: EAST_WEST(a, b) and a.x + b.x > 0, kind="ELASTIC")
    assert sorted(wire_marks(target.data).values()) == [4, 4]
    assert len({wire for wire, _ in wire_marks(target.data)}) == 2


def test_clear_removes_the_marks_and_the_name():
    target = grid("Bump", bump)
    mark(target, EAST_WEST, NORTH_SOUTH)
    assert on_edges(target, bpy.ops.mesh.wirewarp_clear, EAST_WEST) == {"FINISHED"}
    assert list(wire_marks(target.data).values()) == [8] and len(names(target)) == 1
    select_edges(target, on_line(1, 0.5))
    assert bpy.ops.mesh.wirewarp_clear() == {"CANCELLED"}


def two_in_edit_mode(line):
    targets = [grid("First", bump), grid("Second", bump)]
    for target in targets:
        select_edges(target, line)
        bpy.ops.object.mode_set(mode="OBJECT")
    select_only(*targets)
    bpy.ops.object.mode_set(mode="EDIT")
    return targets


@pytest.mark.parametrize("operator", ["mark", "clear"])
def test_all_or_none_of_several_objects_are_marked(operator):
    first, second = two_in_edit_mode(EAST_WEST)
    bpy.ops.mesh.wirewarp_mark()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert [list(wire_marks(target.data).values()) for target in (first, second)] == [[8], [8]]
    assert set(wire_marks(first.data)) != set(wire_marks(second.data))
    second.data.attributes.remove(second.data.attributes["wirewarp_wire"])
    second.data.attributes.new("wirewarp_wire", "FLOAT", "EDGE")
    before = wire_marks(first.data)
    bpy.ops.object.mode_set(mode="EDIT")
    settings = {"kind": "SUPER_ELASTIC"} if operator == "mark" else {}
    fails(getattr(bpy.ops.mesh, f"wirewarp_{operator}"), 'attribute "wirewarp_wire" of mesh "Second"', **settings)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert wire_marks(first.data) == before


@pytest.mark.parametrize(
    ("lines", "settings", "said"),
    [
        ([], {}, "select the edges of the wire first"),
        ([EAST_WEST], {"kind": "ELASTIC", "tolerance": 0.0}, "needs a tolerance above 0"),
        ([EAST_WEST], {"kind": "ELASTIC", "tolerance": math.nan}, "needs a tolerance above 0"),
    ],
)
def test_edges_that_cannot_be_marked_are_reported(lines, settings, said):
    target = grid("Bump", bump)
    select_edges(target, *lines)
    fails(bpy.ops.mesh.wirewarp_mark, said, **settings)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert wire_marks(target.data) == {}


def test_an_edge_without_a_face_is_not_marked_and_a_marked_one_is_ignored(addon):
    target = grid("Bump", bump)
    with edited(target.data) as edit:
        edit.edges.new([edit.verts.new((x, 0, 0)) for x in (3, 4)])
    select_edges(target, EAST_WEST)
    fails(bpy.ops.mesh.wirewarp_mark, '1 selected edge of "Bump" has no face.*Delete Loose')
    bpy.ops.object.mode_set(mode="OBJECT")
    assert wire_marks(target.data) == {}
    mark(target, lambda a, b: EAST_WEST(a, b) and a.x < 2)
    target.data.attributes["wirewarp_wire"].data[len(target.data.edges) - 1].value = 5
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    report = addon.state.reports.last_report(target)
    assert [wire.name for wire in report.wires] == ["Wire 1"]
    (note,) = report.notes
    assert note.text == "1 marked edge has no face and was ignored."


@pytest.mark.parametrize("command", ["mark", "clear", "seams_from_uv_islands", "smooth_seam"])
def test_marks_of_models_are_refused_on_flat_pieces(command):
    source = grid("Bump", bump)
    select_only(source)
    bpy.ops.object.wirewarp_flatten()
    flat = flat_of(source)
    select_edges(flat, everywhere)
    before = wire_marks(flat.data)
    fails(getattr(bpy.ops.mesh, f"wirewarp_{command}"), "These are flat pieces: .* on the model")
    assert wire_marks(flat.data) == before
    bpy.ops.object.mode_set(mode="OBJECT")
    select_only(source, flat)
    bpy.ops.object.mode_set(mode="EDIT")
    fails(bpy.ops.mesh.wirewarp_mark, "Leave Edit Mode of the flat pieces first")


def test_mark_this_model_starts_with_nothing_selected(addon):
    """After an import, all edges are selected. Mark This Model clears such a selection, but keeps other selections."""
    source = grid("Bump", bump, size=4)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    assert addon.marks.mark_operators.has_every_edge(source.data)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert bpy.ops.object.wirewarp_mark_model() == {"FINISHED"}
    assert source.mode == "EDIT" and tuple(bpy.context.tool_settings.mesh_select_mode) == (False, True, False)
    assert not any(edge.select for edge in bmesh.from_edit_mesh(source.data).edges)
    bpy.ops.object.mode_set(mode="OBJECT")
    source.data.edges[3].select = True
    bpy.ops.object.wirewarp_mark_model()
    chosen = [edge.index for edge in bmesh.from_edit_mesh(source.data).edges if edge.select]
    assert chosen == [3]
    assert not addon.marks.mark_operators.has_every_edge(source.data)
    assert bpy.ops.mesh.wirewarp_mark_seam() == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    assert [edge.index for edge in source.data.edges if edge.use_seam] == [3]
