# SPDX-License-Identifier: GPL-3.0-or-later
"""Linked files, several scenes, scales and modifiers lead to correct pieces, or to one sentence with a remedy."""

import bpy
import numpy as np
import pytest
from everything import answer
from flattening import flattened, report_after, wire_marks
from surfaces import bump, flat_of, grid, new_object, on_line, read, select_only
from test_flatten import assert_true_lengths

pytestmark = pytest.mark.api

FLATTEN = "object.wirewarp_flatten"
WIRE, DONE = on_line(1, 0.0), "{'FINISHED'}"


def link(path, kind, name):
    with bpy.data.libraries.load(str(path), link=True) as (_, wanted):
        setattr(wanted, kind, [name])
    return getattr(wanted, kind)[0]


@pytest.fixture
def library(tmp_path):
    """Save a file with a flattened model, open an empty file, and return the path of the saved file."""
    grid("Bump", bump, wire=WIRE)
    bpy.ops.object.wirewarp_flatten()
    path = tmp_path / "library.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    return path


def other_file(library, kind, *names):
    """Add objects of the library file to the scene, linked or overridden, and return the last object."""
    for name in names:
        target = link(library, "objects", name)
        bpy.context.scene.collection.objects.link(target)
        if kind == "override":
            target = target.override_create(remap_local_usages=True)
            target.data.override_create(remap_local_usages=True)
    bpy.context.view_layer.update()
    return target


OF_ANOTHER_FILE = {"linked": "is linked from another file", "override": "is a library override"}


@pytest.mark.parametrize("kind", OF_ANOTHER_FILE)
def test_linked_objects_must_be_made_local_first(library, addon, kind):
    target = other_file(library, kind, "Bump")
    refusal, other = f'"Bump" {OF_ANOTHER_FILE[kind]}', grid("Other", bump)
    select_only(target, other)
    before, edge = wire_marks(target.data), addon.state.identities.wires_of(target)[0].edges[0]
    for command in ("change_wire", "grain_wire", "select_wire"):
        assert refusal in answer(f"mesh.wirewarp_{command}", edge=edge)
        assert (wire_marks(target.data), target.data.wirewarp_grain) == (before, 0)
        assert (bpy.context.active_object, set(bpy.context.selected_objects)) == (target, {target, other})
    select_only(target)
    assert refusal in answer(FLATTEN) and refusal in answer(FLATTEN, use_modifiers=True)
    if kind == "linked":
        target = new_object("Own", target.data)
        select_only(target)
        assert '"Own" is linked from another file' in answer(FLATTEN)
    bpy.ops.object.make_local(type="SELECT_OBDATA")
    assert answer(FLATTEN) == DONE
    assert flat_of(target).library is None


@pytest.mark.parametrize("kind", OF_ANOTHER_FILE)
def test_a_model_and_pieces_of_another_file_answer(library, everything_answers, kind):
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)  # removes the model of everything_answers

    def spoil():
        if "Bump" not in bpy.context.scene.objects:
            other_file(library, kind, "Bump", "Bump Flat")

    everything_answers(spoil)


def test_pieces_are_written_beside_linked_pieces_of_the_same_name(library):
    """Flatten writes into a collection named "WireWarp", but a linked collection with this name cannot change."""
    bpy.context.scene.collection.children.link(link(library, "collections", "WireWarp"))
    source = grid("Bump", bump)
    for _ in range(2):
        select_only(source)
        assert answer(FLATTEN) == DONE
    ours = [each for each in bpy.data.objects if each.wirewarp_source == source]
    assert [(each.library, each.users_collection[0].library) for each in ours] == [(None, None)]
    assert [each.library is None for each in bpy.data.collections].count(True) == 1


def test_a_linked_scene_is_refused(library):
    bpy.context.window_manager.windows[0].scene = link(library, "scenes", "Scene")
    assert answer(FLATTEN).count("is linked from another file") == 1


def test_pieces_in_a_second_scene_have_one_collection_there():
    first = grid("First", bump, size=4)
    assert answer(FLATTEN) == DONE
    bpy.context.window_manager.windows[0].scene = bpy.data.scenes.new("Second")
    source = grid("Second", bump, size=4)
    for _ in range(3):
        select_only(source)
        assert answer(FLATTEN) == DONE
    (own,) = bpy.context.scene.collection.children
    assert flat_of(source).name in own.objects and flat_of(first).name not in own.objects


def test_hidden_faces_are_flattened_too():
    source = grid("Bump", bump)
    source.data.polygons.foreach_set("hide", [index < 20 for index in range(64)])
    assert answer(FLATTEN) == DONE
    assert len(flat_of(source).data.polygons) == 64
    assert np.count_nonzero(read(source.data.polygons, "hide", bool)) == 20


