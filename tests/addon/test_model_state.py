# SPDX-License-Identifier: GPL-3.0-or-later
"""WireWarp notices if a model has changed since its report, in both modes. Changes of other data do not count."""

import bpy
import numpy as np
import pytest
from flattening import fails, flatten, flattened, notify, raise_vertex
from mathutils import Euler, Matrix, Vector
from surfaces import bump, flat_of, grid, new_object, on_line, select_edges, select_only

LINE, OTHER = on_line(1, 0.0), on_line(0, 0.0)


@pytest.fixture
def source():
    return flattened("Bump", bump, seam=OTHER, wire=LINE)


@pytest.fixture
def has_changed(addon):
    return lambda target: addon.state.changes.has_changed(target, addon.state.reports.last_report(target).model_state)


EDITS = {  # the line to select, or None for all elements, and the edit of the selection
    "a vertex moved": (None, lambda: raise_vertex(bpy.context.object)),
    "seams cleared": (None, lambda: bpy.ops.mesh.mark_seam(clear=True)),
    "wires cleared": (None, lambda: bpy.ops.mesh.wirewarp_clear()),
    "a wire loosened": (LINE, lambda: bpy.ops.mesh.wirewarp_mark(kind="ELASTIC")),
    "flipped": (None, lambda: bpy.ops.mesh.flip_normals()),
    "subdivided": (None, lambda: bpy.ops.mesh.subdivide()),
    "a side eased": (OTHER, lambda: bpy.ops.mesh.wirewarp_ease(sides="ONE", ease_percent=5.0)),
}


@pytest.mark.parametrize("change", EDITS)
def test_edits_are_seen_in_both_modes(source, has_changed, change):
    line, edit = EDITS[change]
    assert not has_changed(source)
    select_edges(source, line or LINE)
    if line is None:
        bpy.ops.mesh.select_all(action="SELECT")
    assert not has_changed(source)
    edit()
    bpy.context.view_layer.update()
    assert has_changed(source)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert has_changed(source)
    bpy.ops.object.wirewarp_flatten()
    assert not has_changed(source)


def test_scale_is_a_change_but_place_and_an_applied_scale_of_one_are_not(source, has_changed):
    """Blender may turn negative zeros into positive zeros when it applies a scale."""
    source.data.vertices[40].co.x = -0.0
    flatten(source)
    bpy.ops.object.transform_apply(location=False, rotation=False, scale=True)
    source.data.vertices[40].co.x = 0.0  # because some versions of Blender keep the sign
    source.data.update()
    assert not has_changed(source)
    source.location, source.rotation_euler = (1, 2, 3), (0.1, 0.2, 0.3)
    bpy.context.view_layer.update()
    assert not has_changed(source)
    source.scale.x = 1.01
    bpy.context.view_layer.update()
    assert has_changed(source)


def placed(source):
    source.location, source.rotation_euler, source.scale = (3, -2, 5), (0.3, 1.0, -2.0), (2.54, 0.4, 1.7)
    bpy.context.view_layer.update()
    flatten(source, use_modifiers=bool(source.modifiers))


APPLIED = {"location": (1, 0, 0), "rotation": (0, 1, 0), "scale": (0, 0, 1), "all": (1, 1, 1)}


@pytest.mark.parametrize("what", APPLIED)
def test_applying_a_transformation_keeps_all_lengths_so_it_is_no_change(source, has_changed, what, tmp_path):
    placed(source)
    location, rotation, scale = map(bool, APPLIED[what])
    source.location.x += 0.3
    before = [*source.data.vertices[0].co]
    bpy.ops.object.transform_apply(location=location, rotation=rotation, scale=scale)
    assert [*source.data.vertices[0].co] != before
    assert not has_changed(source)
    assert bpy.ops.object.wirewarp_export_svg(filepath=str(tmp_path / "pattern.svg")) == {"FINISHED"}
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}


def test_a_change_beside_an_applied_scale_is_noticed(source, has_changed):
    placed(source)
    bpy.ops.object.transform_apply(scale=True)
    raise_vertex(source, 1e-3)
    assert has_changed(source)
    flatten(source)
    source.scale.x = 1.01
    bpy.ops.object.transform_apply(scale=True)
    assert not np.allclose(source.matrix_world.to_scale(), (1.01, 1, 1)) and has_changed(source)


def test_the_smallest_change_counts_if_no_transformation_was_applied(source, has_changed):
    """Applied transformations have larger rounding errors than this change."""
    source.data.vertices[40].co.z = np.nextafter(np.float32(source.data.vertices[40].co.z), np.float32(1))
    notify(source)
    assert has_changed(source)


def test_applying_a_transformation_with_modifiers_is_no_change(smooth, has_changed):
    smooth.modifiers.remove(smooth.modifiers["Mirror"])
    placed(smooth)
    bpy.ops.object.transform_apply(location=True, rotation=True, scale=True)
    assert not has_changed(smooth)
    displace = smooth.modifiers.new("Displace", "DISPLACE")
    displace.strength = 0.001
    bpy.context.view_layer.update()
    assert has_changed(smooth)


def test_selections_names_unused_modifiers_and_shape_keys_in_edit_mode_are_no_changes(source, has_changed):
    source.data.wirewarp_names[0].name = "Bust"
    source.data.uv_layers.new(name="Mine")
    source.modifiers.new("Wave", "WAVE")
    select_edges(source, LINE)
    assert not has_changed(source)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert not has_changed(source)
    source.shape_key_add(name="Basis")
    source.shape_key_add(name="Taller").data[40].co.z += 1
    source.active_shape_key_index = 1
    bpy.ops.object.mode_set(mode="EDIT")
    assert not has_changed(source)


