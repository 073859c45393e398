# SPDX-License-Identifier: GPL-3.0-or-later
"""Name and area on each flat piece."""

import bpy
import numpy as np
import pytest
from mathutils import Vector
from surfaces import bump, flat_of, flatten, grid, make_object, mark, mark_seam, on_line, read, select_only


@pytest.fixture
def source():
    """Two pieces with a wire through both; a Blender unit is 100 mm."""
    units = bpy.context.scene.unit_settings
    units.scale_length, units.length_unit = 0.1, "MILLIMETERS"
    target = grid("Bump", bump)
    mark_seam(target, on_line(0, 0.0))
    mark(target, on_line(1, 0.0))
    bpy.ops.object.wirewarp_flatten()
    return target


def texts():
    return {target.data.body.split("\n")[0]: target for target in bpy.data.objects if target.type == "FONT"}


def corners(text):
    """On the plane of the flat object."""
    bpy.context.view_layer.update()
    to_flat = text.parent.matrix_world.inverted() @ text.matrix_world
    return [(to_flat @ Vector(corner)).to_2d() for corner in text.bound_box]


def outline_of(source, addon, name):
    index = [entry.name for entry in source.wirewarp_pieces].index(name)
    flat = addon.flat.read.read_flat_pieces(flat_of(source).data, 1.0)
    outline = addon.pattern.outlines.outline_of(flat)
    a, b = outline.edges[outline.piece == index].T
    return addon.pattern.polygons.Segments(flat.vertices[a], flat.vertices[b])


def test_each_piece_has_a_text_with_its_name_and_area_inside_its_outline(source, addon):
    report = addon.flat.reports.last_report(source)
    assert sorted(texts()) == ["Top Left", "Top Right"]
    for piece in report["pieces"]:
        text = texts()[piece["name"]]
        assert text.data.body.split("\n")[1] == f"{100 * piece['area_2d']:.1f} cm²"
        outline = outline_of(source, addon, piece["name"])
        assert addon.pattern.polygons.are_inside(np.array(corners(text)), outline).all()
        assert text.parent == flat_of(source)
        assert [collection.name for collection in text.users_collection] == ["WireWarp"]
        height = np.ptp(np.array(corners(text)), axis=0).min()
        assert height > 0.05  # of a piece of 1 by 2: to be read


def test_a_text_moves_with_the_object_and_with_its_piece(source):
    flat, text = flat_of(source), texts()["Top Left"]
    before = np.array(corners(text))
    flat.location, flat.rotation_euler = (5, 6, 7), (0.1, 0.2, 0.3)
    assert np.array(corners(text)) == pytest.approx(before, abs=1e-5)
    for vertex in flat.data.vertices:  # a quarter turn
        vertex.co = (-vertex.co.y, vertex.co.x + 1, 0)
    flat.data.update_tag()
    turned = np.column_stack([-before[:, 1], before[:, 0] + 1])
    assert np.array(corners(text)) == pytest.approx(turned, abs=1e-5)


def test_no_line_is_drawn_from_a_piece_to_its_text(source):
    """Blender draws one from the middle of the three vertices of the parent to the object's origin."""
    flat = flat_of(source)
    for text in texts().values():
        middle = sum((flat.data.vertices[k].co for k in text.parent_vertices), Vector()) / 3
        assert tuple(text.matrix_world.translation) == pytest.approx(tuple(flat.matrix_world @ middle), abs=1e-5)


@pytest.mark.parametrize("angle", [0, 90])
def test_a_text_stands_in_its_place_wherever_its_origin_is(source, addon, angle):
    place = addon.pattern.pattern.PieceText(("Hx",), np.array([0.3, 0.4]), 0.1, angle)
    text = addon.flat.texts._new_text(flat_of(source), "Hx", place, np.array([0.2, 0.1]), 0.002)
    bpy.context.scene.collection.objects.link(text)
    assert np.mean(corners(text), axis=0) == pytest.approx([0.3, 0.4], abs=0.03)


def test_texts_are_right_where_their_collection_was_hidden(source, addon):
    layer = bpy.context.view_layer.layer_collection.children["WireWarp"]
    layer.exclude = True
    flatten(source)
    layer.exclude = False
    for name, text in texts().items():
        assert addon.pattern.polygons.are_inside(np.array(corners(text)), outline_of(source, addon, name)).all()


def test_a_text_keeps_off_the_wire(source):
    flat = flat_of(source).data
    wire = read(flat.attributes["wirewarp_wire"].data, "value", np.int32) != 0
    places = read(flat.vertices, "co", np.float32, 3)[read(flat.edges, "vertices", np.int32, 2)[wire]][:, :, :2]
    for text in texts().values():
        low, high = np.min(corners(text), axis=0), np.max(corners(text), axis=0)
        assert not np.any(np.all((places.max(axis=1) > low) & (places.min(axis=1) < high), axis=1))


