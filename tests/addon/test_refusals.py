# SPDX-License-Identifier: GPL-3.0-or-later
"""Models and files that cannot be flattened or written are refused before anything is written, with a remedy."""

import math
import re

import bpy
import pytest
from everything import draw_panels
from flattening import fails, flatten_fails
from mathutils import Matrix
from surfaces import bump, flat_of, grid, make_object, mark, mark_seam, new_object, on_line, select_only


@pytest.fixture
def source():
    return grid("Bump", bump)


def nothing_written(source):
    return (
        not [layer.name for layer in source.data.uv_layers if layer.name.startswith("WireWarp")]
        and "wirewarp_uv_scale" not in source.data
        and "wirewarp_report" not in source
        and not source.wirewarp_pieces
        and f"{source.name} Flat" not in bpy.data.objects
    )


def eight_maps(source, count=8):
    for number in range(count):
        source.data.uv_layers.new(name=f"Map {number}")


def break_a_wire(source):
    """Mark a wire with an invalid tolerance, which only a script can write."""
    mark(source, on_line(1, 0.0))
    source.data.attributes["wirewarp_tolerance"].data.foreach_set("value", [math.nan] * len(source.data.edges))
    source.data.wirewarp_names[0].name = "Dart Line"


def lose_a_vertex(source):
    source.data.vertices[40].co.z = math.nan


NAMED = '"Bump" has something called "WireWarp" under Object Data > '
REFUSED = {  # for each case, how the model is spoiled, and the resulting sentence
    "zero scale": (lambda s: setattr(s, "scale", (1, 1, 0)), '"Bump" is scaled to zero along an axis'),
    "a vertex that is nowhere": (lose_a_vertex, "The coordinates of 1 vertex are not numbers, or far too large. Move"),
    "too large": (
        lambda s: s.data.transform(Matrix.Scale(1e25, 4)),
        '"Bump" is more than 1e.18 Blender units wide, so its areas cannot be computed',
    ),
    "eight UV maps": (eight_maps, "already has 8 UV maps"),
    "a flipped face": (lambda s: s.data.polygons[0].flip(), "opposite sides.*Mesh > Normals > Recalculate Outside"),
    "a faulty wire": (break_a_wire, 'Bump: Wire "Dart Line" has an invalid tolerance. Click it'),
    "a vertex group": (lambda s: s.vertex_groups.new(name="WireWarp"), f"{NAMED}Vertex Groups.*Rename it"),
    "an attribute": (lambda s: s.data.attributes.new("WireWarp", "FLOAT", "POINT"), f"{NAMED}.*Rename it"),
    "a color": (lambda s: s.data.color_attributes.new("WireWarp", "BYTE_COLOR", "CORNER"), f"{NAMED}.*Rename it"),
    "a vertex group with the name of an attribute": (
        lambda s: s.vertex_groups.new(name="wirewarp_piece"),
        'called "wirewarp_piece" under Object Data > Vertex Groups.*Rename it',
    ),
}
SETTINGS = [
    ({"fairness": math.nan}, "nan"),
    ({"spacing": math.nan}, "nan"),
    ({"report_path": "//report.json"}, "Blender file, so save the file first"),
    # Even an administrator cannot create files in /proc.
    ({"report_path": "/proc/report.json"}, 'Cannot write "/proc/report.json": '),
    ({"use_modifiers": True}, "Bump: "),  # The modifier of the test leaves no faces.
]


@pytest.mark.api
@pytest.mark.parametrize("case", REFUSED)
def test_a_refused_model_does_not_change_the_file(source, case):
    spoil, sentence = REFUSED[case]
    spoil(source)
    select_only(source)
    flatten_fails(sentence)
    assert nothing_written(source)


@pytest.mark.parametrize(("settings", "sentence"), SETTINGS)
def test_a_refused_setting_does_not_change_the_file(source, settings, sentence):
    source.modifiers.new("Mask", "MASK").vertex_group = source.vertex_groups.new(name="Nothing").name
    flatten_fails(sentence, **settings)
    assert nothing_written(source)


