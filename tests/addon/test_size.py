# SPDX-License-Identifier: GPL-3.0-or-later
"""Models that are too large or small to sew are reported, with units that would work."""

import math

import bpy
import pytest
from everything import draw_panels
from surfaces import bump, flat_of, grid


@pytest.fixture
def sized(addon):
    """Make a model this many Blender units wide; return the sentence on its size and the offered units."""

    def make(width):
        source = grid("Chair", lambda x, y: [width / 2 * value for value in bump(x, y)])
        bpy.context.view_layer.update()
        size = addon.blender.objects
        offered = [size.unit_text(source, unit) for unit in size.likely_units(source)]
        return size.strange_size(source, bpy.context.scene), offered

    return make


def test_units_that_give_a_size_to_sew_are_offered_the_likeliest_first(sized):
    sentence, offered = sized(77)
    assert sentence == '"Chair" is 77 m large. Was it modeled in another unit?'
    assert offered == ["Centimeters: 77 cm", "Millimeters: 7.7 cm", "Inches: 196 cm"]
    assert sized(14.5)[1][0] == "Decimeters: 145 cm"  # as in MakeHuman
    assert sized(939)[1] == ["Millimeters: 93.9 cm"]
    sentence, offered = sized(0.0017)
    assert sentence.endswith("is 1.7 mm small. Was it modeled in another unit?")
    assert offered == ["100 m: 17 cm", "1000 m: 170 cm"]
    assert [sized(width)[0] for width in (0.03, 0.2, 2, 4.9)] == [""] * 4  # of common size


def test_one_click_makes_the_pattern_as_large_as_the_model_was_meant(addon, sized):
    sized(77)
    buttons = []
    assert "Was it modeled in another unit?" in draw_panels(addon, buttons)
    assert "scene.wirewarp_set_unit" in buttons
    assert bpy.ops.scene.wirewarp_set_unit(meters=0.01) == {"FINISHED"}
    assert "another unit" not in draw_panels(addon)
    bpy.ops.object.wirewarp_flatten()
    report = addon.state.reports.last_report(bpy.data.objects["Chair"])
    assert report.meters == pytest.approx(0.01)
    assert flat_of(bpy.data.objects["Chair"]).dimensions.x > 77


def test_the_unit_follows_from_the_height_that_the_model_should_have(addon, sized):
    sized(77)
    source, buttons = bpy.data.objects["Chair"], []
    draw_panels(addon, buttons)
    assert buttons.count("scene.wirewarp_set_unit") == 4 * 2  # three units and the height, narrow and wide
    across = source.dimensions.x
    source.rotation_euler.y = math.pi / 2  # as importers rotate models
    bpy.context.view_layer.update()
    assert addon.blender.objects.unit_of_height(source, 1.2) == pytest.approx(1.2 / across)
    source.rotation_euler.y = 0.0
    bpy.context.view_layer.update()
    meters = addon.blender.objects.unit_of_height(source, 1.2)
    bpy.ops.scene.wirewarp_set_unit(meters=meters)
    assert source.dimensions.z * addon.blender.objects.meters_per_blender_unit(bpy.context.scene) == pytest.approx(1.2)
    bpy.context.scene.unit_settings.system = "NONE"  # a scene without units gets some
    assert sized(150)[0]
    bpy.ops.scene.wirewarp_set_unit(meters=0.01)
    assert addon.blender.objects.strange_size(bpy.context.active_object, bpy.context.scene) == ""