def test_a_narrow_upright_piece_has_an_upright_text(addon):
    vertices = [(x, y, 0) for y in range(21) for x in (0, 1)]
    strip = make_object("Strip", vertices, [[2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2] for k in range(20)])
    mark(strip, lambda a, b: a.x == b.x == 0)
    bpy.ops.object.wirewarp_flatten()
    (text,) = texts().values()
    width, height = np.ptp(np.array(corners(text)), axis=0)
    assert height > 1.2 * width
    assert addon.pattern.polygons.are_inside(np.array(corners(text)), outline_of(strip, addon, "Strip")).all()


def test_texts_are_replaced_renamed_and_switched_off(source):
    before = len(bpy.data.objects), len(bpy.data.curves)
    flatten(source)
    assert (len(bpy.data.objects), len(bpy.data.curves)) == before
    next(entry for entry in source.wirewarp_pieces if entry.name == "Top Left").name = "Sleeve"
    assert sorted(texts()) == ["Sleeve", "Top Right"]
    area = texts()["Sleeve"].data.body.split("\n")[1]
    assert area.endswith(" cm²")
    flatten(source, piece_texts=False)
    assert texts() == {}
    assert not bpy.data.curves


def test_areas_follow_the_units_of_the_scene_and_names_stay(source, addon):
    (piece,) = [each for each in addon.flat.reports.last_report(source)["pieces"] if each["name"] == "Top Left"]
    text, units = texts()["Top Left"], bpy.context.scene.unit_settings
    area = 0.1**2 * piece["area_2d"]  # in square meters
    assert text.data.body == f"Top Left\n{1e4 * area:.1f} cm²"
    text.data.body = f"Sleeve\n{1e4 * area:.1f} cm²\ncut twice"
    units.system, units.length_unit = "IMPERIAL", "INCHES"
    addon.flat.texts.write_all_areas()
    assert text.data.body == f"Sleeve\n{area / 0.0254**2:.2f} in²\ncut twice"
    units.system, units.length_unit = "METRIC", "MILLIMETERS"
    addon.flat.texts.write_all_areas()
    assert text.data.body == f"Sleeve\n{1e4 * area:.1f} cm²\ncut twice"


@pytest.mark.parametrize("own", ["Sleeve", "Front\nCut 2 on fold", "Front\n\ncut twice"])
def test_a_line_of_the_user_is_no_area(source, addon, own):
    text, units = texts()["Top Left"], bpy.context.scene.unit_settings
    text.data.body = own
    addon.flat.texts.write_all_areas()
    units.system, units.length_unit = "IMPERIAL", "INCHES"
    addon.flat.texts.write_all_areas()
    assert text.data.body == own


def test_texts_of_a_deleted_flat_object_go_with_the_next_run(source):
    select_only(flat_of(source))
    bpy.ops.object.delete()
    flatten(source)
    assert len(texts()) == 2
    assert all(text.parent == flat_of(source) for text in texts().values())


def test_a_text_that_the_user_has_taken_off_its_piece_stays(source):
    own = texts()["Top Left"]
    own.name = own.data.name = "Mine"
    select_only(own)
    bpy.ops.object.parent_clear(type="CLEAR_KEEP_TRANSFORM")
    flatten(source)
    assert "Mine" in bpy.data.objects
    assert len([target for target in bpy.data.objects if target.type == "FONT"]) == 3


def test_the_overlay_writes_no_names_where_texts_stand(source, addon):
    def shown():
        depsgraph = bpy.context.evaluated_depsgraph_get()
        return {name.text for name in addon.overlay.objects.marked_lines(flat_of(source), depsgraph).names}

    assert not {"Top Left", "Top Right"} & shown()
    flatten(source, piece_texts=False)
    assert {"Top Left", "Top Right"} <= shown()


def test_a_flat_object_scaled_to_nothing_by_its_parent_is_flattened_all_the_same(source):
    parent = bpy.data.objects.new("Parent", None)
    bpy.context.scene.collection.objects.link(parent)
    flat_of(source).parent = parent
    parent.scale = (0, 0, 0)
    flatten(source)
    assert sorted(texts()) == ["Top Left", "Top Right"]


def test_very_many_pieces_get_no_texts_and_that_is_said(addon):
    source = grid("Tiles", bump, size=15)
    source.data.edges.foreach_set("use_seam", [True] * len(source.data.edges))
    bpy.ops.object.wirewarp_flatten()
    assert texts() == {}
    (note,) = addon.flat.reports.last_report(source)["notes"]
    assert note["text"] == "Texts are written on up to 200 pieces, these are 225."
