# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat pieces stay at the places to which the user has moved them."""

import math
from types import SimpleNamespace

import bmesh
import bpy
import numpy as np
import pytest
from everything import drawn_buttons
from flattening import edited, fails, flat_places, flat_sources, flatten, flatten_fails, flattened
from mathutils import Vector
from surfaces import bump, everywhere, flat_of, mark, mark_seam, on_edges, on_line, read, select_only
from test_flatten import assert_true_lengths
from test_piece_names import HALVES, names_of

SEAM = on_line(0, 0.0)
NEAR = 1e-5  # tolerance of single precision for coordinates of about 10


def vertices_of(source, name):
    """Return the indices of the piece's vertices in the flat mesh."""
    flat = flat_of(source).data
    piece_id = next(entry.piece_id for entry in source.wirewarp_pieces if entry.name == name)
    ids = read(flat.attributes["wirewarp_piece"].data, "value", np.int32)
    return sorted({vertex for face in np.flatnonzero(ids == piece_id) for vertex in flat.polygons[face].vertices})


def places_of(source):
    """Return the places of the flat vertices, keyed by the name of the piece and the vertex of the model."""
    places, sources = flat_places(source), flat_sources(source)
    own = [(name, vertex) for name in names_of(source) for vertex in vertices_of(source, name)]
    return {(name, int(sources[vertex])): places[vertex] for name, vertex in own}


def farthest(now, then):
    """Return the largest distance between the places of a vertex in both results."""
    return max(np.linalg.norm(now[key] - then[key]) for key in then if key in now)


def boxes(source):
    places = flat_places(source)
    own = [(name, places[vertices_of(source, name)]) for name in names_of(source)]
    return {name: (points.min(axis=0), points.max(axis=0)) for name, points in own}


@pytest.fixture
def notes(source, addon):
    return lambda: [note.text for note in addon.state.reports.last_report(source).notes]


def move(source, name, angle=0.0, by=(0.0, 0.0)):
    """Rotate a piece about the origin and shift it, as a user does in Edit Mode."""
    flat = flat_of(source).data
    for vertex in vertices_of(source, name):
        place = complex(*flat.vertices[vertex].co[:2]) * complex(math.cos(angle), math.sin(angle)) + complex(*by)
        flat.vertices[vertex].co = (place.real, place.imag, 0)


def assert_same_places(now, then, names=None):
    keys = [key for key in then if names is None or key[0] in names]
    assert keys
    assert np.array([now[key] for key in keys]) == pytest.approx(np.array([then[key] for key in keys]), abs=NEAR)


def are_apart(first, second):
    return bool(np.any(first[0] >= second[1]) or np.any(second[0] >= first[1]))


def test_pieces_moved_and_turned_by_the_user_stay(source):
    move(source, "Top Left", angle=2.0, by=(5, -7))
    before = places_of(source)
    for vertex in source.data.vertices:
        vertex.co.z *= 1.02
    flatten(source)
    again = places_of(source)
    assert 1e-4 < farthest(again, before) < 0.05
    assert_true_lengths(source, tolerance=NEAR)
    flatten(source)
    assert_same_places(places_of(source), again)
    on_edges(source, bpy.ops.mesh.subdivide, everywhere, smoothness=0)
    flatten(source)
    assert len(places_of(source)) > 3 * len(before) and farthest(places_of(source), before) < 0.1
    select_only(flat_of(source))
    bpy.ops.object.mode_set(mode="EDIT")  # Nothing is selected, so that the user can pick one piece.
    assert not any(vertex.select for vertex in bmesh.from_edit_mesh(flat_of(source).data).verts)


def test_a_new_piece_goes_beside_the_others(source):
    move(source, "Top Left", angle=1.0, by=(4, 3))
    before = places_of(source)
    mark_seam(source, on_line(0, 0.75))
    flatten(source)
    now = places_of(source)
    assert_same_places(now, before, ["Top Right"])
    assert len(names_of(source)) == 3
    assert farthest(now, before) < 0.1  # The larger part has the name and the place of the divided piece.
    (new,) = set(names_of(source)) - {"Top Left", "Top Right"}
    found = boxes(source)
    assert all(are_apart(found[new], found[other]) for other in ("Top Left", "Top Right"))
    assert_true_lengths(source, tolerance=NEAR)


