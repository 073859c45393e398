# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams and outlines that give or are eased, on all their sides or on one: marked, flattened, and cleared again."""

import bpy
import numpy as np
import pytest
from surfaces import grid, mark, on_line, read, select_edges, select_only
from two_sided import HEM, SEAM, ease, lengths, shares, two_pieces


@pytest.fixture
def source():
    return two_pieces()


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
    ((name, wire),) = addon.state.identities.listed_wires(source)
    bpy.ops.mesh.wirewarp_change_wire(edge=wire.edges[0], name=name, kind="ELASTIC", tolerance=0.01)
    ((_, kept),) = addon.state.identities.listed_wires(source)
    assert (kept.tolerance, kept.ease) == (0.01, 0.02)
    bpy.ops.mesh.wirewarp_change_wire(edge=wire.edges[0], kind="RIGID", ease=-0.05)
    ((_, changed),) = addon.state.identities.listed_wires(source)
    assert (changed.tolerance, changed.ease) == (0, -0.05)


def test_an_ease_of_edges_that_are_no_wires_is_told(source, addon):
    values = source.data.attributes.new("wirewarp_ease", "FLOAT", "EDGE")
    for edge in source.data.edges[:3]:
        values.data[edge.index].value = 0.05
    bpy.ops.object.wirewarp_flatten()
    told = "3 edges have an ease but are not wires: it was not used. Mark them with Ease."
    assert addon.core.Note(told, is_warning=True) in addon.state.reports.last_report(source).notes
    ease(source, lambda *_: True, sides="NONE")
    bpy.ops.object.wirewarp_flatten()
    assert addon.state.reports.last_report(source).notes == []


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


def test_an_ease_is_a_change_that_the_report_sees(source, addon):
    bpy.ops.object.wirewarp_flatten()
    report, has_changed = addon.state.reports.last_report(source), addon.state.changes.has_changed
    assert not has_changed(source, report.model_state)
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    assert has_changed(source, report.model_state)
    ease(source, SEAM, sides="NONE")
    assert not has_changed(source, report.model_state)
    ease(source, SEAM, sides="ALL", ease_percent=5.0)
    assert has_changed(source, report.model_state)
