# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams and outlines that give or are eased: marked, flattened, told, and cleared again."""

import bmesh
import bpy
import numpy as np
import pytest
from surfaces import bump, edge_vertices, flat_of, grid, mark, mark_seam, on_line, read, select_edges, select_only

SEAM, HEM = on_line(0, 0.0), on_line(1, -1.0)


@pytest.fixture
def source():
    """Two pieces, left and right of a seam; a Blender unit is 100 mm."""
    bpy.context.scene.unit_settings.scale_length = 0.1
    target = grid("Bump", bump)
    mark_seam(target, SEAM)
    return target


def ease(target, line, **settings):
    select_edges(target, line)
    assert bpy.ops.mesh.wirewarp_ease(**settings) == {"FINISHED"}
    assert target.mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")


def lengths(source, line):
    """Of the line on the model, and of it on the left and on the right piece; two equal ones inside of a piece."""
    flat = flat_of(source).data
    model = read(source.data.vertices, "co", np.float32, 3).astype(float)
    sources = read(flat.attributes["source_vertex"].data, "value", np.int32)
    pieces = np.empty(len(flat.vertices), dtype=int)
    faces = read(flat.attributes["source_face"].data, "value", np.int32)
    for polygon, face in zip(flat.polygons, faces, strict=True):
        pieces[list(polygon.vertices)] = source.data.polygons[face].center.x > 0
    flat_places = read(flat.vertices, "co", np.float32, 3).astype(float)
    found = [0.0, 0.0]
    for a, b in edge_vertices(flat):
        if line(model[sources[a]], model[sources[b]]):
            found[pieces[a]] += float(np.linalg.norm(flat_places[a] - flat_places[b]))
    spatial = [np.linalg.norm(model[a] - model[b]) for a, b in edge_vertices(source.data) if line(model[a], model[b])]
    return float(sum(spatial)), *found


def shares(source, line=SEAM):
    """By how much the left and the right side are longer than the line on the model."""
    spatial, left, right = lengths(source, line)
    return [left / spatial - 1, right / spatial - 1]


def test_a_seam_that_gives_has_one_length_on_both_sides(source):
    mark(source, SEAM, kind="ELASTIC", tolerance=0.03)
    bpy.ops.object.wirewarp_flatten()
    left, right = shares(source)
    assert left == pytest.approx(right, abs=1e-5)
    assert 1e-4 < abs(left) <= 0.03 + 1e-6


def test_all_sides_of_a_seam_are_eased_alike_in_percent_or_millimeters(source):
    ease(source, SEAM, sides="ALL", ease_percent=-4.0)
    bpy.ops.object.wirewarp_flatten()
    assert shares(source) == pytest.approx([-0.04, -0.04], abs=1e-5)
    ease(source, SEAM, sides="ALL", ease_unit="LENGTH", ease_length=12.0)
    bpy.ops.object.wirewarp_flatten()
    spatial, left, right = lengths(source, SEAM)
    assert [100 * (left - spatial), 100 * (right - spatial)] == pytest.approx([12.0, 12.0], abs=1e-3)


def test_one_side_or_the_other_is_eased(source):
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    bpy.ops.object.wirewarp_flatten()
    one = shares(source)
    assert sorted(one) == pytest.approx([0.0, 0.05], abs=1e-5)
    ease(source, SEAM, sides="OTHER", ease_percent=5.0)
    bpy.ops.object.wirewarp_flatten()
    assert shares(source) == pytest.approx(one[::-1], abs=1e-5)


def test_the_millimeters_of_a_side_are_of_what_it_would_be(source):
    ease(source, SEAM, sides="ALL", ease_percent=-10.0)
    ease(source, SEAM, sides="ONE", ease_unit="LENGTH", ease_length=12.0)
    bpy.ops.object.wirewarp_flatten()
    _, left, right = lengths(source, SEAM)
    assert 100 * abs(left - right) == pytest.approx(12.0, abs=1e-3)
    assert min(shares(source)) == pytest.approx(-0.1, abs=1e-5)


