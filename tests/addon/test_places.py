# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat pieces stay where the user has put them."""

import math
from types import SimpleNamespace

import bmesh
import bpy
import numpy as np
import pytest
from everything import draw_panels
from surfaces import (
    bump,
    edge_lengths,
    edge_vertices,
    flat_of,
    flatten,
    grid,
    mark_seam,
    on_line,
    read,
    select_edges,
    select_only,
)

SEAM = on_line(0, 0.0)
HALVES = ["Top Left", "Top Right"]
NEAR = 1e-5  # of coordinates of about 10, in single precision


@pytest.fixture
def source():
    """Two pieces, flattened."""
    target = grid("Bump", bump)
    mark_seam(target, SEAM)
    bpy.ops.object.wirewarp_flatten()
    return target


def places_of(source):
    """{(name of the piece, vertex of the model): place}, of vertices that are in the piece once."""
    flat = flat_of(source).data
    places = read(flat.vertices, "co", np.float32, 3)[:, :2]
    sources = read(flat.attributes["source_vertex"].data, "value", np.int32)
    return {
        (name, int(sources[vertex])): places[vertex]
        for name in names_of(source)
        for vertex in vertices_of(source, name)
    }


def names_of(source):
    return [entry.name for entry in source.wirewarp_pieces]


def vertices_of(source, name):
    """Of the flat mesh."""
    flat = flat_of(source).data
    piece_id = next(entry.piece_id for entry in source.wirewarp_pieces if entry.name == name)
    ids = read(flat.attributes["wirewarp_piece"].data, "value", np.int32)
    return sorted({vertex for face in np.flatnonzero(ids == piece_id) for vertex in flat.polygons[face].vertices})


def move(source, name, angle=0.0, by=(0.0, 0.0)):
    """Turns a piece about the origin and shifts it, as in Edit Mode."""
    flat = flat_of(source).data
    for vertex in vertices_of(source, name):
        place = complex(*flat.vertices[vertex].co[:2]) * complex(math.cos(angle), math.sin(angle)) + complex(*by)
        flat.vertices[vertex].co = (place.real, place.imag, 0)


def assert_same_places(now, then, names=None):
    keys = [key for key in then if names is None or key[0] in names]
    assert keys
    assert np.array([now[key] for key in keys]) == pytest.approx(np.array([then[key] for key in keys]), abs=NEAR)


def assert_true(source):
    """Every edge of the outlines has its length on the model."""
    flat = flat_of(source).data
    sources = read(flat.attributes["source_vertex"].data, "value", np.int32)
    on_model = dict(zip(map(frozenset, edge_vertices(source.data).tolist()), edge_lengths(source), strict=True))
    use = np.bincount(read(flat.loops, "edge_index", np.int32), minlength=len(flat.edges))
    for (a, b), length in zip(edge_vertices(flat)[use == 1], edge_lengths(flat_of(source))[use == 1], strict=True):
        assert length == pytest.approx(on_model[frozenset((int(sources[a]), int(sources[b])))], rel=1e-5)


def boxes(source):
    flat = flat_of(source).data
    places = read(flat.vertices, "co", np.float32, 3)[:, :2]
    own = {name: places[vertices_of(source, name)] for name in names_of(source)}
    return {name: (points.min(axis=0), points.max(axis=0)) for name, points in own.items()}


def are_apart(first, second):
    return bool(np.any(first[0] >= second[1]) or np.any(second[0] >= first[1]))


def notes_of(addon, source):
    return [note.text for note in addon.state.reports.last_report(source).notes]


def test_pieces_moved_and_turned_by_the_user_stay(source):
    move(source, "Top Left", angle=2.0, by=(5, -7))
    before = places_of(source)
    for vertex in source.data.vertices:
        vertex.co.z *= 1.02  # other shapes, nearly
    flatten(source)
    now = places_of(source)
    difference = max(np.linalg.norm(now[key] - before[key]) for key in before)
    assert 1e-4 < difference < 0.05
    assert_true(source)
    again = places_of(source)
    flatten(source)
    assert_same_places(places_of(source), again)


def test_in_edit_mode_nothing_is_selected_so_that_one_piece_can_be_picked(source):
    select_only(flat_of(source))
    bpy.ops.object.mode_set(mode="EDIT")
    assert not any(vertex.select for vertex in bmesh.from_edit_mesh(flat_of(source).data).verts)
    bpy.ops.object.mode_set(mode="OBJECT")


def test_they_stay_when_the_model_is_subdivided(source):
    move(source, "Top Left", angle=2.0, by=(5, -7))
    before = places_of(source)
    select_edges(source, lambda *_: True)
    bpy.ops.mesh.subdivide(smoothness=0)
    bpy.ops.object.mode_set(mode="OBJECT")
    flatten(source)
    now = places_of(source)
    assert len(now) > 3 * len(before)
    assert max(np.linalg.norm(now[key] - before[key]) for key in before) < 0.1


