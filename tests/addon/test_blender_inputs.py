# SPDX-License-Identifier: GPL-3.0-or-later
"""What Blender's files and scenes may be like: the right pieces, or one sentence that says what to do."""

import bpy
import numpy as np
import pytest
from everything import answer, draw_panels
from surfaces import bump, flat_of, grid, mark, mark_seam, on_line, read, select_only, wire_marks
from test_flatten import assert_true_lengths

pytestmark = pytest.mark.api

FLATTEN = "object.wirewarp_flatten"
SEAM, WIRE = on_line(0, 0.0), on_line(1, 0.0)
DONE = "{'FINISHED'}"


def link(path, kind, name):
    """Something of another file."""
    with bpy.data.libraries.load(str(path), link=True) as (_, wanted):
        setattr(wanted, kind, [name])
    return getattr(wanted, kind)[0]


@pytest.fixture
def library(tmp_path):
    """A file with a flattened model; the one at hand is empty again."""
    mark(grid("Bump", bump), WIRE)
    bpy.ops.object.wirewarp_flatten()
    path = tmp_path / "library.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    return path


def test_a_library_override_is_made_local_first(library):
    linked = link(library, "objects", "Bump")
    bpy.context.scene.collection.objects.link(linked)
    target = linked.override_create(remap_local_usages=True)
    target.data.override_create(remap_local_usages=True)
    bpy.context.view_layer.update()
    select_only(target)
    assert '"Bump" is a library override' in answer(FLATTEN)
    assert '"Bump" is a library override' in answer(FLATTEN, use_modifiers=True)
    bpy.ops.object.make_local(type="SELECT_OBDATA")
    assert answer(FLATTEN) == DONE
    assert flat_of(target).library is None


@pytest.mark.parametrize("kind", ["is linked from another file", "is a library override"])
@pytest.mark.parametrize("command", ["change_wire", "grain_wire", "select_wire"])
def test_wires_of_another_file_are_made_local_first(library, addon, kind, command):
    target = link(library, "objects", "Bump")
    bpy.context.scene.collection.objects.link(target)
    if "override" in kind:
        target = target.override_create(remap_local_usages=True)
        target.data.override_create(remap_local_usages=True)
        bpy.context.view_layer.update()
    other = grid("Other", bump)
    select_only(target, other)
    before, edge = wire_marks(target.data), addon.state.identities.wires_of(target)[0].edges[0]
    assert f'"Bump" {kind}' in answer(f"mesh.wirewarp_{command}", edge=edge)
    assert (wire_marks(target.data), target.data.wirewarp_grain) == (before, 0)
    assert (bpy.context.active_object, set(bpy.context.selected_objects)) == (target, {target, other})


@pytest.mark.parametrize("kind", ["linked", "override"])
def test_a_model_and_pieces_of_another_file_answer(library, everything_answers, kind):
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)  # without the fixture's own model

    def spoil():
        for name in ("Bump", "Bump Flat"):
            if name not in bpy.context.scene.objects:
                target = link(library, "objects", name)
                bpy.context.scene.collection.objects.link(target)
                if kind == "override":
                    target = target.override_create(remap_local_usages=True)
                    target.data.override_create(remap_local_usages=True)

    everything_answers(spoil)


def test_flat_pieces_beside_those_of_another_file(library):
    """Of the same names, in a collection of the same name, which cannot be written."""
    bpy.context.scene.collection.children.link(link(library, "collections", "WireWarp"))
    source = grid("Bump", bump)
    for _ in range(2):
        select_only(source)
        assert answer(FLATTEN) == DONE
    ours = [each for each in bpy.data.objects if each.wirewarp_source == source]
    assert [(each.library, each.users_collection[0].library) for each in ours] == [(None, None)]
    assert [each.library is None for each in bpy.data.collections].count(True) == 1


def test_a_scene_of_another_file(library):
    linked = link(library, "scenes", "Scene")
    window = bpy.context.window_manager.windows[0]
    window.scene = linked
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
    assert flat_of(source).name in own.objects
    assert flat_of(first).name not in own.objects


def test_hidden_faces_are_flattened_too():
    """In Object Mode, where they are seen."""
    source = grid("Bump", bump)
    source.data.polygons.foreach_set("hide", [index < 20 for index in range(64)])
    assert answer(FLATTEN) == DONE
    assert len(flat_of(source).data.polygons) == 64
    assert np.count_nonzero(read(source.data.polygons, "hide", bool)) == 20