def test_an_outline_and_a_wire_inside_are_eased(source):
    ease(source, HEM, sides="OTHER", ease_percent=3.0)  # an outline has one side
    ease(source, on_line(1, 0.0), sides="ALL", ease_percent=2.0)
    bpy.ops.object.wirewarp_flatten()
    for line, ratio in ((HEM, 0.03), (on_line(1, 0.0), 0.02)):
        spatial, left, right = lengths(source, line)
        assert left + right == pytest.approx((1 + ratio) * spatial, rel=1e-5)


def test_clearing_takes_every_ease_away(source):
    ease(source, SEAM, sides="ALL", ease_percent=2.0)
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    ease(source, SEAM, sides="NONE")
    bpy.ops.object.wirewarp_flatten()
    assert shares(source) == pytest.approx([0.0, 0.0], abs=1e-5)
    select_edges(source, SEAM)
    with pytest.raises(RuntimeError, match="none of the selected edges has an ease"):
        bpy.ops.mesh.wirewarp_ease(sides="NONE")


def test_clearing_a_wire_takes_its_ease_and_a_new_wire_has_none(source):
    ease(source, SEAM, sides="ALL", ease_percent=2.0)
    mark(source, SEAM, kind="ELASTIC", tolerance=0.01)  # the same wire
    assert set(read(source.data.attributes["wirewarp_ease"].data, "value", np.float32)) == {0, np.float32(0.02)}
    select_edges(source, SEAM)
    bpy.ops.mesh.wirewarp_clear()
    mark(source, SEAM)
    assert not read(source.data.attributes["wirewarp_ease"].data, "value", np.float32).any()


def test_a_part_of_a_line_that_is_marked_keeps_its_ease(source, capfd):
    def upper_half(a, b):
        return SEAM(a, b) and a[1] + b[1] > 0

    ease(source, SEAM, sides="ALL", ease_percent=2.0)
    mark(source, upper_half, kind="ELASTIC", tolerance=0.01)
    eases = read(source.data.attributes["wirewarp_ease"].data, "value", np.float32)
    assert np.count_nonzero(eases == np.float32(0.02)) == 8
    assert "several eases" not in capfd.readouterr().out
    ease(source, upper_half, sides="ALL", ease_percent=5.0)
    mark(source, SEAM)
    assert "1 wire marked. 1 wire had several eases: mark the ease again." in capfd.readouterr().out
    assert not read(source.data.attributes["wirewarp_ease"].data, "value", np.float32).any()


def test_the_list_of_wires_changes_an_ease_and_keeps_it(source, addon):
    ease(source, SEAM, sides="ALL", ease_percent=2.0)
    ((name, wire),) = addon.model.wires.listed_wires(source)
    bpy.ops.mesh.wirewarp_change_wire(edge=wire.edges[0], name=name, kind="ELASTIC", tolerance=0.01)
    ((_, kept),) = addon.model.wires.listed_wires(source)
    assert (kept.tolerance, kept.ease) == (0.01, 0.02)
    bpy.ops.mesh.wirewarp_change_wire(edge=wire.edges[0], kind="RIGID", ease=-0.05)
    ((_, changed),) = addon.model.wires.listed_wires(source)
    assert (changed.tolerance, changed.ease) == (0, -0.05)


def test_the_side_that_is_eased_survives_what_wires_survive(source):
    """Splitting edges, turning faces over, joining, a mirrored object and modifiers."""
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    bpy.ops.object.wirewarp_flatten()
    before = shares(source)
    other = grid("Other", lambda x, y: (x + 3, y, 0))
    select_only(source, other)
    bpy.context.view_layer.objects.active = source
    bpy.ops.object.join()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide(number_cuts=2)
    bpy.ops.mesh.flip_normals()
    bpy.ops.object.mode_set(mode="OBJECT")
    source.scale.x = -1
    bpy.ops.object.wirewarp_flatten()
    assert shares(source) == pytest.approx(before, abs=1e-5)