def test_a_new_piece_goes_beside_the_others(source):
    move(source, "Top Left", angle=1.0, by=(4, 3))
    before = places_of(source)
    mark_seam(source, on_line(0, 0.75))
    flatten(source)
    now = places_of(source)
    assert_same_places(now, before, ["Top Right"])
    assert len(names_of(source)) == 3
    shared = [key for key in before if key[0] == "Top Left" and key in now]
    assert max(np.linalg.norm(now[key] - before[key]) for key in shared) < 0.1  # the larger part of it
    (new,) = set(names_of(source)) - {"Top Left", "Top Right"}
    found = boxes(source)
    assert all(are_apart(found[new], found[other]) for other in ("Top Left", "Top Right"))
    assert_true(source)


def test_several_new_pieces_do_not_overlap(source):
    for line in (-0.75, -0.5, -0.25, 0.25, 0.5, 0.75):
        mark_seam(source, on_line(1, line))
    flatten(source)
    found = list(boxes(source).values())
    assert len(found) == 14
    crowded = [(k, j) for k in range(14) for j in range(k) if not are_apart(found[k], found[j])]
    assert len(crowded) <= 1  # boxes of the two that stayed may meet, for they need not be upright


def grow(source, side, factor):
    for vertex in source.data.vertices:
        if vertex.co.x * side > 0:
            vertex.co.x *= factor


def test_a_piece_that_grew_into_another_goes_beside_it_and_that_is_said(source, addon):
    before = places_of(source)
    grow(source, 1, 3.0)
    flatten(source)
    assert_same_places(places_of(source), before, ["Top Right"])
    found = boxes(source)
    assert are_apart(found["Top Left"], found["Top Right"])
    assert notes_of(addon, source) == ["Top Left no longer fitted its place and was moved aside."]
    flatten(source)
    assert notes_of(addon, source) == []


def test_pieces_that_the_user_put_over_each_other_stay_there(source, addon):
    flat = boxes(source)
    middles = {name: (low + high) / 2 for name, (low, high) in flat.items()}
    move(source, "Top Left", by=middles["Top Right"] - middles["Top Left"])
    before = places_of(source)
    flatten(source)
    assert_same_places(places_of(source), before)
    assert notes_of(addon, source) == []


def flip_one(source):
    """Turns a face of Top Left over: the piece fails. Once more, and it is well again."""
    max(source.data.polygons, key=lambda each: each.center.x).flip()


def test_a_piece_that_failed_comes_back_to_its_place(source, addon):
    move(source, "Top Left", angle=0.5, by=(3, 4))
    before = places_of(source)
    for _ in range(2):
        flip_one(source)
        for _ in range(2):
            with pytest.raises(RuntimeError, match="Top Left"):
                flatten(source)
            assert {name for name, _ in places_of(source)} == {"Top Right"}
        flip_one(source)
        flatten(source)
        assert_same_places(places_of(source), before)
    assert addon.state.record.read_record(flat_of(source).data).away == []


def test_another_piece_in_its_place_is_not_laid_over(source):
    before = places_of(source)
    flip_one(source)
    with pytest.raises(RuntimeError, match="Top Left"):
        flatten(source)
    middle = {name: np.mean([place for key, place in before.items() if key[0] == name], axis=0) for name in HALVES}
    move(source, "Top Right", by=middle["Top Left"] - middle["Top Right"])
    flip_one(source)
    flatten(source)
    found = boxes(source)
    assert are_apart(found["Top Left"], found["Top Right"])


def test_the_button_that_lays_out_anew_is_there_where_places_are_kept(source, addon):
    def buttons():
        found = []
        draw_panels(addon, found)
        return found.count("object.wirewarp_flatten")

    with_button = buttons()
    bpy.context.scene.wirewarp.keep_places = False
    assert buttons() == with_button - 2  # narrow and wide
    bpy.context.scene.wirewarp.keep_places = True
    select_only(flat_of(source))
    assert buttons() == with_button  # of their model

    flatten_button = addon.flatten.operators.OBJECT_OT_wirewarp_flatten
    words = [flatten_button.description(bpy.context, SimpleNamespace(only_active=only)) for only in (False, True)]
    assert "keep the length" in words[0] and "lay out all its pieces again" in words[1]


@pytest.mark.parametrize("is_selected", [True, False])
def test_only_the_active_model_is_laid_out_anew(source, is_selected):
    other = grid("Other", bump)
    mark_seam(other, SEAM)
    flatten(other)
    laid_out = places_of(source)
    for each in (source, other):
        move(each, "Top Left", by=(7, 8))
    moved = places_of(other)
    select_only(source, other)
    source.select_set(is_selected)
    bpy.ops.object.wirewarp_flatten(keep_places=False, only_active=True)
    assert_same_places(places_of(source), laid_out)
    assert_same_places(places_of(other), moved)
    source.hide_set(True)
    with pytest.raises(RuntimeError, match='"Bump" is hidden'):
        bpy.ops.object.wirewarp_flatten(keep_places=False, only_active=True)