def test_a_piece_that_grew_into_another_is_moved_beside_it_with_a_message(source, notes):
    before = places_of(source)
    for vertex in source.data.vertices:
        vertex.co.x *= 3.0 if vertex.co.x > 0 else 1.0
    flatten(source)
    assert_same_places(places_of(source), before, ["Top Right"])
    found = boxes(source)
    assert are_apart(found["Top Left"], found["Top Right"])
    assert notes() == ["Top Left no longer fits in its place and was moved aside."]
    flatten(source)
    assert notes() == []


def test_pieces_that_the_user_put_over_each_other_stay_there(source, notes):
    flat = boxes(source)
    middles = {name: (low + high) / 2 for name, (low, high) in flat.items()}
    move(source, "Top Left", by=middles["Top Right"] - middles["Top Left"])
    before = places_of(source)
    flatten(source)
    assert_same_places(places_of(source), before)
    assert notes() == []


def flip_one(source):
    """Flip a face of Top Left, so that the piece fails. A second call restores the face."""
    max(source.data.polygons, key=lambda each: each.center.x).flip()


def test_a_failed_piece_returns_to_its_place_or_beside_a_piece_that_is_there_now(source, addon):
    move(source, "Top Left", angle=0.5, by=(3, 4))
    before = places_of(source)
    for _ in range(2):
        flip_one(source)
        for _ in range(2):
            select_only(source)
            flatten_fails("Top Left")
            assert {name for name, _ in places_of(source)} == {"Top Right"}
        flip_one(source)
        flatten(source)
        assert_same_places(places_of(source), before)
    assert addon.state.record.read_record(flat_of(source).data).away == []
    flip_one(source)
    flatten_fails("Top Left")
    middle = {name: np.mean([place for key, place in before.items() if key[0] == name], axis=0) for name in HALVES}
    move(source, "Top Right", by=middle["Top Left"] - middle["Top Right"])
    flip_one(source)
    flatten(source)
    found = boxes(source)
    assert are_apart(found["Top Left"], found["Top Right"])


@pytest.mark.parametrize("is_selected", [True, False])
def test_only_the_active_model_is_rearranged(source, is_selected):
    other = flattened("Other", bump, seam=SEAM)
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
    fails(bpy.ops.object.wirewarp_flatten, '"Bump" is hidden', keep_places=False, only_active=True)


def test_a_rotated_model_keeps_its_pieces_with_a_message(source, notes):
    before = places_of(source)
    source.rotation_euler.z = 1.0
    flatten(source)
    assert notes() == []  # This rotation does not change the upward direction.
    source.rotation_euler.x = math.radians(90)
    for _ in range(2):
        flatten(source)
        assert_same_places(places_of(source), before)
        (note,) = notes()
        assert note.startswith("The model was rotated after its pieces were laid out")
    flatten(source, keep_places=False)
    assert notes() == []
    flatten(source)
    assert notes() == []
    source.rotation_euler.x = 0
    flatten(source, orientation="BOUNDARY")
    source.rotation_euler.x = 1.0
    flatten(source, orientation="BOUNDARY")
    assert notes() == []


def test_a_rotated_model_is_mentioned_only_if_the_grain_wire_leaves_out_a_piece(source, notes):
    mark(source, lambda a, b: on_line(1, 0.0)(a, b) and a[0] + b[0] > 0)  # on one of the two pieces
    source.data.wirewarp_grain = source.data.wirewarp_names[0].wire_id
    flatten(source)
    source.rotation_euler.x = math.radians(90)
    flatten(source)
    assert [note[:21] for note in notes()] == ["The model was rotated"]
    source.data.edges.foreach_set("use_seam", [False] * len(source.data.edges))
    flatten(source, keep_places=False)
    source.rotation_euler.x = 0
    flatten(source)
    assert notes() == []