SCALES = [(-2, 1, 1), (3, 0.5, 1), (-1, -1, -1), (1e-4, 1e-4, 1e-4), (1e5, 1e5, 1e5)]


@pytest.mark.parametrize("scale", SCALES)
def test_any_scale_that_is_not_zero(scale):
    source = grid("Bump", bump)
    mark(source, WIRE)
    source.scale = scale
    assert answer(FLATTEN) == DONE
    assert_true_lengths(source, WIRE, tolerance=1e-5)


def test_a_sheared_model():
    """A parent that is scaled, and turned against it."""
    source = grid("Bump", bump)
    mark(source, WIRE)
    parent = bpy.data.objects.new("Parent", None)
    bpy.context.scene.collection.objects.link(parent)
    parent.scale, source.rotation_euler.z = (2, 1, 1), 0.7
    source.parent = parent
    bpy.context.view_layer.update()
    assert answer(FLATTEN) == DONE
    assert_true_lengths(source, WIRE, tolerance=1e-5)


def modified(kind, **settings):
    source = grid("Bump", bump, size=4)
    mark_seam(source, SEAM)
    mark(source, WIRE)
    modifier = source.modifiers.new("Modifier", kind)
    for name, value in settings.items():
        setattr(modifier, name, value)
    select_only(source)
    return source


@pytest.mark.parametrize(
    ("kind", "settings", "faces"),
    [
        ("SUBSURF", {"levels": 1}, 64),
        ("ARRAY", {"count": 3, "relative_offset_displace": (1.5, 0, 0)}, 48),
        ("MIRROR", {"use_axis": (False, False, True), "use_mirror_merge": False}, 32),
        ("TRIANGULATE", {}, 32),
    ],
)
def test_modifiers_that_make_other_faces(addon, kind, settings, faces):
    source = modified(kind, **settings)
    assert answer(FLATTEN) == DONE
    assert len(flat_of(source).data.polygons) == 16
    level, text = addon.solve.report.run_message([addon.state.reports.last_report(source)])
    assert (level, text) == ("WARNING", "Modifiers were ignored, so sizes differ from what you see.")
    assert answer(FLATTEN, use_modifiers=True) == DONE
    assert len(flat_of(source).data.polygons) == faces


def test_modifiers_that_leave_no_face():
    source = modified("MASK")
    source.modifiers[0].vertex_group = source.vertex_groups.new(name="Nothing").name
    assert "Bump: " in answer(FLATTEN, use_modifiers=True)
    assert "Bump Flat" not in bpy.data.objects


def armature():
    bpy.ops.object.armature_add()
    return bpy.context.object


@pytest.mark.parametrize("mode", ["SCULPT", "WEIGHT_PAINT", "VERTEX_PAINT", "TEXTURE_PAINT", "POSE", "EDIT_ARMATURE"])
def test_other_modes(addon, mode):
    source = grid("Bump", bump)
    if mode in {"POSE", "EDIT_ARMATURE"}:
        select_only(armature(), source)
        mode = mode.partition("_")[0]
    bpy.ops.object.mode_set(mode=mode)
    draw_panels(addon)
    assert "Flatten works in Object Mode and in Edit Mode" in answer(FLATTEN) or "poll()" in answer(FLATTEN)
    assert "Bump Flat" not in bpy.data.objects


@pytest.mark.parametrize("active", ["a camera", "nothing", "hidden"])
def test_what_is_active_does_not_matter(addon, active):
    source = grid("Bump", bump)
    objects = bpy.context.view_layer.objects
    if active == "a camera":
        camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
        bpy.context.scene.collection.objects.link(camera)
        objects.active = camera
    elif active == "nothing":
        objects.active = None
    else:
        objects.active = grid("Hidden", bump)
        objects.active.hide_set(True)
        source.select_set(True)
    draw_panels(addon)
    assert answer(FLATTEN) == DONE
    assert len(flat_of(source).data.polygons) == 64


def test_settings_that_are_no_numbers():
    source = grid("Bump", bump)
    mark(source, WIRE)
    for name in ("fairness", "spacing"):
        assert "nan" in answer(FLATTEN, **{name: float("nan")})
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    assert "needs a tolerance above 0" in answer("mesh.wirewarp_mark", kind="ELASTIC", tolerance=float("nan"))