def test_a_model_that_is_turned_leaves_its_pieces_as_they_stand_and_that_is_said(source, addon):
    before = places_of(source)
    source.rotation_euler.z = 1.0
    flatten(source)
    assert notes_of(addon, source) == []  # what is up stays that
    source.rotation_euler.x = math.radians(90)
    for _ in range(2):
        flatten(source)
        assert_same_places(places_of(source), before)
        (note,) = notes_of(addon, source)
        assert note.startswith("The model was turned after its pieces were laid out")
    flatten(source, keep_places=False)
    assert notes_of(addon, source) == []
    flatten(source)
    assert notes_of(addon, source) == []
    source.rotation_euler.x = 0
    flatten(source, orientation="BOUNDARY")
    source.rotation_euler.x = 1.0
    flatten(source, orientation="BOUNDARY")
    assert notes_of(addon, source) == []


@pytest.mark.parametrize("settings", [{"keep_places": False}, {"spacing": 160.0}, {"mirror": True}])
def test_laid_out_anew_where_that_is_wanted(source, settings):
    flatten(source, **settings)
    laid_out = places_of(source)
    move(source, "Top Left", by=(3, 4))
    flatten(source, **({"keep_places": False} | settings))
    assert_same_places(places_of(source), laid_out)
    flatten(source)
    flatten(source, **settings)
    assert_same_places(places_of(source), laid_out)


def test_laid_out_anew_with_another_gap_after_a_run_that_failed(source):
    flatten(source, spacing=160.0, keep_places=False)
    laid_out = places_of(source)
    flatten(source, spacing=60.0)
    height = source.data.vertices[40].co.z
    source.data.vertices[40].co.z = math.nan
    with pytest.raises(RuntimeError):
        flatten(source, spacing=160.0)
    source.data.vertices[40].co.z = height
    flatten(source, spacing=160.0)
    assert_same_places(places_of(source), laid_out)


def test_a_dart_does_not_confuse_the_fit():
    source = grid("Bump", bump)
    mark_seam(source, lambda a, b: on_line(1, 0.0)(a, b) and a[0] + b[0] > 0)
    bpy.ops.object.wirewarp_flatten()
    move(source, "Bump", angle=-0.7, by=(-3, 1))
    flat = flat_of(source).data
    before = read(flat.vertices, "co", np.float32, 3)
    flatten(source)
    assert read(flat.vertices, "co", np.float32, 3) == pytest.approx(before, abs=NEAR)


def delete_faces(edit):
    edit.faces.ensure_lookup_table()
    bmesh.ops.delete(edit, geom=edit.faces[:20], context="FACES")


def delete_everything(edit):
    edit.clear()


def move_vertices(edit):
    for number, vertex in enumerate(edit.verts):
        vertex.co.x += 0.1 * (number % 3)


def collapse(edit):
    for vertex in edit.verts:
        vertex.co = (1, 2, 0)


def break_numbers(edit):
    edit.verts.ensure_lookup_table()
    edit.verts[3].co.x = math.nan


def forget_pieces(edit):
    edit.faces.layers.int.remove(edit.faces.layers.int["wirewarp_piece"])


def forge_vertices(edit):
    layer = edit.verts.layers.int["source_vertex"]
    for number, vertex in enumerate(edit.verts):
        vertex[layer] = -number


def add_a_face(edit):
    edit.faces.new([edit.verts.new((x, y, 3)) for x, y in ((0, 0), (9, 0), (9, 9))])


EDITS = [
    delete_faces,
    delete_everything,
    move_vertices,
    collapse,
    break_numbers,
    forget_pieces,
    forge_vertices,
    add_a_face,
]


@pytest.mark.parametrize("change", EDITS)
def test_lengths_are_true_again_after_the_flat_object_was_edited(source, change):
    mesh = flat_of(source).data
    edit = bmesh.new()
    edit.from_mesh(mesh)
    change(edit)
    edit.to_mesh(mesh)
    edit.free()
    flatten(source)
    assert len(mesh.polygons) == len(source.data.polygons)
    assert np.all(read(mesh.vertices, "co", np.float32, 3)[:, 2] == 0)
    assert_true(source)


def test_the_list_opens_at_the_worst_piece_and_then_stays_where_the_user_is(addon, source):
    report = addon.state.reports.last_report(source)
    worst = max(report.pieces, key=lambda piece: piece.needed).index
    assert source.wirewarp_active_piece == worst
    source.wirewarp_active_piece = 1 - worst
    bpy.ops.object.wirewarp_flatten()
    assert source.wirewarp_active_piece == 1 - worst