def select_side(source, side, line=SEAM):
    """Edit Mode of the pieces, the line selected on the one left (-1) or right (1) of the seam; 0: on both."""
    flat = flat_of(source)
    model = read(source.data.vertices, "co", np.float32, 3)
    sources = read(flat.data.attributes["source_vertex"].data, "value", np.int32)
    faces = read(flat.data.attributes["source_face"].data, "value", np.int32)
    select_only(flat)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.tool_settings.mesh_select_mode = (False, True, False)
    bpy.ops.mesh.select_all(action="DESELECT")
    edit = bmesh.from_edit_mesh(flat.data)
    for edge in edit.edges:
        on_side = source.data.polygons[faces[edge.link_faces[0].index]].center.x * side >= 0
        edge.select_set(bool(on_side and line(*(model[sources[vertex.index]] for vertex in edge.verts))))
    bmesh.update_edit_mesh(flat.data)


@pytest.mark.parametrize(("side", "expected"), [(-1, [0.05, 0.0]), (1, [0.0, 0.05])])
def test_on_flat_pieces_the_selected_side_is_eased(source, side, expected):
    bpy.ops.object.wirewarp_flatten()
    select_side(source, side)
    assert bpy.ops.mesh.wirewarp_ease(sides="ONE", ease_percent=5.0) == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    select_only(source)
    bpy.ops.object.wirewarp_flatten()
    assert shares(source) == pytest.approx(expected, abs=1e-5)


def test_both_sides_at_once_on_flat_pieces_are_refused(source):
    bpy.ops.object.wirewarp_flatten()
    select_side(source, 0)
    with pytest.raises(RuntimeError, match="Both sides of a seam are selected"):
        bpy.ops.mesh.wirewarp_ease(sides="ONE", ease_percent=5.0)


@pytest.mark.parametrize("sides", ["ALL", "OTHER"])
def test_on_flat_pieces_no_side_but_the_selected_one_is_eased(source, sides):
    bpy.ops.object.wirewarp_flatten()
    select_side(source, -1)
    with pytest.raises(RuntimeError, match="One Side eases the selected one"):
        bpy.ops.mesh.wirewarp_ease(sides=sides, ease_percent=5.0)
    assert "wirewarp_side_ratio" not in source.data.attributes


def test_a_line_of_which_both_sides_are_cleared_on_flat_pieces_counts_once(source, capfd):
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    bpy.ops.object.wirewarp_flatten()
    select_side(source, 0)
    assert bpy.ops.mesh.wirewarp_ease(sides="NONE") == {"FINISHED"}
    assert "No ease any more on 1 line\n" in capfd.readouterr().out


def write_corners(source, values):
    """values: by the sign of the side's place; on the corners at which edges of the seam begin."""
    sides = source.data.attributes.get("wirewarp_side_ease") or source.data.attributes.new(
        "wirewarp_side_ease", "FLOAT", "CORNER"
    )
    places = read(source.data.vertices, "co", np.float32, 3)
    for polygon in source.data.polygons:
        for corner, vertex, following in zip(
            polygon.loop_indices, polygon.vertices, [*polygon.vertices[1:], polygon.vertices[0]], strict=True
        ):
            if SEAM(places[vertex], places[following]):
                sides.data[corner].value = values[polygon.center.x > 0]


def test_scripts_may_write_the_eases_of_sides_on_corners(source):
    write_corners(source, [0.05, 0.02])
    bpy.ops.object.wirewarp_flatten()
    assert shares(source) == pytest.approx([0.05, 0.02], abs=1e-5)
    source.scale.x = -1
    bpy.ops.object.wirewarp_flatten()
    assert shares(source) == pytest.approx([0.05, 0.02], abs=1e-5)


def test_two_eases_of_one_side_are_told_with_their_edges(source, addon):
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    write_corners(source, [0.02, 0.02])
    with pytest.raises(RuntimeError, match='Edges of "Bump" have two eases of one side.*mark their ease again'):
        bpy.ops.object.wirewarp_flatten()
    (issue,) = addon.flat.reports.last_report(source)["issues"]
    assert len(issue["edges"]) == 8
    mark(source, HEM)  # which goes on as ever
    ease(source, SEAM, sides="ONE", ease_percent=5.0)  # which takes the other away
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}


