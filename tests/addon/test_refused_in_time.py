# SPDX-License-Identifier: GPL-3.0-or-later
"""What cannot be written is refused before anything is, with a sentence that says what to do."""

import bpy
import pytest
from surfaces import bump, flat_of, grid, mark, on_line, select_only

NAMED = {  # by what of Blender's holds the name, how something of that name gets there
    "Vertex Groups": lambda source, name: source.vertex_groups.new(name=name),
    "Attributes": lambda source, name: source.data.attributes.new(name, "FLOAT", "POINT"),
    "Color Attributes": lambda source, name: source.data.color_attributes.new(name, "BYTE_COLOR", "CORNER"),
}


@pytest.fixture
def source():
    return grid("Bump", bump, size=4)


def flatten_fails(match, **settings):
    with pytest.raises(RuntimeError, match=match):
        bpy.ops.object.wirewarp_flatten(**settings)


def nothing_written(source):
    uv_maps = [layer.name for layer in source.data.uv_layers if layer.name.startswith("WireWarp")]
    return not (uv_maps or source.wirewarp_pieces or "wirewarp_report" in source or "Bump Flat" in bpy.data.objects)


@pytest.mark.parametrize("place", NAMED)
def test_another_owner_of_the_maps_name(source, place):
    NAMED[place](source, "WireWarp")
    flatten_fails('"Bump" has something called "WireWarp" under Object Data > .*rename it')
    assert nothing_written(source)


def test_another_owner_of_the_pieces_name(source):
    source.vertex_groups.new(name="wirewarp_piece")
    flatten_fails('called "wirewarp_piece" under Object Data > Vertex Groups.*rename it')
    assert nothing_written(source)


def test_an_owner_of_the_name_beside_our_own_map_is_no_matter(source):
    bpy.ops.object.wirewarp_flatten()
    source.vertex_groups.new(name="WireWarp")
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}


def test_what_was_free_when_read_is_asked_again_before_writing(source, addon):
    models = addon.flatten.read.read_models(bpy.context, [source], bpy.context.scene.wirewarp)
    for number in range(8):
        source.data.uv_layers.new(name=f"Map {number}")
    with pytest.raises(addon.issues.ObjectError, match="already has 8 UV maps"):
        addon.flatten.read.check_current(bpy.context, models, bpy.context.scene.wirewarp)
    source.data.uv_layers.remove(source.data.uv_layers[0])
    addon.flatten.read.check_current(bpy.context, models, bpy.context.scene.wirewarp)
    source.data.vertices[0].co.z += 1
    with pytest.raises(addon.issues.ObjectError, match='"Bump" changed during the run, so nothing was written'):
        addon.flatten.read.check_current(bpy.context, models, bpy.context.scene.wirewarp)


def in_another_scene(data):
    """Makes a scene with one object of this mesh the one that is worked in."""
    scene, other = bpy.data.scenes.new("Other"), bpy.data.objects.new("Other", data)
    scene.collection.objects.link(other)
    view_layer = scene.view_layers[0]
    view_layer.objects.active = other
    other.select_set(True, view_layer=view_layer)
    window = bpy.context.window_manager.windows[0]
    return bpy.context.temp_override(window=window, scene=scene, view_layer=view_layer)


def test_a_mesh_that_is_edited_in_another_scene(source):
    mark(source, on_line(0, 0.0))
    bpy.ops.object.mode_set(mode="EDIT")
    with in_another_scene(source.data):
        flatten_fails('The mesh "Bump" is being edited in another scene or view layer: leave Edit Mode there first')
    assert "Other Flat" not in bpy.data.objects


def test_flat_pieces_that_are_edited_in_another_scene(source, addon):
    bpy.ops.object.wirewarp_flatten()
    select_only(flat_of(source))
    bpy.ops.object.mode_set(mode="EDIT")
    with pytest.raises(addon.issues.ObjectError, match='The mesh "Bump Flat" is being edited in another scene'):
        addon.flatten.read.check_target(source, writes_model=True)
    with pytest.raises(addon.issues.ObjectError, match='The mesh "Bump Flat" is being edited in another scene'):
        addon.export.read.read_pattern(bpy.context.scene, source)


def test_no_file_of_ours_takes_the_place_of_a_blender_file(source, tmp_path):
    path = tmp_path / "model.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    before = path.read_bytes()
    source = bpy.data.objects["Bump"]
    select_only(source)
    flatten_fails("a Blender file has this name", report_path=str(path))
    assert nothing_written(source)
    bpy.ops.object.wirewarp_flatten()
    with pytest.raises(RuntimeError, match="its name must end in .svg"):
        bpy.ops.object.wirewarp_export_svg(filepath=str(path))
    assert path.read_bytes() == before


@pytest.mark.parametrize("name", ["pattern.pdf", "pattern.dxf", "pattern"])
def test_a_pattern_goes_into_an_svg_file_only(source, tmp_path, name):
    bpy.ops.object.wirewarp_flatten()
    with pytest.raises(RuntimeError, match="its name must end in .svg"):
        bpy.ops.object.wirewarp_export_svg(filepath=str(tmp_path / name))
    assert list(tmp_path.iterdir()) == []


def test_a_folder_of_too_long_a_name_is_a_sentence(source, tmp_path):
    flatten_fails("Cannot write .*: (File name too long|there is no folder)", report_path=f"{tmp_path}/{'n' * 300}/r")
    assert nothing_written(source)


def test_a_model_too_large_for_true_areas(source):
    for vertex in source.data.vertices:
        vertex.co *= 1e25
    flatten_fails('"Bump" is more than 1e.18 Blender units wide, too large for true areas: scale it down')
    assert nothing_written(source)


@pytest.mark.parametrize(("name", "file"), [("Front/Back", "Front_Back"), ("/etc", "_etc"), ('a:b\\"c', "a_b__c")])
def test_the_name_proposed_for_a_pattern_is_one_of_a_file(addon, name, file):
    assert addon.blender.files.file_name(name, " Pattern.svg") == f"{file} Pattern.svg"


def test_a_long_name_leaves_room_for_what_makes_it_a_pattern(addon):
    name = addon.blender.files.file_name("ä" * 300, " Pattern.svg")
    assert name.startswith("ää")
    assert name.endswith("ä Pattern.svg")
    assert len(name.encode()) <= 255


def test_more_notches_than_anybody_cuts(source, tmp_path):
    for edge in source.data.edges:
        edge.use_seam = all(abs(source.data.vertices[vertex].co.x) < 1e-6 for vertex in edge.vertices)
    for vertex in source.data.vertices:
        vertex.co *= 1000
    bpy.ops.object.wirewarp_flatten()
    path = tmp_path / "pattern.svg"
    with pytest.raises(RuntimeError, match=r"Seam 1 is 2,\d\d\d m long, too long for a notch .*unit of the model"):
        bpy.ops.object.wirewarp_export_svg(filepath=str(path), notch_spacing=10)
    assert not path.exists()
    assert bpy.ops.object.wirewarp_export_svg(filepath=str(path), notch_spacing=0) == {"FINISHED"}
