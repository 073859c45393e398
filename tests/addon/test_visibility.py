# SPDX-License-Identifier: GPL-3.0-or-later
"""If objects are hidden, deleted or scaled, results are correct and visible, or a sentence reports the problem."""

import bpy
import numpy as np
import pytest
from flattening import edge_lengths, fails, flatten, flatten_fails, flattened, world_box
from surfaces import bump, flat_of, new_object, select_only

pytestmark = pytest.mark.api


def failed_source():
    """Return a model with flat pieces. A later run has failed, and its report names faulty elements."""
    source = flattened("Bump", bump)
    source.data.vertices[0].co = source.data.vertices[1].co
    flatten_fails("no area")
    return source


def layer_collection(name):
    return bpy.context.view_layer.layer_collection.children[name]


def exclude(source):
    collection = bpy.data.collections.new("Models")
    bpy.context.scene.collection.children.link(collection)
    collection.objects.link(source)
    bpy.context.scene.collection.objects.unlink(source)
    layer_collection("Models").exclude = True


def disable(source):
    source.hide_viewport = True


@pytest.mark.parametrize(
    ("hide", "sentence"),
    [
        (lambda source: bpy.data.scenes[0].collection.objects.unlink(source), "was deleted, or its collection is"),
        (exclude, "was deleted, or its collection is excluded"),
        (disable, "is disabled in viewports"),
    ],
)
def test_select_issues_if_the_model_cannot_be_shown(hide, sentence):
    source = failed_source()
    flat = flat_of(source)
    hide(source)
    select_only(flat)
    fails(bpy.ops.mesh.wirewarp_select_issues, f'"Bump" .*{sentence}.*Outliner')
    assert bpy.context.mode == "OBJECT"


def test_select_issues_shows_a_hidden_model():
    source = failed_source()
    source.hide_set(True)
    bpy.context.view_layer.objects.active = flat_of(source)
    assert bpy.ops.mesh.wirewarp_select_issues() == {"FINISHED"}
    assert (source.visible_get(), source.mode) == (True, "EDIT")


def notes(addon, source):
    return [note.text for note in addon.state.reports.last_report(source).notes]


def test_flattening_again_restores_the_actual_size_and_keeps_the_place(addon):
    source = flattened("Bump", bump)
    flat = flat_of(source)
    before = edge_lengths(flat)
    flat.location, flat.rotation_euler, flat.scale, flat.delta_scale = (5, 6, 7), (0, 0, 1), (2, 2, 2), (3, 1, 1)
    flatten(source)
    assert tuple(flat.location) == (5, 6, 7) and edge_lengths(flat) == pytest.approx(before, rel=1e-5)
    assert notes(addon, source) == []


def are_apart(first, second):
    """Return whether the boxes are apart, seen from above."""
    (low, high), (bottom, top) = world_box(first), world_box(second)
    return bool(np.any((high <= bottom) | (top <= low)))


def neighbor(x, bottom, top, size=0.5):
    """Add a box at this x, beside the middle of the model. size: width and depth."""
    bpy.ops.mesh.primitive_cube_add(size=1, location=(x, 0, (bottom + top) / 2), scale=(size, size, top - bottom))
    return bpy.context.object


def test_new_pieces_do_not_overlap_objects_beside_the_model():
    standing = [neighbor(2.0, 0.0, 1.0), neighbor(4.6, -1.0, 1.0)]
    source = flattened("Bump", bump)
    assert all(are_apart(flat_of(source), each) for each in standing)
    place = tuple(flat_of(source).location)
    neighbor(*flat_of(source).location[:1], 0.0, 1.0)
    flatten(source)
    assert tuple(flat_of(source).location) == place


@pytest.mark.parametrize(
    ("bottom", "top", "size"),
    [(-1.0, 0.0, 0.5), (0.5, 1.0, 0.5), (-1.0, 8.0, 30.0)],
    ids=["below the floor", "hanging", "a room around all"],
)
def test_pieces_do_not_avoid_objects_elsewhere(bottom, top, size):
    source = flattened("Bump", bump)
    expected = flat_of(source).location.x
    bpy.data.objects.remove(flat_of(source))
    neighbor(2.0, bottom, top, size)
    flatten(source)
    assert flat_of(source).location.x == pytest.approx(expected)


def parented(flat):
    parent = flat.parent = new_object("Parent")
    parent.scale = (2, 2, 2)


SAID = {  # how the pieces are changed, and the resulting message
    "parent": (parented, '"Bump Flat" is not shown in actual size'),
    "disabled": (disable, '"Bump Flat" is hidden: it is disabled in viewports'),
    "excluded": (
        lambda _: setattr(layer_collection("WireWarp"), "exclude", True),
        '"Bump Flat" is hidden: it is disabled in viewports, or its collection is hidden',
    ),
    "collection": (
        lambda _: setattr(layer_collection("WireWarp"), "hide_viewport", True),
        '"Bump Flat" is hidden: it is disabled in viewports, or its collection is hidden',
    ),
}


@pytest.mark.parametrize("how", SAID)
def test_pieces_that_stay_hidden_or_scaled_are_reported(addon, how):
    source = flattened("Bump", bump)
    flat = flat_of(source)
    flat.hide_set(True)
    flatten(source)
    assert flat.visible_get() and notes(addon, source) == []  # Flatten shows pieces that the eye icon has hidden.
    change, said = SAID[how]
    change(flat)
    flatten(source)
    (note,) = notes(addon, source)
    assert said in note and flat.hide_viewport == (how == "disabled")