def test_an_ease_where_no_side_is_names_its_edges(source, addon):
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    select_edges(source, lambda a, b: SEAM(a, b) and a.y + b.y > 1)
    bpy.ops.mesh.mark_seam(clear=True)
    bpy.ops.object.mode_set(mode="OBJECT")
    with pytest.raises(RuntimeError, match="An ease names"):
        bpy.ops.object.wirewarp_flatten()
    (issue,) = addon.flat.reports.last_report(source)["issues"]
    assert issue["code"] == "ease_without_side"
    assert len(issue["edges"]) == 2


@pytest.mark.parametrize("value", [-1.0, float("nan"), float("inf")])
@pytest.mark.parametrize("name", ["wirewarp_ease", "wirewarp_side_ease"])
def test_an_ease_that_is_none_names_its_wire_or_its_edges(source, addon, name, value):
    mark(source, HEM)
    if name == "wirewarp_ease":
        values = source.data.attributes.new(name, "FLOAT", "EDGE")
        for edge in source.data.edges:
            values.data[edge.index].value = value
    else:
        write_corners(source, [value, 0.0])
    wire, side = 'Wire "Wire 1" has an invalid ease', "ease of one side is invalid along 8 edges"
    with pytest.raises(RuntimeError, match=wire if name == "wirewarp_ease" else side):
        bpy.ops.object.wirewarp_flatten()
    (issue,) = addon.flat.reports.last_report(source)["issues"]
    assert len(issue["edges"]) == 8


def test_an_ease_of_edges_that_are_no_wires_is_told(source, addon):
    values = source.data.attributes.new("wirewarp_ease", "FLOAT", "EDGE")
    for edge in source.data.edges[:3]:
        values.data[edge.index].value = 0.05
    bpy.ops.object.wirewarp_flatten()
    told = "3 edges have an ease but are no wires: it was not used. Mark them with Ease."
    assert {"text": told, "is_warning": True} in addon.flat.reports.last_report(source)["notes"]
    ease(source, lambda *_: True, sides="NONE")
    bpy.ops.object.wirewarp_flatten()
    assert addon.flat.reports.last_report(source)["notes"] == []


@pytest.mark.parametrize("name", ["wirewarp_ease", "wirewarp_side_ease", "wirewarp_side_ratio", "wirewarp_eased_side"])
def test_an_attribute_of_our_name_that_is_not_ours_is_a_sentence(source, name):
    source.data.attributes.new(name, "FLOAT_VECTOR", "POINT")
    told = f'attribute "{name}" of mesh "Bump" is not of type'
    with pytest.raises(RuntimeError, match=told):
        bpy.ops.object.wirewarp_flatten()
    select_edges(source, SEAM)
    with pytest.raises(RuntimeError, match=told):
        bpy.ops.mesh.wirewarp_ease(sides="ALL" if name == "wirewarp_ease" else "ONE")
    assert source.mode == "EDIT"


def test_too_short_an_ease_marks_nothing(source):
    select_edges(source, SEAM)
    with pytest.raises(RuntimeError, match="would have no length left"):
        bpy.ops.mesh.wirewarp_ease(sides="ALL", ease_unit="LENGTH", ease_length=-1e6)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert "wirewarp_wire" not in source.data.attributes


def select_all_edges(*targets):
    select_only(*targets)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.tool_settings.mesh_select_mode = (False, True, False)
    bpy.ops.mesh.select_all(action="SELECT")


@pytest.mark.parametrize("sides", ["ALL", "ONE"])
def test_of_two_objects_none_is_marked_where_one_is_refused(source, sides):
    """The outline of the small one is 40 mm long, that of the large one 800 mm."""
    small = grid("Small", lambda x, y: (0.05 * x + 3, 0.05 * y, 0), size=1)
    large = grid("Large", lambda x, y: (x + 6, y, 0), size=1)
    for targets in ((large, small), (small, large)):
        select_all_edges(*targets)
        with pytest.raises(RuntimeError, match="would have no length left"):
            bpy.ops.mesh.wirewarp_ease(sides=sides, ease_unit="LENGTH", ease_length=-50.0)
        bpy.ops.object.mode_set(mode="OBJECT")
        assert not any(name.startswith("wirewarp") for target in targets for name, _ in target.data.attributes.items())