def test_a_report_file_that_cannot_be_written_is_refused(source, tmp_path):
    for path, said in (
        (tmp_path / "none" / "report.json", "there is no folder"),
        (tmp_path, re.escape(f'Cannot write "{tmp_path}": it is a folder')),
        (tmp_path / ("n" * 300) / "r", "Cannot write .*: (File name too long|there is no folder)"),
    ):
        flatten_fails(said, report_path=str(path))
        assert nothing_written(source)
    bpy.ops.object.wirewarp_flatten(report_path=str(tmp_path / "report.json"))
    assert [path.name for path in tmp_path.iterdir()] == ["report.json"]


def test_the_map_gets_another_name_if_ours_is_taken(source):
    bpy.ops.object.wirewarp_flatten()
    source.vertex_groups.new(name="WireWarp")
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    eight_maps(source, 7)
    assert len(source.data.uv_layers) == 8
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}


def test_nothing_to_flatten(source):
    bpy.ops.object.select_all(action="DESELECT")
    bpy.context.view_layer.objects.active = None
    flatten_fails(r"Nothing to flatten: select a mesh object\.$")
    select_only(source)
    source.hide_set(True)
    flatten_fails('Nothing to flatten: "Bump" is hidden')
    bpy.ops.curve.primitive_bezier_circle_add()
    flatten_fails('Circle" is not a mesh. Use Object > Convert > Mesh first')
    make_object("Points", [(0, 0, 0), (1, 0, 0)], [])
    flatten_fails("Points: The mesh has no faces, so there is nothing to flatten. In Edit Mode, fill its outlines")


@pytest.mark.api
@pytest.mark.parametrize("mode", ["SCULPT", "WEIGHT_PAINT", "VERTEX_PAINT", "TEXTURE_PAINT", "POSE", "EDIT_ARMATURE"])
def test_other_modes_are_refused(source, addon, mode):
    if mode in {"POSE", "EDIT_ARMATURE"}:
        bpy.ops.object.armature_add()
        select_only(bpy.context.object, source)
        mode = mode.partition("_")[0]
    bpy.ops.object.mode_set(mode=mode)
    draw_panels(addon)
    flatten_fails(r"Flatten works in Object Mode and in Edit Mode|poll\(\)")
    assert nothing_written(source)


@pytest.mark.parametrize("active", ["a camera", "nothing", "hidden", "the model, not selected"])
def test_the_active_object_does_not_matter(source, addon, active):
    objects = bpy.context.view_layer.objects
    if active == "a camera":
        objects.active = new_object("Camera", bpy.data.cameras.new("Camera"))
    elif active == "nothing":
        objects.active = None
    elif active == "hidden":
        objects.active = grid("Hidden", bump)
        objects.active.hide_set(True)
        source.select_set(True)
    else:
        grid("Other", bump)
        bpy.ops.object.select_all(action="DESELECT")
        objects.active = source
    draw_panels(addon)
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert [each.name for each in bpy.data.objects if each.name.endswith("Flat")] == ["Bump Flat"]


def test_objects_are_checked_again_before_writing(source, addon):
    read, settings = addon.flatten.read, bpy.context.scene.wirewarp
    models = read.read_models(bpy.context, [source], settings)
    eight_maps(source)
    with pytest.raises(addon.issues.ObjectError, match="already has 8 UV maps"):
        read.check_current(bpy.context, models, settings)
    source.data.uv_layers.remove(source.data.uv_layers[0])
    read.check_current(bpy.context, models, settings)
    source.data.vertices[0].co.z += 1
    with pytest.raises(addon.issues.ObjectError, match='"Bump" changed during the run, so nothing was written'):
        read.check_current(bpy.context, models, settings)


def in_another_scene(data):
    """Return a context in a new scene with one object of this mesh."""
    scene, other = bpy.data.scenes.new("Other"), bpy.data.objects.new("Other", data)
    scene.collection.objects.link(other)
    view_layer = scene.view_layers[0]
    view_layer.objects.active = other
    other.select_set(True, view_layer=view_layer)
    window = bpy.context.window_manager.windows[0]
    return bpy.context.temp_override(window=window, scene=scene, view_layer=view_layer)


