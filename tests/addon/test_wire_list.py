# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of wires shows all marked wires, and changes their names, kinds and tolerances."""

import math

import bpy
import numpy as np
import pytest
from everything import AnyLayout, draw_panels, drawn_buttons, sidebar
from flattening import fails, notify, report_after, wire_marks
from surfaces import bump, everywhere, grid, mark, on_edges, on_line, read, select_edges, select_only

pytestmark = pytest.mark.api

EAST_WEST, NORTH_SOUTH = on_line(1, 0.0), on_line(0, 0.0)


@pytest.fixture
def source():
    """Return a model with two crossing wires: Bust (rigid) and Middle (elastic)."""
    target = grid("Bump", bump, wire=EAST_WEST)
    mark(target, NORTH_SOUTH, kind="ELASTIC", tolerance=0.05)
    for entry, name in zip(target.data.wirewarp_names, ("Bust", "Middle"), strict=True):
        entry.name = name
    return target


def listed(addon, target):
    """Return the name, tolerance and number of edges of each entry."""
    bpy.context.view_layer.update()
    return [(name, wire.tolerance, len(wire.edges)) for name, wire in addon.state.identities.listed_wires(target)]


def edge_of(addon, target, wanted):
    return next(wire.edges[0] for name, wire in addon.state.identities.listed_wires(target) if name == wanted)


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_names_kinds_and_tolerances_are_changed_from_the_list(addon, source, mode):
    select_only(source)
    bpy.ops.object.mode_set(mode=mode)
    edge = edge_of(addon, source, "Bust")
    change = bpy.ops.mesh.wirewarp_change_wire
    assert change(edge=edge, name="Waist", kind="ELASTIC", tolerance=0.02) == {"FINISHED"}
    assert listed(addon, source) == [("Waist", 0.02, 8), ("Middle", 0.05, 8)]
    assert change(edge=edge, kind="SUPER_ELASTIC") == {"FINISHED"}
    assert listed(addon, source) == [("Waist", math.inf, 8), ("Middle", 0.05, 8)]
    # The dialog has the tolerance in percent.
    assert change(edge=edge, kind="ELASTIC", tolerance_percent=2.5) == {"FINISHED"}
    assert listed(addon, source)[0] == ("Waist", pytest.approx(0.025, rel=1e-6), 8)
    fails(change, "needs a tolerance above 0", edge=edge, kind="ELASTIC", tolerance=0)
    assert source.mode == mode


def test_a_wire_without_its_middle_becomes_two(addon, source):
    on_edges(source, bpy.ops.mesh.wirewarp_clear, lambda a, b: EAST_WEST(a, b) and abs(a.x + b.x) < 1)
    assert listed(addon, source) == [("Bust", 0, 2), ("Middle", 0.05, 8), ("Bust (2)", 0, 2)]
    assert [entry.name for entry in source.data.wirewarp_names] == ["Bust", "Middle", "Bust (2)"]
    assert len(wire_marks(source.data)) == 3
    on_edges(source, bpy.ops.mesh.delete, EAST_WEST, type="EDGE")
    assert listed(addon, source) == [("Middle", 0.05, 8)]


def test_one_id_with_two_tolerances_is_two_wires_and_both_keep_their_tolerances(addon, source):
    rows = [row for row, ends in enumerate(ends_of(source)) if EAST_WEST(*ends) and ends[0].x + ends[1].x > 0]
    for row in rows:
        source.data.attributes["wirewarp_tolerance"].data[row].value = 0.1
    source.data.update()
    before = listed(addon, source)
    assert sorted(name for name, _, _ in before) == ["Bust", "Bust (2)", "Middle"]
    assert sorted((tolerance, count) for _, tolerance, count in before) == [(0, 4), (0.05, 8), (0.1, 4)]
    assert len({wire for wire, _ in wire_marks(source.data)}) == 2
    mark(source, on_line(1, 0.5))  # Marking any line repairs the ids of all wires.
    assert sorted(listed(addon, source)) == sorted([*before, ("Wire 4", 0, 8)])
    assert len({wire for wire, _ in wire_marks(source.data)}) == 4


def ends_of(target):
    return [tuple(target.data.vertices[v].co for v in edge.vertices) for edge in target.data.edges]


def test_a_wire_that_was_copied_is_changed_alone(addon, source):
    on_edges(source, bpy.ops.mesh.duplicate_move, everywhere, TRANSFORM_OT_translate={"value": (0, 0, 3)})
    both = [("Bust", 0, 8), ("Bust (2)", 0, 8), ("Middle", 0.05, 8), ("Middle (2)", 0.05, 8)]
    assert sorted(listed(addon, source)) == sorted(both)
    bpy.ops.mesh.wirewarp_change_wire(edge=edge_of(addon, source, "Middle (2)"), name="Back", kind="RIGID")
    assert sorted(listed(addon, source)) == sorted([*both[:3], ("Back", 0, 8)])


def test_joined_copies_are_wires_of_their_own(addon, source):
    bpy.ops.object.duplicate()
    bpy.context.active_object.location.z = 3
    select_only(source, bpy.context.active_object)
    bpy.ops.object.join()
    names = ["Bust", "Bust (2)", "Middle", "Middle (2)"]
    assert sorted(name for name, _, _ in listed(addon, source)) == names
    report = report_after(addon, source)
    assert sorted(wire.name for wire in report.wires) == names
    flat = bpy.data.objects["Bump Flat"]
    assert sorted(entry.name for entry in flat.data.wirewarp_names) == names
    assert len(wire_marks(flat.data)) == 4


