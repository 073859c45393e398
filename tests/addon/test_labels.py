# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts on flat pieces do not hide the pieces, and seams name the pieces that they join. Arrows show the grain."""

import math

import bpy
import numpy as np
import pytest
from flattening import flatten, flattened
from mathutils import Matrix
from surfaces import bump, flat_of, grid, mark, on_line
from two_sided import made
from view_context import look, marked_lines

HEIGHT, LETTER = 10.0, 6.0  # pixels


def size_of(text):
    return LETTER * len(text), HEIGHT


def label(addon, *texts, at=(100, 100), room=200.0, piece=1, box=None, selected=False):
    """Return a name to be placed. box: outermost points of its piece, or two opposite corners of a rectangle."""
    points = np.array([at], dtype=float)
    around = None if box is None else np.array(box, dtype=float)
    if box is not None and len(box) == 2:
        around = np.array([(x, y) for x in around[:, 0] for y in around[:, 1]])
    return addon.overlay.screen.PlacedName(texts, points, 100.0, ("Flat", piece), room, around, selected)


def written(addon, *names):
    return [text.text for text in addon.overlay.screen.arrange(names, size_of)]


def test_labels_hide_at_most_a_quarter_of_a_piece(addon):
    def names(room):
        return [label(addon, f"Seam {k}", at=(100, 30 * k), room=room) for k in range(1, 10)]

    assert len(written(addon, *names(200.0))) == 9
    few = written(addon, *names(80.0))
    area = (6 * LETTER + 2 * 3) * (HEIGHT + 2 * 3)
    assert len(few) == int(0.25 * 80**2 / area) == 2
    assert written(addon, *names(10.0)) == []
    other = [label(addon, "Seam 20", at=(400, 100), room=80.0, piece=2)]  # on another piece
    assert written(addon, *names(80.0), *other) == [*few, "Seam 20"]


def test_the_name_of_a_small_piece_is_beside_it_and_not_on_another_piece(addon):
    arrange, box = addon.overlay.screen.arrange, [(90, 90), (110, 110)]
    (inside,) = arrange([label(addon, "Front", box=box)], size_of)
    assert inside.base > 100
    front = label(addon, "Front", room=20.0, box=box)
    (below,) = arrange([front], size_of)
    assert below.base + HEIGHT < 90 and below.left + size_of("Front")[0] / 2 == 100
    back = label(addon, "Back", at=(100, 60), piece=2, box=[(0, 0), (200, 88)])  # a piece below Front
    above, _ = arrange([front, back], size_of)
    assert above.base > 110


def test_the_name_beside_a_slanted_piece_touches_it(addon):
    """The name is below the lowest point of the piece, or above the highest point if another piece is below."""
    slanted = label(addon, "Left sleeve", at=(200, 200), room=20.0, box=[(100, 90), (110, 80), (300, 310), (290, 320)])
    (below,) = addon.overlay.screen.arrange([slanted], size_of)
    assert below.left + size_of("Left sleeve")[0] / 2 == 110 and 0 < 80 - (below.base + HEIGHT) < HEIGHT
    taken = [label(addon, "Front", at=(110, 70), piece=2, box=[(0, 0), (200, 79)])]
    above, _ = addon.overlay.screen.arrange([slanted, *taken], size_of)
    assert above.left + size_of("Left sleeve")[0] / 2 == 290 and 0 < above.base - 320 < HEIGHT


def test_the_outermost_vertices_of_a_piece_are_around_it(addon):
    source = flattened("Sheet", lambda x, y: (x, y, 0.0))
    (middle,) = addon.overlay.objects._middles(flat_of(source).data).values()
    low, high = middle.around.min(axis=0), middle.around.max(axis=0)
    assert len(middle.around) == 4 and np.allclose(high - low, (2, 2, 0))


def test_a_name_at_the_edge_is_not_hidden_by_the_toolbar(addon):
    """Only names whose points are visible are moved away from the toolbar on the left and the sidebar on the right."""
    span, (width, _) = (50.0, 300.0), size_of("Seam 4")
    places = [(60, 100), (295, 100), (20, 100), (175, 100)]
    written = addon.overlay.screen.arrange([label(addon, "Seam 4", at=place) for place in places], size_of, span)
    left, right, below_toolbar, free = [text.left for text in written]
    assert 50 < left < 60 - width / 2 + 20 and left > 60 - width / 2
    assert 295 - width / 2 > right and right + width < 300
    assert (below_toolbar, free) == (20 - width / 2, 175 - width / 2)


def test_a_seam_names_the_joined_pieces_if_there_is_room_and_selected_names_are_always_written(addon):
    texts = ("Seam 4: Left sleeve", "Seam 4")
    assert written(addon, label(addon, *texts, room=400.0)) == [texts[0]]
    assert written(addon, label(addon, *texts, room=120.0)) == [texts[1]]
    assert written(addon, label(addon, *texts, room=1.0)) == []
    assert written(addon, label(addon, "Seam 4", room=1.0, selected=True)) == ["Seam 4"]