@pytest.mark.parametrize("scale", [(-2, 1, 1), (3, 0.5, -1), (-1, -1, -1), (1e-4, 1e-4, 1e-4), (1e5, 1e5, 1e5)])
def test_lengths_are_true_at_any_scale_and_under_a_shearing_parent(scale):
    source = grid("Bump", bump, wire=WIRE)
    source.scale = scale
    assert answer(FLATTEN) == DONE
    assert_true_lengths(source, WIRE, tolerance=1e-5)
    parent = new_object("Parent")
    parent.scale, source.rotation_euler.z, source.parent = (2, 1, 1), 0.7, parent
    bpy.context.view_layer.update()
    assert answer(FLATTEN) == DONE
    assert_true_lengths(source, WIRE, tolerance=1e-5)


@pytest.mark.parametrize(
    ("kind", "settings", "faces"),
    [
        ("SUBSURF", {"levels": 1}, 64),
        ("ARRAY", {"count": 3, "relative_offset_displace": (1.5, 0, 0)}, 48),
        ("MIRROR", {"use_axis": (False, False, True), "use_mirror_merge": False}, 32),
        ("TRIANGULATE", {}, 32),
    ],
)
def test_faces_that_modifiers_make_are_only_in_the_flat_object(addon, kind, settings, faces):
    source = grid("Bump", bump, size=4, seam=on_line(0, 0.0), wire=on_line(1, 0.0))
    modifier = source.modifiers.new("Modifier", kind)
    for name, value in settings.items():
        setattr(modifier, name, value)
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    assert len(flat_of(source).data.polygons) == faces and "WireWarp" not in source.data.uv_layers
    assert ignored_after(addon, source) == "Modifiers"
    assert len(flat_of(source).data.polygons) == 16


def notes_after(addon, source, **settings):
    return [note.text for note in report_after(addon, source, **settings).notes]


def message_after(addon, source):
    return addon.solve.report.run_message([report_after(addon, source)], {})


def ignored_after(addon, source):
    """Flatten, and return the ignored data that the warning names. It must not say that lengths are exact."""
    level, text = message_after(addon, source)
    assert level == "WARNING" and "Lengths are exact" not in text
    return text.removesuffix(" were ignored, so sizes differ from what you see.")


def test_ignored_modifiers_and_shape_keys_are_reported(addon):
    source = grid("Bump", bump)
    source.shape_key_add(name="Basis")
    key = source.shape_key_add(name="Taller")
    key.value = 0  # Blender 5 creates keys with the value 1
    source.modifiers.new("Shading", "WEIGHTED_NORMAL")  # does not move vertices
    assert notes_after(addon, source) == []
    key.data[40].co.z += 1
    key.value = 1
    assert ignored_after(addon, source) == "Modifiers and shape keys"
    source.modifiers.clear()
    assert ignored_after(addon, source) == "Shape keys"
    source.modifiers.new("Smooth", "SUBSURF").levels = 1
    assert ignored_after(addon, source) == "Modifiers and shape keys"


def test_modifiers_that_change_nothing_are_not_reported(addon):
    source = grid("Bump", bump)
    bpy.ops.object.armature_add()
    armature = bpy.context.object
    source.vertex_groups.new(name=armature.data.bones[0].name).add(range(81), 1.0, "REPLACE")
    source.modifiers.new("Armature", "ARMATURE").object = armature
    select_only(source)
    assert "Lengths are exact" in message_after(addon, source)[1]
    source.modifiers.new("Split", "EDGE_SPLIT").split_angle = 0
    assert "Lengths are exact" in message_after(addon, source)[1]
    armature.pose.bones[0].location.y = 0.5
    assert ignored_after(addon, source) == "Modifiers"


def test_shape_keys_are_flattened_with_the_modifiers():
    source = grid("Bump", bump)
    source.shape_key_add(name="Basis")
    key = source.shape_key_add(name="Wider")
    for point in key.data:
        point.co.x *= 2
    key.value = 1
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    wide = flattened("Wide", lambda x, y: (2 * x, *bump(x, y)[1:]))
    areas = [sum(face.area for face in flat_of(target).data.polygons) for target in (source, wide)]
    assert areas[0] == pytest.approx(areas[1], rel=1e-4)


def test_an_old_uv_map_is_reported_if_pieces_are_made_with_modifiers(addon):
    source = flattened("Bump", bump)
    source.modifiers.new("Smooth", "SUBSURF").levels = 1
    (note,) = notes_after(addon, source, use_modifiers=True)
    assert note == 'The UV map "WireWarp" is from an earlier run without Modifiers. It does not show these pieces.'