def test_edges_without_a_side_are_left_out_and_counted(source, capfd):
    select_edges(source, SEAM, on_line(1, 0.0))
    assert bpy.ops.mesh.wirewarp_ease(sides="ONE", ease_percent=5.0) == {"FINISHED"}
    assert "1 line eased: +5%" in (told := capfd.readouterr().out) and "8 selected edges left out" in told
    bpy.ops.object.mode_set(mode="OBJECT")
    select_edges(source, on_line(1, 0.0))
    with pytest.raises(RuntimeError, match="select edges on a seam or outline"):
        bpy.ops.mesh.wirewarp_ease(sides="ONE", ease_percent=5.0)


def test_the_report_says_which_side_is_longer_and_what_to_do(source, addon):
    bpy.context.scene.unit_settings.length_unit = "MILLIMETERS"
    for ratio, how in ((5.0, "ease"), (40.0, "gather")):
        ease(source, SEAM, sides="ONE", ease_percent=ratio)
        bpy.ops.object.wirewarp_flatten()
        report = addon.flat.reports.last_report(source)
        (row,), units = addon.report.rows.seam_rows(report), addon.blender.units.length_text(bpy.context.scene)
        (side,) = row.eased
        left, right = shares(source)
        assert side.ease == pytest.approx(max(left, right), abs=1e-5) and row.ok
        spatial, *_ = lengths(source, SEAM)
        longer = units.rough(ratio / 100 * spatial)
        assert addon.report.eases.longer_text(side, units) == f"{side.label} {longer} longer, {how} between notches"
        assert side.label == ("Top Right" if left > right else "Top Left")  # on its wearer the left is at +x
        assert abs(addon.report.rows.largest_difference([row])) < 1e-6  # nothing that was not asked for
        assert f"{ratio:.6f}" in addon.report.csv_table.report_csv(report, units)


def test_the_list_of_seams_says_how_much_all_sides_give(source, addon):
    mark(source, SEAM, kind="ELASTIC", tolerance=0.03)
    bpy.ops.object.wirewarp_flatten()
    (row,) = addon.report.rows.seam_rows(addon.flat.reports.last_report(source))
    left, _ = shares(source)
    assert row.note.endswith(f"; {addon.words.ease_text(left)} on all sides")


def arrow(addon, target):
    """From the edge to the tip; and what is written there."""
    lines = addon.overlay.objects.marked_lines(target, bpy.context.evaluated_depsgraph_get())
    tail, tip, *_ = lines.places["ease"]
    return tail, tip, [name.texts for name in lines.names]


def test_an_arrow_points_into_the_side_that_is_longer(source, addon):
    for sides in ("ONE", "OTHER"):
        ease(source, SEAM, sides=sides, ease_percent=5.0)
        bpy.ops.object.wirewarp_flatten()
        left, right = shares(source)
        tail, tip, texts = arrow(addon, source)
        assert tail[0] == pytest.approx(0.0, abs=1e-6) and (tip[0] > 0) == (right > left)
        assert ("+5%",) in texts
        *_, texts = arrow(addon, flat_of(source))
        assert ("+5%",) in texts
    ease(source, SEAM, sides="NONE")
    lines = addon.overlay.objects.marked_lines(source, bpy.context.evaluated_depsgraph_get())
    assert "ease" not in lines.places


def test_an_ease_is_a_change_that_the_report_sees(source, addon):
    bpy.ops.object.wirewarp_flatten()
    report, has_changed = addon.flat.reports.last_report(source), addon.model.state.has_changed
    assert not has_changed(source, report)
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    assert has_changed(source, report)
    ease(source, SEAM, sides="NONE")
    assert not has_changed(source, report)
    ease(source, SEAM, sides="ALL", ease_percent=5.0)
    assert has_changed(source, report)
