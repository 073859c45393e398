# SPDX-License-Identifier: GPL-3.0-or-later
"""The report sees that its model has changed since, in Object and in Edit Mode, and only then."""

import bmesh
import bpy
import pytest
from surfaces import bump, grid, mark, mark_seam, on_line, select_edges, select_only

LINE, OTHER = on_line(1, 0.0), on_line(0, 0.0)


@pytest.fixture
def source():
    target = grid("Bump", bump)
    mark_seam(target, OTHER)
    mark(target, LINE)
    select_only(target)
    bpy.ops.object.wirewarp_flatten()
    return target


@pytest.fixture
def has_changed(addon, source):
    return lambda: addon.model_state.has_changed(source, addon.report_store.last_report(source))


def move_a_vertex(source):
    edit = bmesh.from_edit_mesh(source.data)
    edit.verts.ensure_lookup_table()
    edit.verts[40].co.z += 0.01
    bmesh.update_edit_mesh(source.data)


def clear_seams(source):
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.mark_seam(clear=True)


def clear_wires(source):
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.wirewarp_clear()


def loosen_wires(source):
    select_edges(source, LINE)
    bpy.ops.mesh.wirewarp_mark(kind="ELASTIC")


def turn_over(source):
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.flip_normals()


def subdivide(source):
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide()


@pytest.mark.parametrize("change", [move_a_vertex, clear_seams, clear_wires, loosen_wires, turn_over, subdivide])
def test_edits_are_seen_in_both_modes(source, has_changed, change):
    assert not has_changed()
    bpy.ops.object.mode_set(mode="EDIT")
    assert not has_changed()
    change(source)
    bpy.context.view_layer.update()
    assert has_changed()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert has_changed()
    bpy.ops.object.wirewarp_flatten()
    assert not has_changed()


def test_scale_is_seen_and_place_does_not_matter(source, has_changed):
    source.location, source.rotation_euler = (1, 2, 3), (0.1, 0.2, 0.3)
    bpy.context.view_layer.update()
    assert not has_changed()
    source.scale.x = 1.01
    bpy.context.view_layer.update()
    assert has_changed()


def test_selecting_and_naming_change_nothing(source, has_changed):
    source.data.wirewarp_names[0].name = "Bust"
    source.data.uv_layers.new(name="Mine")
    select_edges(source, LINE)
    assert not has_changed()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert not has_changed()


def test_in_edit_mode_a_shape_key_is_no_change(source, has_changed):
    source.shape_key_add(name="Basis")
    source.shape_key_add(name="Taller").data[40].co.z += 1
    source.active_shape_key_index = 1
    bpy.ops.object.mode_set(mode="EDIT")
    assert not has_changed()


def test_an_attribute_of_another_type_is_a_change(source, has_changed):
    source.data.attributes.remove(source.data.attributes["wirewarp_wire"])
    source.data.attributes.new("wirewarp_wire", "FLOAT", "POINT")
    source.data.update()
    bpy.context.view_layer.update()
    assert has_changed()