def test_an_attribute_of_another_type_is_a_change(source, has_changed):
    source.data.attributes.remove(source.data.attributes["wirewarp_wire"])
    source.data.attributes.new("wirewarp_wire", "FLOAT", "POINT")
    notify(source)
    assert has_changed(source)


@pytest.fixture
def smooth():
    """Return a model flattened with two modifiers: Subdivision, and Mirror with an empty as the mirror plane."""
    target = grid("Bump", bump, wire=LINE)
    mirror = new_object("Mirror")
    mirror.location.x = 3
    target.modifiers.new("Smooth", "SUBSURF").levels = 1
    target.modifiers.new("Mirror", "MIRROR").mirror_object = mirror
    flatten(target, use_modifiers=True)
    return target


def add_shape_key(target):
    target.shape_key_add(name="Basis")
    key = target.shape_key_add(name="Taller")
    key.data[40].co.z += 1
    key.value = 1


CHANGES = {
    "levels": lambda target: setattr(target.modifiers["Smooth"], "levels", 2),
    "hidden": lambda target: setattr(target.modifiers["Smooth"], "show_viewport", False),
    "added": lambda target: target.modifiers.new("Wave", "WAVE"),
    "mirror moved": lambda _: setattr(bpy.data.objects["Mirror"].location, "x", 4),
    "shape key": add_shape_key,
}


@pytest.mark.parametrize("change", CHANGES)
def test_changed_modifiers_are_seen_by_report_export_and_auto_update(addon, smooth, has_changed, tmp_path, change):
    def taken():
        bpy.context.view_layer.update()
        return addon.flatten.auto_update.take_changed(bpy.context)

    path = tmp_path / "pattern.svg"
    smooth.location.y = 1
    assert taken() == []
    assert bpy.ops.object.wirewarp_export_svg(filepath=str(path)) == {"FINISHED"}
    CHANGES[change](smooth)
    assert taken() == [smooth]
    assert taken() == []  # Auto tries each state once.
    assert has_changed(smooth)
    fails(bpy.ops.object.wirewarp_export_svg, "has changed since it was flattened", filepath=str(path))
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    assert taken() == []
    assert bpy.ops.object.wirewarp_export_svg(filepath=str(path)) == {"FINISHED"}


def test_a_model_may_move_together_with_the_objects_of_its_modifiers(smooth, has_changed):
    mirror = bpy.data.objects["Mirror"]
    for step in range(1, 6):
        motion = Matrix.LocRotScale(Vector((0.37, -7.1, 12.3)) * step, Euler((0.3, 0.2 * step, 1.1)), None)
        for moved in (smooth, mirror):
            moved.matrix_world = motion @ moved.matrix_world
        bpy.context.view_layer.update()
        assert not has_changed(smooth)
    mirror.location.x += 0.001
    bpy.context.view_layer.update()
    assert has_changed(smooth)


@pytest.mark.parametrize("count", [1, 100, 100_000])
def test_one_vertex_that_moves_is_seen_and_rounding_is_not(addon, count):
    random, module = np.random.default_rng(count), addon.state.changes
    points = random.uniform(-1, 1, (count, 3)).astype(np.float32)
    before, rounding = np.array(module.place_sums(points)), 2 * module.rounding_of_sums(points, 0.0)
    rounded = points + random.uniform(-3e-7, 3e-7, points.shape).astype(np.float32)
    assert np.abs(before - module.place_sums(rounded)).max() <= rounding
    moved = points.copy()
    moved[count // 3, 1] += 1e-3
    assert np.abs(before - module.place_sums(moved)).max() > rounding


def test_rounding_errors_of_a_modifier_along_normals_are_not_changes(addon):
    """Up to Blender 3.6, threads add normals in any order, so the last digits of moved vertices differ."""
    target = grid("Bump", bump, size=72)
    modifier = target.modifiers.new("Thick", "DISPLACE")
    flatten(target, use_modifiers=True)
    report = addon.state.reports.last_report(target)
    for _ in range(10):
        target.data.update_tag()
        bpy.context.view_layer.update()
        assert not addon.state.changes.has_changed(target, report.model_state, addon.state.memory.read_anew)
    modifier.strength += 1e-4
    bpy.context.view_layer.update()
    assert addon.state.changes.has_changed(target, report.model_state, addon.state.memory.read_anew)


def test_another_frame_of_an_animated_modifier_is_a_change(smooth, has_changed):
    modifier = smooth.modifiers["Smooth"]
    for frame, levels in ((1, 1), (20, 2)):
        modifier.levels = levels
        modifier.keyframe_insert("levels", frame=frame)
    bpy.context.scene.frame_set(1)
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    assert not has_changed(smooth)
    bpy.context.scene.frame_set(20)
    assert has_changed(smooth)


def test_a_hidden_model_with_modifiers_must_be_shown_first(smooth, tmp_path):
    path = tmp_path / "pattern.svg"
    select_only(flat_of(smooth))
    smooth.hide_set(True)
    fails(bpy.ops.object.wirewarp_export_svg, 'Show "Bump" in Object Mode first', filepath=str(path))
    smooth.hide_set(False)
    assert bpy.ops.object.wirewarp_export_svg(filepath=str(path)) == {"FINISHED"}


def test_a_model_updated_in_edit_mode_is_updated_again_after_its_modifiers_change(addon, smooth):
    bpy.ops.object.mode_set(mode="EDIT")
    raise_vertex(smooth)
    assert addon.flatten.auto_update.take_changed(bpy.context) == [smooth]
    bpy.ops.object.mode_set(mode="OBJECT")
    smooth.modifiers["Smooth"].levels = 2
    bpy.context.view_layer.update()
    assert addon.flatten.auto_update.take_changed(bpy.context) == [smooth]
