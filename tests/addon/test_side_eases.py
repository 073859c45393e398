# SPDX-License-Identifier: GPL-3.0-or-later
"""Eases of one side of a seam: on which they are marked, on models and flat pieces, and what they survive."""

import bmesh
import bpy
import numpy as np
import pytest
from surfaces import flat_of, grid, mark, mark_seam, on_line, read, select_edges, select_only
from two_sided import HEM, SEAM, ease, join_split_and_turn_over, lengths, select_side, shares, two_pieces


@pytest.fixture
def source():
    return two_pieces()


def test_one_side_or_the_other_is_eased(source):
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    bpy.ops.object.wirewarp_flatten()
    one = shares(source)
    assert sorted(one) == pytest.approx([0.0, 0.05], abs=1e-5)
    ease(source, SEAM, sides="OTHER", ease_percent=5.0)
    bpy.ops.object.wirewarp_flatten()
    assert shares(source) == pytest.approx(one[::-1], abs=1e-5)


def test_one_side_is_that_of_the_smaller_piece_on_all_seams(addon):
    """As on two armholes that are selected together: their edges run either way around."""
    source = grid("Body and two sleeves", lambda x, y: (x, y, 0))
    seams = {x: on_line(0, x) for x in (-0.5, 0.5)}
    for seam in seams.values():
        mark_seam(source, seam)
    ease(source, lambda a, b: any(seam(a, b) for seam in seams.values()), sides="ONE", ease_percent=5.0)
    eased = np.flatnonzero(addon.state.allowances.SIDE_EASES.read(source.data))
    faces = np.repeat(np.arange(len(source.data.polygons)), [len(face.loop_indices) for face in source.data.polygons])
    middles = [source.data.polygons[face].center.x for face in faces[eased]]
    assert len(eased) == 16 and min(map(abs, middles)) > 0.5
    assert min(middles) < 0 < max(middles)


def test_the_millimeters_of_a_side_are_of_what_it_would_be(source):
    ease(source, SEAM, sides="ALL", ease_percent=-10.0)
    ease(source, SEAM, sides="ONE", ease_unit="LENGTH", ease_length=12.0)
    bpy.ops.object.wirewarp_flatten()
    _, left, right = lengths(source, SEAM)
    assert 100 * abs(left - right) == pytest.approx(12.0, abs=1e-3)
    assert min(shares(source)) == pytest.approx(-0.1, abs=1e-5)


def test_the_side_that_is_eased_survives_what_wires_survive(source):
    """Splitting edges, turning faces over, joining, a mirrored object and modifiers."""
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    bpy.ops.object.wirewarp_flatten()
    before = shares(source)
    join_split_and_turn_over(source)
    source.scale.x = -1
    bpy.ops.object.wirewarp_flatten()
    assert shares(source) == pytest.approx(before, abs=1e-5)


@pytest.mark.parametrize(("side", "expected"), [(-1, [0.05, 0.0]), (1, [0.0, 0.05])])
def test_on_flat_pieces_the_selected_side_is_eased(source, side, expected):
    bpy.ops.object.wirewarp_flatten()
    select_side(source, side)
    assert bpy.ops.mesh.wirewarp_ease(sides="ONE", ease_percent=5.0) == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    select_only(source)
    bpy.ops.object.wirewarp_flatten()
    assert shares(source) == pytest.approx(expected, abs=1e-5)


def test_both_sides_at_once_on_flat_pieces_are_refused(source):
    bpy.ops.object.wirewarp_flatten()
    select_side(source, 0)
    with pytest.raises(RuntimeError, match="Both sides of a seam are selected"):
        bpy.ops.mesh.wirewarp_ease(sides="ONE", ease_percent=5.0)


@pytest.mark.parametrize("sides", ["ALL", "OTHER"])
def test_on_flat_pieces_no_side_but_the_selected_one_is_eased(source, sides):
    bpy.ops.object.wirewarp_flatten()
    select_side(source, -1)
    with pytest.raises(RuntimeError, match="only the selected side can be eased"):
        bpy.ops.mesh.wirewarp_ease(sides=sides, ease_percent=5.0)
    assert "wirewarp_side_ratio" not in source.data.attributes