def test_the_last_marked_wire_is_chosen_in_the_list(source):
    names = source.data.wirewarp_names
    mark(source, on_line(0, 0.5))
    assert source.data.wirewarp_active_wire == len(names) - 1
    mark(source, on_line(1, 0.0), kind="ELASTIC", tolerance=0.05)
    assert names[source.data.wirewarp_active_wire].name == names[0].name


def test_edges_without_a_wire_are_not_changed_or_selected(source):
    for command in (bpy.ops.mesh.wirewarp_change_wire, bpy.ops.mesh.wirewarp_select_wire):
        fails(command, 'Edge 0 of "Bump" is not part of a wire. Choose a wire', edge=0)
    select_edges(source, on_line(1, 0.5))
    fails(bpy.ops.mesh.wirewarp_select_wire, "No selected edge is a wire")
    assert source.mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.object.wirewarp_flatten()
    select_only(bpy.data.objects["Bump Flat"])
    assert not bpy.ops.mesh.wirewarp_change_wire.poll()  # Wires are changed on the model only.


@pytest.mark.parametrize("by", ["list", "selected edge"])
def test_a_whole_wire_is_selected(addon, source, by):
    if by == "list":
        bpy.ops.mesh.wirewarp_select_wire(edge=edge_of(addon, source, "Middle"))
    else:
        select_edges(source, lambda a, b: NORTH_SOUTH(a, b) and max(a.y, b.y) == 1)
        bpy.ops.mesh.wirewarp_select_wire()
    assert source.mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    selected = np.flatnonzero(read(source.data.edges, "select", bool)).tolist()
    assert selected == [row for row, ends in enumerate(ends_of(source)) if NORTH_SOUTH(*ends)]


def test_whole_wires_of_all_edited_objects_are_selected(source):
    other = grid("Other", bump, wire=NORTH_SOUTH)
    plain = grid("Plain", bump)
    for target, value in ((source, 1), (other, 1), (plain, 0.5)):
        select_edges(target, lambda a, b, value=value: NORTH_SOUTH(a, b) and max(a.y, b.y) == value)
        bpy.ops.object.mode_set(mode="OBJECT")
    select_only(source, other, plain)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.wirewarp_select_wire()
    assert [each.mode for each in (source, other, plain)] == ["EDIT"] * 3
    assert set(bpy.context.selected_objects) == {source, other, plain}
    bpy.ops.object.mode_set(mode="OBJECT")
    for target, is_wire in ((source, NORTH_SOUTH), (other, NORTH_SOUTH), (plain, lambda *_: False)):
        selected = np.flatnonzero(read(target.data.edges, "select", bool)).tolist()
        assert selected == [row for row, ends in enumerate(ends_of(target)) if is_wire(*ends)]


def test_wires_with_a_common_id_get_their_own_ids(addon):
    own_ids, last = addon.state.marked_mesh.own_ids, addon.solve.identity.MAX_ID
    assert own_ids([5, 9, 5, 5, 6]) == [5, 9, 7, 8, 6]
    assert own_ids([last, last]) == [last, 1]


def row_of(addon, target, entry, width=600):
    select_only(target)
    layout = AnyLayout([], [])
    kind = addon.marks.wire_list.WIREWARP_UL_wires
    kind.draw_item(None, sidebar(width), layout, target.data, entry, 0, target.data, "", 0)
    return layout.words


def test_a_row_of_the_list_has_name_kind_and_length_with_its_unit(addon, source):
    bpy.context.scene.unit_settings.length_unit = "CENTIMETERS"
    row = row_of(addon, source, source.data.wirewarp_names[1])
    length = sum(
        wire.length(np.eye(3)) for name, wire in addon.state.identities.listed_wires(source) if name == "Middle"
    )
    assert row == ["Middle", f"±5%  {100 * length:.3f} cm"]
    # In a narrow sidebar, kind and length of the chosen wire are below the list.
    assert row_of(addon, source, source.data.wirewarp_names[1], width=200) == ["Middle"]
    source.data.wirewarp_active_wire = 1
    assert draw_panels(addon).count(f"±5%  {100 * length:.3f} cm") == 1
    for vertex in source.data.vertices:
        vertex.co *= 2
    notify(source)
    addon.state.drawings.forget()  # because changes in quick succession are drawn late
    assert row_of(addon, source, source.data.wirewarp_names[1]) == ["Middle", f"±5%  {200 * length:.3f} cm"]


def test_unlisted_wires_are_below_the_list_and_cleared_wires_are_gone(addon, source):
    """A script clears the marks in the middle of one wire, and all marks of the other wire."""
    wires = dict(addon.state.identities.listed_wires(source))
    for row in wires["Bust"].edges[3:5]:
        source.data.attributes["wirewarp_wire"].data[row].value = 0
    for row in wires["Middle"].edges:
        source.data.attributes["wirewarp_wire"].data[row].value = 0
    notify(source)
    assert row_of(addon, source, source.data.wirewarp_names[1]) == ["Middle"]
    assert len(row_of(addon, source, source.data.wirewarp_names[0])) == 2
    source.data.wirewarp_active_wire = 0
    # The buttons of the chosen wire and of the unlisted wire are drawn narrow and wide.
    assert drawn_buttons(addon).count("mesh.wirewarp_change_wire") == 2 * 2