@pytest.fixture
def source():
    return flattened("Bump", bump, seam=on_line(0, 0.0), wire=on_line(1, 0.0))


def test_on_the_model_a_seam_names_both_pieces_and_on_each_piece_the_other(addon, source):
    names = [piece.name for piece in addon.state.reports.last_report(source).pieces]
    on_model = {name.texts[0] for name in marked_lines(addon, source).names}
    assert f"Seam 1: {names[0]} – {names[1]}" in on_model
    on_flat = {name.texts[0] for name in marked_lines(addon, flat_of(source)).names}
    assert {f"Seam 1: {name}" for name in names} < on_flat


def test_names_hide_at_most_a_quarter_of_a_model_that_is_far_away(addon):
    source = grid("Sheet", lambda x, y: (x, y, 0.0))
    for y in (-0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75):
        mark(source, on_line(1, y))

    def written_from(height):
        names = look(addon, source, (0, 0, height), (0, 0, 0))
        return addon.overlay.screen.arrange(names.values(), size_of)

    assert len(written_from(1.5)) == 7
    side = 2 * 400 / 10  # pixels; at distance 1, a unit has 400 pixels
    area = (6 * LETTER + 2 * 3) * (HEIGHT + 2 * 3)
    assert len(written_from(10.0)) == int(0.25 * side**2 / area) == 2
    assert len(written_from(0.5)) > 2  # The view shows only a part of the sheet.


def arrows(addon, source, kind):
    """Return the vector (k,2) of each arrow from its tail to its tip."""
    corners = marked_lines(addon, flat_of(source)).places.get(kind, np.empty((0, 3))).reshape(-1, 6, 3)
    return corners[:, 1, :2] - corners[:, 0, :2]


def angles(addon, source):
    """Return the angles of the arrows on pieces without a grain wire, in degrees."""
    found = arrows(addon, source, "default grain")
    assert np.all(np.linalg.norm(found, axis=1) > 0.1)
    return np.degrees(np.arctan2(found[:, 1], found[:, 0]))


def test_an_upright_grain_arrow_lies_inside_every_piece(addon, source):
    assert angles(addon, source) == pytest.approx([90, 90], abs=1e-3)
    lines = marked_lines(addon, flat_of(source)).places
    outline = np.concatenate([lines["seam"], lines["outline"]])
    for corners in lines["default grain"].reshape(2, -1, 3):
        assert np.linalg.norm(outline[:, None] - corners, axis=2).min() > 0.05
        level = outline[np.abs(outline[:, 1] - corners[1, 1]) < 0.3]  # at the height of the arrow's tip
        assert level[:, 0].min() < corners[1, 0] < level[:, 0].max()


def test_arrows_are_bold_where_the_grain_wire_runs(addon, source):
    mark(source, lambda a, b: on_line(1, 0.5)(a, b) and max(a[0], b[0]) < 0.1)
    source.data.wirewarp_grain = source.data.wirewarp_names[-1].wire_id
    flatten(source)
    assert (len(arrows(addon, source, "grain")), len(arrows(addon, source, "default grain"))) == (1, 1)


def test_arrows_turn_with_their_pieces_and_so_does_the_grain_on_paper(addon, source):
    flat_of(source).data.transform(Matrix.Rotation(math.radians(30), 4, "Z"))
    bpy.context.view_layer.update()
    assert angles(addon, source) == pytest.approx([120, 120], abs=0.1)
    for piece in made(addon, addon.export.read.read_pattern(bpy.context.scene, source)).pieces:
        (line,) = piece.of_role("grain")
        way = line.points[1] - line.points[0]
        assert math.degrees(math.atan2(way[1], way[0])) == pytest.approx(120, abs=0.1)
    flatten(source)  # The pieces stay rotated.
    assert angles(addon, source) == pytest.approx([120, 120], abs=0.1)


def test_pieces_whose_record_was_changed_or_that_are_gone_have_no_arrows(addon, source):
    flat = flat_of(source)
    flat.data["wirewarp_flat"] += " "
    assert len(arrows(addon, source, "default grain")) == 0
    flatten(source)
    assert len(arrows(addon, source, "default grain")) == 2
    flat.data.clear_geometry()
    assert len(arrows(addon, source, "default grain")) == 0


def test_a_flat_object_seen_edge_on_and_a_thin_strap_have_room_for_names(addon):
    """Names may be as wide as half of the visible length, because the visible area of these objects is almost 0."""
    strap = grid("Strap", lambda x, y: (x, 0.01 * y, 0.0), wire=on_line(1, 0.0))
    sheet = grid("Sheet", lambda x, y: (x, y, 0.0), wire=on_line(1, 1.0))
    for target, eye in ((strap, (0, 0, 10)), (sheet, (0, 10, 0))):
        (name,) = look(addon, target, eye, (0, 0, 0), perspective=False).values()
        assert name.room == pytest.approx(100, abs=1)  # half of the length of 200 pixels
