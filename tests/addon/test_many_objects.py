# SPDX-License-Identifier: GPL-3.0-or-later
"""A file with thousands of objects that do not concern us: they are asked once, and not at every redraw."""

import bpy
import pytest
from surfaces import bump, grid, mark, on_line
from view_context import view_context

OTHERS = 300


@pytest.fixture
def source():
    target = grid("Bump", bump)
    mesh = bpy.data.meshes.new("Other")
    for number in range(OTHERS):
        bpy.context.scene.collection.objects.link(bpy.data.objects.new(f"Other {number}", mesh))
    bpy.context.view_layer.update()
    return target


@pytest.fixture
def asked(addon, monkeypatch):
    """The objects that are asked whether they concern us."""
    names = []
    ask = addon.overlay.shown.concerns_us
    monkeypatch.setattr(addon.overlay.shown, "concerns_us", lambda each: names.append(each.name) or ask(each))
    addon.state.memory.forget()
    return names


def drawn(addon):
    return {drawing.target.name for drawing in addon.overlay.shown.drawings(view_context())}


def test_objects_are_asked_again_only_when_they_change(addon, source, asked):
    assert drawn(addon) == set()
    assert len(asked) == OTHERS + 1
    asked.clear()
    assert drawn(addon) == set()
    assert asked == []
    bpy.data.objects["Other 7"].location.x = 1
    bpy.context.view_layer.update()
    drawn(addon)
    assert asked == ["Other 7"]


def test_what_is_marked_flattened_renamed_and_removed_is_seen(addon, source, asked):
    assert drawn(addon) == set()
    mark(source, on_line(1, 0.0))
    assert drawn(addon) == {"Bump"}
    bpy.ops.object.wirewarp_flatten()
    assert drawn(addon) == {"Bump", "Bump Flat"}
    source.name = "Sleeve"
    assert drawn(addon) == {"Sleeve", "Bump Flat"}
    bpy.data.objects.remove(bpy.data.objects["Bump Flat"])
    assert drawn(addon) == {"Sleeve"}


def test_the_report_of_a_failure_is_seen(addon, source, asked):
    assert drawn(addon) == set()
    source.data.vertices[0].co.x = float("nan")
    with pytest.raises(RuntimeError, match="not numbers, or far"):
        bpy.ops.object.wirewarp_flatten()
    assert drawn(addon) == {"Bump"}


def test_hidden_objects_and_those_of_other_scenes_are_not_drawn(addon, source):
    mark(source, on_line(1, 0.0))
    assert drawn(addon) == {"Bump"}
    source.hide_set(True)
    assert drawn(addon) == set()
    source.hide_set(False)
    bpy.context.scene.collection.objects.unlink(source)
    assert drawn(addon) == set()
