# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel offers samples and a guide in a file without a model, and other units for a model of implausible size."""

import math
from types import SimpleNamespace

import blf
import bpy
import pytest
from everything import draw_panels, drawn_buttons
from flattening import fails, report_after, world_box
from surfaces import bump, flat_of, grid

pytestmark = pytest.mark.api


def test_an_empty_file_offers_samples_and_the_guide(addon):
    assert "try a sample" in draw_panels(addon) and "wm.wirewarp_guide" in drawn_buttons(addon)


@pytest.mark.parametrize("place", range(5))
def test_a_sample_is_added_with_its_fabric_and_is_ready_to_cut(addon, place):
    sample, *_ = addon.report_panel.next_step.SAMPLES[place]
    scenes = len(bpy.data.scenes)
    assert bpy.ops.object.wirewarp_open_sample(sample=sample) == {"FINISHED"}
    source = bpy.context.active_object
    assert source.select_get() and len(bpy.data.scenes) == scenes
    settings = bpy.context.scene.wirewarp
    assert bpy.context.scene.unit_settings.length_unit == "MILLIMETERS"
    assert addon.core.verdict(report_after(addon, source, cloth=settings.cloth, fairness=settings.fairness)).is_ready
    assert "try a sample" not in draw_panels(addon)


def test_a_sample_keeps_its_size_and_the_settings_of_a_file_with_models(addon):
    grid("Bump", bump)
    scene = bpy.context.scene
    scene.unit_settings.scale_length, scene.wirewarp.cloth = 0.01, "DENIM"
    bpy.ops.object.wirewarp_open_sample(sample="FITTED_TOP")
    assert scene.wirewarp.cloth == "DENIM" and scene.unit_settings.scale_length == pytest.approx(0.01)
    assert world_box(bpy.context.active_object)[0, 0] > 1  # beside the other model, which ends at x = 1
    height = bpy.context.active_object.dimensions.z * scene.unit_settings.scale_length
    assert 0.5 < height < 1


def test_a_sample_brings_its_fabric_to_a_new_file_and_its_units_to_an_empty_one():
    scene = bpy.context.scene
    bpy.ops.mesh.primitive_cube_add()
    scene.unit_settings.length_unit = "METERS"
    bpy.ops.object.wirewarp_open_sample(sample="FITTED_TOP")
    assert (scene.wirewarp.cloth, scene.unit_settings.length_unit) == ("JERSEY", "METERS")
    bpy.ops.object.wirewarp_flatten(cloth="JERSEY")
    scene.wirewarp.property_unset("cloth")
    bpy.ops.object.wirewarp_open_sample(sample="JEANS")
    assert scene.wirewarp.cloth == "NONE"  # After the first run, samples do not change settings.
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.context.scene.unit_settings.scale_length = 0.01
    bpy.ops.object.wirewarp_open_sample(sample="CUSHION")
    assert bpy.context.scene.unit_settings.scale_length == 1


def test_a_missing_sample_is_named(addon, monkeypatch, tmp_path):
    monkeypatch.setattr(addon.report_panel.next_step, "FOLDER", tmp_path)
    fails(bpy.ops.object.wirewarp_open_sample, '"cushion.blend" is not installed', sample="CUSHION")


def test_the_guide_fits_its_popup_and_all_samples_are_in_the_zip(addon):
    module = addon.report_panel.next_step
    assert {path.stem for path in module.FOLDER.glob("*.blend")} == {name.lower() for name, *_ in module.SAMPLES}
    blf.size(0, 11)
    assert max(blf.dimensions(0, step)[0] for step in module.STEPS) < module.WIDTH - 40


@pytest.fixture
def sized(addon):
    """Return a function that makes a model of a given width in Blender units.

    The function returns the sentence about the size of the model, and the units that are offered.
    """

    def make(width):
        source = grid("Chair", lambda x, y: [width / 2 * value for value in bump(x, y)])
        bpy.context.view_layer.update()
        size = addon.blender.objects
        offered = [size.unit_text(source, unit) for unit in size.likely_units(source)]
        return size.strange_size(source, bpy.context.scene), offered

    return make


