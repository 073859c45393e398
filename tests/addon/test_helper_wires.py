# SPDX-License-Identifier: GPL-3.0-or-later
"""Wires that the method added: seen on the model and on the pieces, and listed."""

import bpy
import numpy as np
import pytest
from surfaces import bump, edge_lengths, edge_vertices, flat_of, grid, mark, read, select_only


def short_line(a, b):
    """In the middle of the bump, ending nowhere near its outline."""
    return abs(a[1]) < 1e-6 and abs(b[1]) < 1e-6 and max(abs(a[0]), abs(b[0])) < 0.3


@pytest.fixture
def source():
    """A wire with two loose ends on a model that is turned, scaled unevenly and mirrored."""
    target = grid("Bump", bump)
    target.location, target.rotation_euler, target.scale = (1, 2, 3), (0.3, 0.4, 0.5), (-1, 1.5, 2)
    mark(target, short_line)
    bpy.ops.object.wirewarp_flatten(method="WIREWARP_PLUS_PLUS")
    return target


def helpers_of(owner):
    found = [other for other in bpy.data.objects if other.wirewarp_helpers_of == owner]
    return found[0] if found else None


def reported(addon, source):
    return [wire for piece in addon.flat.reports.last_report(source)["pieces"] for wire in piece["helper_wires"]]


def lengths_by_helper(target):
    return np.bincount(read(target.data.attributes["helper_wire"].data, "value", np.int32), edge_lengths(target))


def test_they_lie_where_the_report_says_and_are_as_long(source, addon):
    wires = reported(addon, source)
    assert len(wires) >= 2
    on_model, on_flat = helpers_of(source), helpers_of(flat_of(source))
    on_model.hide_viewport = on_flat.hide_viewport = False  # Blender does not place what it does not show
    bpy.context.view_layer.update()
    assert lengths_by_helper(on_model) == pytest.approx([wire["length_3d"] for wire in wires], rel=1e-5)
    assert lengths_by_helper(on_flat) == pytest.approx([wire["length_2d"][0] for wire in wires], rel=1e-5)
    for wire in wires:
        assert wire["length_2d"][0] == pytest.approx((1 + wire["variation"]) * wire["length_3d"])


def test_they_begin_at_the_loose_ends_on_both(source):
    for owner in (source, flat_of(source)):
        helpers = helpers_of(owner)
        places = read(helpers.data.vertices, "co", np.float32, 3)
        corners = read(owner.data.vertices, "co", np.float32, 3)
        marked = read(owner.data.attributes["wirewarp_wire"].data, "value", np.int32) != 0
        vertices, count = np.unique(edge_vertices(owner.data)[marked], return_counts=True)
        for end in corners[vertices[count == 1]]:
            assert np.linalg.norm(places - end, axis=1).min() < 1e-5


def test_they_move_with_what_they_lie_on_and_are_in_nobodys_way(source):
    for owner in (source, flat_of(source)):
        owner.location.x += 7
        helpers = helpers_of(owner)
        assert helpers.hide_viewport
        helpers.hide_viewport = False  # Blender does not place what it does not show
        bpy.context.view_layer.update()
        assert helpers.matrix_world == owner.matrix_world
        assert helpers.name == f"{owner.name} Helper Wires"
        assert (helpers.hide_select, helpers.hide_render) == (True, True)
        assert read(helpers.data.edges, "is_loose", bool).all()  # others are not drawn
        assert [collection.name for collection in helpers.users_collection] == ["WireWarp"]


def test_again_replaces_and_without_the_option_they_go(source):
    objects, meshes = len(bpy.data.objects), len(bpy.data.meshes)
    bpy.ops.object.wirewarp_flatten(method="WIREWARP_PLUS_PLUS")
    assert (len(bpy.data.objects), len(bpy.data.meshes)) == (objects, meshes)
    bpy.ops.object.wirewarp_flatten(method="WIREWARP_PLUS_PLUS", helper_wires=False)
    assert (len(bpy.data.objects), len(bpy.data.meshes)) == (objects - 2, meshes - 2)
    assert flat_of(source)


def test_they_go_when_no_wire_needs_one(source):
    source.data.attributes.remove(source.data.attributes["wirewarp_wire"])
    bpy.ops.object.wirewarp_flatten(method="WIREWARP_PLUS_PLUS")
    assert helpers_of(source) is helpers_of(flat_of(source)) is None


def test_they_are_not_flattened(source):
    helpers = helpers_of(source)
    helpers.hide_select = False
    select_only(helpers)
    with pytest.raises(RuntimeError, match="Nothing to flatten"):
        bpy.ops.object.wirewarp_flatten()


def test_the_refined_method_adds_none(source, addon):
    bpy.ops.object.wirewarp_flatten()
    assert reported(addon, source) == []
    assert helpers_of(source) is helpers_of(flat_of(source)) is None


def test_they_are_listed_through_all_pieces(source, addon):
    rows = addon.report.rows.helper_rows(addon.flat.reports.last_report(source))
    assert {row.name for row in rows} == {f"Helper {k}: Bump" for k in range(1, len(rows) + 1)}
    assert len(rows) == len(reported(addon, source))


def test_they_do_not_keep_deleted_models_and_pieces_in_the_file(source, tmp_path):
    path, other = str(tmp_path / "deleted.blend"), grid("Other", bump)
    mark(other, short_line)
    bpy.ops.object.wirewarp_flatten(method="WIREWARP_PLUS_PLUS")
    select_only(source, flat_of(source))
    bpy.ops.object.delete()
    for _ in range(2):  # what has lost its last user is still in the first file, as always in Blender
        bpy.ops.wm.save_as_mainfile(filepath=path)
        bpy.ops.wm.open_mainfile(filepath=path)
    present = {each.name for each in bpy.data.objects if each.type == "MESH"}
    assert present == {"Other", "Other Flat", "Other Helper Wires", "Other Flat Helper Wires"}
