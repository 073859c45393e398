# SPDX-License-Identifier: GPL-3.0-or-later
"""A file without a model offers samples, which are added with all that belongs to them, and a guide."""

import bpy
import pytest
from everything import draw_panels

pytestmark = pytest.mark.api


def test_an_empty_file_offers_samples_and_the_guide(addon):
    buttons = []
    assert "try a sample" in draw_panels(addon, buttons)
    assert "wm.wirewarp_guide" in buttons


@pytest.mark.parametrize("place", range(4))
def test_a_sample_is_added_with_its_fabric_and_is_ready_to_cut(addon, place):
    sample, *_ = addon.report_panel.first_steps.SAMPLES[place]
    scenes = len(bpy.data.scenes)
    assert bpy.ops.object.wirewarp_open_sample(sample=sample) == {"FINISHED"}
    source = bpy.context.active_object
    assert source.select_get() and len(bpy.data.scenes) == scenes
    settings = bpy.context.scene.wirewarp
    assert bpy.context.scene.unit_settings.length_unit == "MILLIMETERS"
    bpy.ops.object.wirewarp_flatten(cloth=settings.cloth, fairness=settings.fairness)
    assert addon.core.verdict(addon.state.reports.last_report(source)).is_ready
    assert "try a sample" not in draw_panels(addon)


def test_all_samples_that_are_offered_are_in_the_zip(addon):
    module = addon.report_panel.first_steps
    assert {path.stem for path in module.FOLDER.glob("*.blend")} == {name.lower() for name, *_ in module.SAMPLES}
