# SPDX-License-Identifier: GPL-3.0-or-later
"""A file without a model offers samples, which are added with everything they need, and a guide."""

import blf
import bpy
import pytest
from everything import draw_panels
from surfaces import bump, grid, world_box

pytestmark = pytest.mark.api


def test_an_empty_file_offers_samples_and_the_guide(addon):
    buttons = []
    assert "try a sample" in draw_panels(addon, buttons)
    assert "wm.wirewarp_guide" in buttons


@pytest.mark.parametrize("place", range(4))
def test_a_sample_is_added_with_its_fabric_and_is_ready_to_cut(addon, place):
    sample, *_ = addon.report_panel.next_step.SAMPLES[place]
    scenes = len(bpy.data.scenes)
    assert bpy.ops.object.wirewarp_open_sample(sample=sample) == {"FINISHED"}
    source = bpy.context.active_object
    assert source.select_get() and len(bpy.data.scenes) == scenes
    settings = bpy.context.scene.wirewarp
    assert bpy.context.scene.unit_settings.length_unit == "MILLIMETERS"
    bpy.ops.object.wirewarp_flatten(cloth=settings.cloth, fairness=settings.fairness)
    assert addon.core.verdict(addon.state.reports.last_report(source)).is_ready
    assert "try a sample" not in draw_panels(addon)


def test_a_sample_in_a_file_with_models_leaves_its_settings_and_has_its_size(addon):
    grid("Bump", bump)
    scene = bpy.context.scene
    scene.unit_settings.scale_length, scene.wirewarp.cloth = 0.01, "DENIM"
    bpy.ops.object.wirewarp_open_sample(sample="FITTED_TOP")
    assert scene.wirewarp.cloth == "DENIM" and scene.unit_settings.scale_length == pytest.approx(0.01)
    assert world_box(bpy.context.active_object)[0, 0] > 1  # the right edge of the other
    height = bpy.context.active_object.dimensions.z * scene.unit_settings.scale_length
    assert 0.5 < height < 1


def test_a_sample_beside_the_cube_of_a_new_file_brings_its_fabric_and_in_an_empty_one_its_units():
    scene = bpy.context.scene
    bpy.ops.mesh.primitive_cube_add()
    scene.unit_settings.length_unit = "METERS"
    bpy.ops.object.wirewarp_open_sample(sample="FITTED_TOP")
    assert (scene.wirewarp.cloth, scene.unit_settings.length_unit) == ("JERSEY", "METERS")
    bpy.ops.object.wirewarp_flatten(cloth="JERSEY")
    scene.wirewarp.property_unset("cloth")
    bpy.ops.object.wirewarp_open_sample(sample="JEANS")
    assert scene.wirewarp.cloth == "NONE"  # the first pattern was made
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.context.scene.unit_settings.scale_length = 0.01
    bpy.ops.object.wirewarp_open_sample(sample="CUSHION")
    assert bpy.context.scene.unit_settings.scale_length == 1


def test_a_sample_that_is_not_there_is_named(addon, monkeypatch, tmp_path):
    monkeypatch.setattr(addon.report_panel.next_step, "FOLDER", tmp_path)
    with pytest.raises(RuntimeError, match='"cushion.blend" is not installed'):
        bpy.ops.object.wirewarp_open_sample(sample="CUSHION")


def test_the_guide_fits_its_popup_and_all_samples_are_in_the_zip(addon):
    module = addon.report_panel.next_step
    assert {path.stem for path in module.FOLDER.glob("*.blend")} == {name.lower() for name, *_ in module.SAMPLES}
    blf.size(0, 11)
    assert max(blf.dimensions(0, step)[0] for step in module.STEPS) < module.WIDTH - 40
