# SPDX-License-Identifier: GPL-3.0-or-later
"""What is hidden, excluded, deleted or scaled: results stay true and in sight, and what cannot be shown is said."""

import bpy
import pytest
from surfaces import bump, edge_lengths, flat_of, grid, select_only


def failed_source():
    """A source whose report names elements, with flat pieces of an earlier run."""
    source = grid("Bump", bump)
    bpy.ops.object.wirewarp_flatten()
    source.data.vertices[0].co = source.data.vertices[1].co
    with pytest.raises(RuntimeError, match="no area"):
        bpy.ops.object.wirewarp_flatten()
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
def test_select_issues_where_the_model_cannot_be_shown(hide, sentence):
    source = failed_source()
    flat = flat_of(source)
    hide(source)
    select_only(flat)
    with pytest.raises(RuntimeError, match=f'"Bump" .*{sentence}.*Outliner'):
        bpy.ops.mesh.wirewarp_select_issues()
    assert bpy.context.mode == "OBJECT"


def test_select_issues_shows_a_hidden_model():
    source = failed_source()
    source.hide_set(True)
    bpy.context.view_layer.objects.active = flat_of(source)
    assert bpy.ops.mesh.wirewarp_select_issues() == {"FINISHED"}
    assert (source.visible_get(), source.mode) == (True, "EDIT")


def flatten_again(source):
    select_only(source)
    bpy.ops.object.wirewarp_flatten()


def notes(addon, source):
    return [note["text"] for note in addon.report_store.last_report(source)["notes"]]


def test_flattening_again_makes_the_size_true_and_keeps_the_place(addon):
    source = grid("Bump", bump)
    bpy.ops.object.wirewarp_flatten()
    flat = flat_of(source)
    before = edge_lengths(flat)
    flat.location, flat.rotation_euler, flat.scale, flat.delta_scale = (5, 6, 7), (0, 0, 1), (2, 2, 2), (3, 1, 1)
    flatten_again(source)
    assert tuple(flat.location) == (5, 6, 7)
    assert edge_lengths(flat) == pytest.approx(before, rel=1e-5)
    assert notes(addon, source) == []


def test_a_parent_that_scales_the_pieces_is_said(addon):
    source = grid("Bump", bump)
    bpy.ops.object.wirewarp_flatten()
    parent = bpy.data.objects.new("Parent", None)
    bpy.context.scene.collection.objects.link(parent)
    parent.scale = (2, 2, 2)
    flat_of(source).parent = parent
    flatten_again(source)
    (note,) = notes(addon, source)
    assert '"Bump Flat" is not shown in true size' in note


@pytest.mark.parametrize("how", ["hide_set", "hide_viewport"])
def test_hidden_pieces_come_back(addon, how):
    source = grid("Bump", bump)
    bpy.ops.object.wirewarp_flatten()
    flat = flat_of(source)
    if how == "hide_set":
        flat.hide_set(True)
    else:
        flat.hide_viewport = True
    flatten_again(source)
    assert flat.visible_get()
    assert notes(addon, source) == []


@pytest.mark.parametrize("how", ["exclude", "hide_viewport"])
def test_pieces_in_a_collection_out_of_sight_are_said(addon, how):
    source = grid("Bump", bump)
    bpy.ops.object.wirewarp_flatten()
    setattr(layer_collection("WireWarp"), how, True)
    flatten_again(source)
    (note,) = notes(addon, source)
    assert '"Bump Flat" is not to be seen: its collection is hidden or excluded' in note