def test_a_line_of_which_both_sides_are_cleared_on_flat_pieces_counts_once(source, capfd):
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    bpy.ops.object.wirewarp_flatten()
    select_side(source, 0)
    assert bpy.ops.mesh.wirewarp_ease(sides="NONE") == {"FINISHED"}
    assert "Ease cleared on 1 line\n" in capfd.readouterr().out


def cut_beside_seam(source):
    """A loop cut right of the seam: its new edges lie between two parts of each face that there was."""
    select_edges(source, lambda a, b: min(a.x, b.x) == 0 and max(a.x, b.x) == 0.25)
    bpy.ops.mesh.subdivide(number_cuts=1)
    bpy.ops.object.mode_set(mode="OBJECT")


BESIDE = on_line(0, 0.125)


@pytest.mark.parametrize("beside", ["ONE", "OTHER"])
@pytest.mark.parametrize("sides", ["ONE", "OTHER"])
def test_after_a_loop_cut_one_side_is_eased_and_what_was_marked_stays(source, addon, sides, beside):
    ease(source, SEAM, sides=sides, ease_percent=5.0)
    cut_beside_seam(source)
    mark_seam(source, BESIDE)
    before = addon.state.allowances.SIDE_EASES.read(source.data)
    ease(source, BESIDE, sides=beside, ease_percent=2.0)
    after = addon.state.allowances.SIDE_EASES.read(source.data)
    assert np.count_nonzero(before) == 8 and (after[before != 0] == np.float32(0.05)).all()
    assert np.count_nonzero(after == np.float32(0.02)) == 8  # one corner of each edge


def test_an_ease_of_a_side_that_was_copied_to_the_other_is_told_until_it_is_marked_again(addon):
    """Half a model that is mirrored and sewn together at its eased edge, which is a seam then."""
    half = grid("Half", lambda x, y: (x + 1, y, 0))
    ease(half, SEAM, sides="ONE", ease_percent=5.0)
    edit = bmesh.new()
    edit.from_mesh(half.data)
    copies = bmesh.ops.duplicate(edit, geom=[*edit.verts, *edit.edges, *edit.faces])["geom"]
    for vertex in (each for each in copies if isinstance(each, bmesh.types.BMVert)):
        vertex.co.x *= -1
    bmesh.ops.reverse_faces(edit, faces=[each for each in copies if isinstance(each, bmesh.types.BMFace)])
    bmesh.ops.remove_doubles(edit, verts=edit.verts, dist=1e-4)
    edit.to_mesh(half.data)
    edit.free()
    mark_seam(half, SEAM)
    with pytest.raises(RuntimeError, match='The side of the ease is unknown on 8 edges of "Half", because faces'):
        bpy.ops.object.wirewarp_flatten()
    (issue,) = addon.state.reports.last_report(half).issues
    assert len(issue.edges) == 8
    ease(half, SEAM, sides="ONE", ease_percent=5.0)
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert sorted(shares(half)) == pytest.approx([0.0, 0.05], abs=1e-5)


def test_an_ease_of_one_side_of_a_middle_that_a_mirror_merges_is_told_what_to_do(addon):
    """Both sides of the middle are one face there and its image: only the applied model tells them apart."""
    half = grid("Half", lambda x, y: (x + 1, y, 0))
    mark_seam(half, SEAM)
    half.modifiers.new("Mirror", "MIRROR")
    ease(half, SEAM, sides="ONE", ease_percent=5.0)
    with pytest.raises(RuntimeError, match="8 edges .*modifiers copied.*Apply them and mark it again, or mark it on"):
        bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    (issue,) = addon.state.reports.last_report(half).issues
    assert (issue.code, len(issue.edges)) == ("side_unknown", 8)
    ease(half, SEAM, sides="NONE")
    ease(half, SEAM, sides="ALL", ease_percent=5.0)
    assert bpy.ops.object.wirewarp_flatten(use_modifiers=True) == {"FINISHED"}
    bpy.ops.object.modifier_apply(modifier="Mirror")
    ease(half, SEAM, sides="ALL", ease_percent=0.0)
    ease(half, SEAM, sides="ONE", ease_percent=5.0)
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert sorted(shares(half)) == pytest.approx([0.0, 0.05], abs=1e-5)