def test_units_for_a_plausible_size_are_offered_and_the_likeliest_is_first(sized):
    sentence, offered = sized(77)
    assert sentence == '"Chair" measures 77 m. Was it modeled in another unit?'
    assert offered == ["Centimeters: 77 cm", "Millimeters: 7.7 cm", "Inches: 196 cm"]
    assert sized(14.5)[1][0] == "Decimeters: 145 cm"  # MakeHuman uses decimeters
    assert sized(939)[1] == ["Millimeters: 93.9 cm"]
    sentence, offered = sized(0.0017)
    assert sentence.endswith("measures 1.7 mm. Was it modeled in another unit?")
    assert offered == ["100 m: 17 cm", "1000 m: 170 cm"]
    assert [sized(width)[0] for width in (0.03, 0.2, 2, 4.9)] == [""] * 4  # common sizes


def test_one_click_gives_the_pattern_the_intended_size(addon, sized):
    sized(77)
    assert "Was it modeled in another unit?" in draw_panels(addon)
    count = drawn_buttons(addon).count("scene.wirewarp_set_unit")
    assert count and bpy.ops.scene.wirewarp_set_unit(meters=0.01) == {"FINISHED"}
    said = draw_panels(addon)
    assert "another unit" not in said and '"Chair" now measures 77 cm.' in said
    # The buttons keep their places under the mouse until the next run.
    assert drawn_buttons(addon).count("scene.wirewarp_set_unit") == count
    bpy.ops.object.wirewarp_flatten()
    assert "now measures" not in draw_panels(addon) and "scene.wirewarp_set_unit" not in drawn_buttons(addon)
    report = addon.state.reports.last_report(bpy.data.objects["Chair"])
    assert report.meters == pytest.approx(0.01)
    assert flat_of(bpy.data.objects["Chair"]).dimensions.x > 77


def begun_height(addon):
    """Return the height in cm that the dialog of Set Model Height shows first."""
    dialog = SimpleNamespace(height=None)
    manager = SimpleNamespace(invoke_props_dialog=lambda _: {"RUNNING_MODAL"})
    context = SimpleNamespace(active_object=bpy.context.active_object, scene=bpy.context.scene, window_manager=manager)
    addon.marks.mark_operators.SCENE_OT_wirewarp_set_height.invoke(dialog, context, None)
    return dialog.height


def test_a_flat_model_has_no_height_to_set(addon, sized):
    sized(77)
    bpy.context.object.scale.z = 0.0
    bpy.context.view_layer.update()
    buttons = drawn_buttons(addon)
    assert "scene.wirewarp_set_unit" in buttons and "scene.wirewarp_set_height" not in buttons
    fails(bpy.ops.scene.wirewarp_set_height, "is flat and has no height", height=120)


def test_the_unit_follows_from_the_real_height(addon, sized):
    sized(77)
    source, buttons = bpy.data.objects["Chair"], drawn_buttons(addon)
    # Each panel is drawn twice: narrow and wide.
    assert buttons.count("scene.wirewarp_set_unit") == 3 * 2 and buttons.count("scene.wirewarp_set_height") == 2
    assert begun_height(addon) == pytest.approx(100 * source.dimensions.z)
    across = source.dimensions.x
    source.rotation_euler.y = math.pi / 2
    bpy.context.view_layer.update()
    bpy.ops.scene.wirewarp_set_height(height=120)
    unit = addon.blender.objects.meters_per_blender_unit
    assert unit(bpy.context.scene) == pytest.approx(1.2 / across)
    assert begun_height(addon) == pytest.approx(120)
    source.rotation_euler.y = 0.0
    bpy.context.view_layer.update()
    bpy.ops.scene.wirewarp_set_height(height=120)
    assert source.dimensions.z * unit(bpy.context.scene) == pytest.approx(1.2)
    bpy.context.scene.unit_settings.system = "NONE"  # Set Unit also works in a scene without units.
    assert sized(150)[0]
    bpy.ops.scene.wirewarp_set_unit(meters=0.01)
    assert addon.blender.objects.strange_size(bpy.context.active_object, bpy.context.scene) == ""