def test_a_dart_does_not_confuse_the_fit():
    source = flattened("Bump", bump, seam=lambda a, b: on_line(1, 0.0)(a, b) and a[0] + b[0] > 0)
    move(source, "Bump", angle=-0.7, by=(-3, 1))
    before = flat_places(source)
    flatten(source)
    assert flat_places(source) == pytest.approx(before, abs=NEAR)


@pytest.mark.parametrize("settings", [{"keep_places": False}, {"spacing": 160.0}, {"mirror": True}])
def test_pieces_are_rearranged_without_keep_places_or_for_another_layout(source, settings):
    flatten(source, **settings)
    laid_out = places_of(source)
    move(source, "Top Left", by=(3, 4))
    flatten(source, **({"keep_places": False} | settings))
    assert_same_places(places_of(source), laid_out)
    flatten(source)
    height = source.data.vertices[40].co.z
    source.data.vertices[40].co.z = math.nan
    flatten_fails("Bump: ", **settings)  # A failed run moves no pieces.
    source.data.vertices[40].co.z = height
    flatten(source, **settings)
    assert_same_places(places_of(source), laid_out)


def test_the_list_opens_at_the_worst_piece_and_then_keeps_the_users_choice(source, addon):
    report = addon.state.reports.last_report(source)
    worst = max(report.pieces, key=lambda piece: piece.needed).index
    assert source.wirewarp_active_piece == worst
    source.wirewarp_active_piece = 1 - worst
    bpy.ops.object.wirewarp_flatten()
    assert source.wirewarp_active_piece == 1 - worst


def test_the_button_that_rearranges_is_shown_if_places_are_kept(source, addon):
    def count():
        return drawn_buttons(addon).count("object.wirewarp_flatten")

    with_button = count()
    bpy.context.scene.wirewarp.keep_places = False
    assert count() == with_button - 2  # Each panel is drawn twice: narrow and wide.
    bpy.context.scene.wirewarp.keep_places = True
    select_only(flat_of(source))
    assert count() == with_button
    describe = addon.flatten.operators.OBJECT_OT_wirewarp_flatten.description
    words = [describe(bpy.context, SimpleNamespace(only_active=only)) for only in (False, True)]
    assert "keep the length" in words[0] and "lay out all its pieces again" in words[1]


def add_a_face(edit):
    edit.faces.new([edit.verts.new((x, y, 3)) for x, y in ((0, 0), (9, 0), (9, 9))])


def forge_vertices(edit):
    layer = edit.verts.layers.int["source_vertex"]
    for number, vertex in enumerate(edit.verts):
        vertex[layer] = -number


def move_all(edit, place):
    for number, vertex in enumerate(edit.verts):
        vertex.co = place(number, vertex.co)


EDITS = {
    "faces deleted": lambda edit: bmesh.ops.delete(edit, geom=list(edit.faces)[:20], context="FACES"),
    "everything deleted": lambda edit: edit.clear(),
    "vertices moved": lambda edit: move_all(edit, lambda number, place: place + Vector((0.1 * (number % 3), 0, 0))),
    "collapsed": lambda edit: move_all(edit, lambda *_: (1, 2, 0)),
    "nowhere": lambda edit: move_all(edit, lambda number, place: (math.nan, 0, 0) if number == 3 else place),
    "pieces forgotten": lambda edit: edit.faces.layers.int.remove(edit.faces.layers.int["wirewarp_piece"]),
    "vertices forged": forge_vertices,
    "a face added": add_a_face,
}


@pytest.mark.parametrize("change", EDITS)
def test_lengths_are_true_again_after_the_flat_object_was_edited(source, change):
    mesh = flat_of(source).data
    with edited(mesh) as edit:
        EDITS[change](edit)
    flatten(source)
    assert len(mesh.polygons) == len(source.data.polygons)
    assert np.all(read(mesh.vertices, "co", np.float32, 3)[:, 2] == 0)
    assert_true_lengths(source, tolerance=NEAR)


def test_unreadable_pieces_are_laid_out_again_for_the_rotated_model(source, notes):
    source.rotation_euler.x = math.radians(90)
    flat_of(source).data.vertices[3].co.x = math.nan
    for _ in range(2):
        flatten(source)
        assert notes() == []