def test_a_mesh_that_is_edited_in_another_scene_is_refused(source):
    mark(source, on_line(0, 0.0))
    bpy.ops.object.mode_set(mode="EDIT")
    with in_another_scene(source.data):
        flatten_fails('The mesh "Bump" is being edited in another scene or view layer. Leave Edit Mode there first')
    assert "Other Flat" not in bpy.data.objects


def test_flat_pieces_that_are_edited_in_another_scene_are_refused(source, addon):
    bpy.ops.object.wirewarp_flatten()
    select_only(flat_of(source))
    bpy.ops.object.mode_set(mode="EDIT")
    sentence = 'The mesh "Bump Flat" is being edited in another scene'
    with pytest.raises(addon.issues.ObjectError, match=sentence):
        addon.flatten.read.check_target(source, writes_model=True, edited=())
    with pytest.raises(addon.issues.ObjectError, match=sentence):
        addon.export.read.read_pattern(bpy.context.scene, source)
    # Here, the pieces stay in Edit Mode while the model is active, as if they were edited in another view layer.
    bpy.context.view_layer.objects.active = source
    flatten_fails(sentence)


def test_no_export_replaces_a_blender_file(source, tmp_path):
    path = tmp_path / "model.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    before = path.read_bytes()
    source = bpy.data.objects["Bump"]
    select_only(source)
    flatten_fails("a Blender file has this name", report_path=str(path))
    assert nothing_written(source)
    bpy.ops.object.wirewarp_flatten()
    for name in ("model.blend", "pattern.pdf", "pattern"):
        fails(bpy.ops.object.wirewarp_export_svg, "its name must end in .svg", filepath=str(tmp_path / name))
    assert path.read_bytes() == before and list(tmp_path.iterdir()) == [path]


def test_objects_with_one_mesh_and_different_scales_are_refused(source):
    bpy.ops.object.duplicate(linked=True)
    other = bpy.context.active_object
    other.rotation_euler.z = 1
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    other.scale = (2, 2, 2)
    select_only(other)
    flatten_fails('"Bump.001" and "Bump" share the mesh "Bump" but differ in scale.*Make Single User')
    assert bpy.ops.object.wirewarp_flatten(use_modifiers=True) == {"FINISHED"}  # A run with modifiers writes no UV map.
    bpy.ops.object.make_single_user(object=True, obdata=True)
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert other.data["wirewarp_uv_scale"] == pytest.approx(2 * source.data["wirewarp_uv_scale"], rel=1e-5)


def test_flat_pieces_without_their_model_are_refused(source, addon):
    """A deleted model stays in the file, because its pieces refer to it. Only a script can remove it from the file."""
    bpy.ops.object.wirewarp_flatten()
    flat = flat_of(source)
    collection = bpy.data.collections.new("Away")
    bpy.context.scene.collection.children.link(collection)
    collection.objects.link(source)
    bpy.context.scene.collection.objects.unlink(source)
    select_only(flat)
    bpy.context.view_layer.layer_collection.children["Away"].exclude = True
    flatten_fails('"Bump", the model of these pieces, is not in this view layer')
    bpy.context.view_layer.layer_collection.children["Away"].exclude = False
    select_only(source)
    bpy.ops.object.delete()
    select_only(flat)
    sentence = 'hese are flat pieces. You deleted their model "Bump". Press Ctrl\\+Z to get it back'
    flatten_fails(f"t{sentence}")
    assert re.search(f"T{sentence}", draw_panels(addon))
    bpy.data.objects.remove(source)
    flatten_fails('"Bump Flat" contains flat pieces, and their model was deleted')
    flat.data.attributes.remove(flat.data.attributes["source_vertex"])
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}


def test_too_many_notches_are_refused(source, tmp_path):
    mark_seam(source, on_line(0, 0.0))
    for vertex in source.data.vertices:
        vertex.co *= 1000
    bpy.ops.object.wirewarp_flatten()
    path = tmp_path / "pattern.svg"
    with pytest.raises(RuntimeError, match=r"Seam 1 is 2,\d\d\d m long, too long for a notch .*unit of the model"):
        bpy.ops.object.wirewarp_export_svg(filepath=str(path), notch_spacing=10)
    assert not path.exists()
    assert bpy.ops.object.wirewarp_export_svg(filepath=str(path), notch_spacing=0) == {"FINISHED"}