def write_corners(source, values):
    """values: by the sign of the side's place; on the corners at which edges of the seam begin."""
    sides = source.data.attributes.get("wirewarp_side_ease") or source.data.attributes.new(
        "wirewarp_side_ease", "FLOAT", "CORNER"
    )
    places = read(source.data.vertices, "co", np.float32, 3)
    for polygon in source.data.polygons:
        for corner, vertex, following in zip(
            polygon.loop_indices, polygon.vertices, [*polygon.vertices[1:], polygon.vertices[0]], strict=True
        ):
            if SEAM(places[vertex], places[following]):
                sides.data[corner].value = values[polygon.center.x > 0]


def test_scripts_may_write_the_eases_of_sides_on_corners(source):
    write_corners(source, [0.05, 0.02])
    bpy.ops.object.wirewarp_flatten()
    assert shares(source) == pytest.approx([0.05, 0.02], abs=1e-5)
    source.scale.x = -1
    bpy.ops.object.wirewarp_flatten()
    assert shares(source) == pytest.approx([0.05, 0.02], abs=1e-5)


def test_two_eases_of_one_side_are_told_with_their_edges(source, addon):
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    write_corners(source, [0.02, 0.02])
    with pytest.raises(RuntimeError, match='Edges of "Bump" have two eases of one side.*mark their ease again'):
        bpy.ops.object.wirewarp_flatten()
    (issue,) = addon.state.reports.last_report(source).issues
    assert len(issue.edges) == 8
    mark(source, HEM)  # which goes on as ever
    ease(source, SEAM, sides="ONE", ease_percent=5.0)  # which takes the other away
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}


def test_an_ease_where_no_side_is_names_its_edges(source, addon):
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    select_edges(source, lambda a, b: SEAM(a, b) and a.y + b.y > 1)
    bpy.ops.mesh.mark_seam(clear=True)
    bpy.ops.object.mode_set(mode="OBJECT")
    with pytest.raises(RuntimeError, match="An ease names"):
        bpy.ops.object.wirewarp_flatten()
    (issue,) = addon.state.reports.last_report(source).issues
    assert issue.code == "ease_without_side"
    assert len(issue.edges) == 2


@pytest.mark.parametrize("value", [-1.0, float("nan"), float("inf")])
@pytest.mark.parametrize("name", ["wirewarp_ease", "wirewarp_side_ease"])
def test_an_ease_that_is_none_names_its_wire_or_its_edges(source, addon, name, value):
    mark(source, HEM)
    if name == "wirewarp_ease":
        values = source.data.attributes.new(name, "FLOAT", "EDGE")
        for edge in source.data.edges:
            values.data[edge.index].value = value
    else:
        write_corners(source, [value, 0.0])
    wire, side = 'Wire "Wire 1" has an invalid ease', "ease of one side is invalid along 8 edges"
    with pytest.raises(RuntimeError, match=wire if name == "wirewarp_ease" else side):
        bpy.ops.object.wirewarp_flatten()
    (issue,) = addon.state.reports.last_report(source).issues
    assert len(issue.edges) == 8


def arrow(addon, target):
    """From the edge to the tip; and what is written there."""
    lines = addon.overlay.objects.marked_lines(target, bpy.context.evaluated_depsgraph_get())
    tail, tip, *_ = lines.places["ease"]
    return tail, tip, [name.texts for name in lines.names]


def test_an_arrow_points_into_the_side_that_is_longer(source, addon):
    for sides in ("ONE", "OTHER"):
        ease(source, SEAM, sides=sides, ease_percent=5.0)
        bpy.ops.object.wirewarp_flatten()
        left, right = shares(source)
        tail, tip, texts = arrow(addon, source)
        assert tail[0] == pytest.approx(0.0, abs=1e-6) and (tip[0] > 0) == (right > left)
        assert ("+5%",) in texts
        *_, texts = arrow(addon, flat_of(source))
        assert ("+5%",) in texts
    ease(source, SEAM, sides="NONE")
    lines = addon.overlay.objects.marked_lines(source, bpy.context.evaluated_depsgraph_get())
    assert "ease" not in lines.places
