# SPDX-License-Identifier: GPL-3.0-or-later
"""Eases and allowances of one side of an edge survive edits, may be written by scripts, and are drawn."""

import bpy
import numpy as np
import pytest
from flattening import fails
from surfaces import flat_of, grid, mark, mark_seam, new_object, on_edges, on_line, read, select_edges, select_only
from two_sided import HEM, SEAM, ease, join_split_and_flip, made, select_side, shares, two_pieces, widths_at_seam


class Eases:
    """Tests eases, measured on the flat pieces as fractions of the length on the model."""

    attribute = "wirewarp_side_ease"
    first, second, unmarked = 0.05, 0.02, 0.0
    both = 0.0, 0.02  # after both sides were marked in turn: the second ease clears the first
    stored, rounding = 1.0, 1e-5
    twice = 'Edges of "Bump" have two eases on one side.*Mark the ease of these edges again'

    def __init__(self, addon):
        self.addon, self.marks = addon, addon.state.allowances.SIDE_EASES

    def mark_again(self, source):
        mark(source, HEM)  # A wire on another line must have no effect.
        ease(source, SEAM, sides="ONE", ease_percent=5.0)

    def mark_selected(self, value):
        return bpy.ops.mesh.wirewarp_ease(sides="ONE", ease_percent=100 * value)

    def mark_line(self, source, line, side):
        ease(source, line, sides="ONE" if side < 0 else "OTHER", ease_percent=50.0)

    def at_seam(self, source):
        """Return the values of the left and the right side."""
        bpy.ops.object.wirewarp_flatten()
        return shares(source)


class Allowances:
    """Tests allowances, measured in the pattern in millimeters."""

    attribute = "wirewarp_side_allowance"
    first, second, unmarked = 15.0, 6.0, 10.0
    both = 15.0, 6.0
    stored, rounding = 0.01, 1e-4  # a Blender unit is 100 mm
    twice = "have two allowances on one side.*Mark the allowance of these edges again"

    def __init__(self, addon):
        self.addon, self.marks = addon, addon.state.allowances.SIDE_ALLOWANCES

    def mark_again(self, source):
        mark_side(self, source, -1, self.first)

    def mark_selected(self, value):
        return bpy.ops.mesh.wirewarp_allowance(kind="WIDTH", width=value)

    def mark_line(self, source, line, side):
        mesh, places = source.data, read(source.data.vertices, "co", np.float32, 3)
        edges = [edge.index for edge in mesh.edges if line(*places[list(edge.vertices)])]
        faces = [face for face in mesh.polygons if 0 < side * (face.center.x - 0.125) < 0.125]
        corners = [loop for face in faces for loop in face.loop_indices if mesh.loops[loop].edge_index in edges]
        assert self.addon.state.allowances.mark_sides(mesh, np.array(corners), 0.5) == 8

    def at_seam(self, source):
        bpy.ops.object.wirewarp_flatten()
        return widths_at_seam(self.addon, source)


@pytest.fixture
def source():
    return two_pieces()


@pytest.fixture(params=[Eases, Allowances])
def kind(request, addon):
    return request.param(addon)


def mark_side(kind, source, side, value):
    """Mark the side of the piece to the left (-1) or right (1) of the seam."""
    select_side(source, side)
    assert kind.mark_selected(value) == {"FINISHED"}
    assert flat_of(source).mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    select_only(source)


def check(kind, source, left, right):
    assert kind.at_seam(source) == pytest.approx([left, right], abs=kind.rounding)


def write_corners(kind, source, left, right):
    """Write the values of both sides on the face corners at which edges of the seam begin, as a script may do."""
    mesh = source.data
    sides = mesh.attributes.get(kind.attribute) or mesh.attributes.new(kind.attribute, "FLOAT", "CORNER")
    places = read(mesh.vertices, "co", np.float32, 3)
    for polygon in mesh.polygons:
        following = np.roll(polygon.vertices, -1)
        for corner, vertex, other in zip(polygon.loop_indices, polygon.vertices, following, strict=True):
            if SEAM(places[vertex], places[other]):
                sides.data[corner].value = (right if polygon.center.x > 0 else left) * kind.stored


def test_a_side_marked_on_its_piece_survives_the_edits_that_wires_survive(source, kind):
    """The mark survives splitting edges, flipping faces, joining meshes, another unit and a mirrored object."""
    bpy.ops.object.wirewarp_flatten()
    mark_side(kind, source, -1, kind.first)
    check(kind, source, kind.first, kind.unmarked)
    mark_side(kind, source, 1, kind.second)
    check(kind, source, *kind.both)
    join_split_and_flip(source)
    bpy.ops.scene.wirewarp_set_unit(meters=0.1)
    source.scale.x = -1
    check(kind, source, *kind.both)


def test_scripts_may_write_a_side_on_corners(source, kind):
    write_corners(kind, source, kind.first, kind.second)
    check(kind, source, kind.first, kind.second)
    source.scale.x = -1
    check(kind, source, kind.first, kind.second)


def test_two_marks_of_one_side_are_reported_until_it_is_marked_again(source, kind):
    bpy.ops.object.wirewarp_flatten()
    mark_side(kind, source, -1, kind.first)
    write_corners(kind, source, kind.second, 0.0)
    with pytest.raises((RuntimeError, kind.addon.issues.ObjectError), match=kind.twice) as caught:
        kind.at_seam(source)
    if caught.type is RuntimeError:  # an error of Flatten, not of the export
        (issue,) = kind.addon.state.reports.last_report(source).issues
        assert len(issue.edges) == 8
    kind.mark_again(source)
    assert sorted(kind.at_seam(source)) == pytest.approx(sorted([kind.first, kind.unmarked]), abs=kind.rounding)


@pytest.mark.parametrize("side", [-1, 1])
def test_between_parts_of_a_face_one_side_is_marked_and_other_marks_stay(source, kind, side):
    """Values on faces distinguish the sides of a mark. A loop cut copies these values to both parts of a face."""
    bpy.ops.object.wirewarp_flatten()
    mark_side(kind, source, 1, kind.first)
    select_edges(source, lambda a, b: min(a.x, b.x) == 0 and max(a.x, b.x) == 0.25)
    bpy.ops.mesh.subdivide(number_cuts=1)
    beside = on_line(0, 0.125)
    mark_seam(source, beside)
    before = kind.marks.read(source.data)
    kind.mark_line(source, beside, side)
    after = kind.marks.read(source.data)
    assert np.count_nonzero(before) == 8 and np.array_equal(after[before != 0], before[before != 0])
    assert np.count_nonzero(after == np.float32(0.5)) == 8


def mark_allowance(target, line, **settings):
    assert on_edges(target, bpy.ops.mesh.wirewarp_allowance, line, **settings) == {"FINISHED"}


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_marked_widths_stay_when_the_unit_is_set(addon, source, mode):
    mark_allowance(source, SEAM, kind="WIDTH", width=6.0)
    mark_allowance(source, HEM, kind="FOLD")
    new_object("Other", source.data)
    sides = source.data.attributes.new("wirewarp_side_allowance", "FLOAT", "CORNER")
    sides.data[0].value = 0.5
    bpy.ops.object.mode_set(mode=mode)
    bpy.context.scene.wirewarp.aim_length = 0.5
    assert bpy.ops.scene.wirewarp_set_unit(meters=0.01) == {"FINISHED"}
    assert source.mode == mode
    assert bpy.context.scene.wirewarp.aim_length == pytest.approx(5)  # cm
    with addon.blender.mesh.current_mesh(source) as mesh:
        marked = addon.state.allowances.read_allowances(mesh)
    assert np.unique(marked.widths) == pytest.approx([-1.0, 0.6])  # cm
    assert marked.side_widths == pytest.approx([5.0])


def test_edges_of_a_joined_object_have_the_default_allowance(source, addon):
    """The corners of the joined object get the value 0, which is not a width."""
    mark_allowance(source, SEAM, kind="WIDTH", width=6.0)
    other = grid("Other", lambda x, y: (x + 3, y, 0))
    select_only(source, other)
    bpy.ops.object.join()
    bpy.ops.object.wirewarp_flatten()
    pieces = made(addon, addon.export.read.read_pattern(bpy.context.scene, source)).pieces
    widths = [[line.width for line in piece.of_role("sew") if line.seam is None] for piece in pieces]
    assert len(widths) == 3 and set(np.round(np.concatenate(widths), 3)) == {10.0}
    sewn = [line.width for piece in pieces for line in piece.of_role("sew") if line.seam is not None]
    assert sewn == pytest.approx([6.0, 6.0], abs=1e-4)


def test_each_side_of_a_seam_can_have_its_own_width(source, addon):
    bpy.ops.object.wirewarp_flatten()
    for side, settings, expected in (
        (-1, {"kind": "WIDTH", "width": 15.0}, [15.0, 10.0]),
        (1, {"kind": "WIDTH", "width": 6.0}, [15.0, 6.0]),
        (-1, {"kind": "DEFAULT"}, [10.0, 6.0]),
        (-1, {"kind": "FOLD"}, [0.0, 6.0]),
        (0, {"kind": "WIDTH", "width": 15.0}, [15.0, 15.0]),
    ):
        select_side(source, side)
        assert bpy.ops.mesh.wirewarp_allowance(**settings) == {"FINISHED"}
        bpy.ops.object.mode_set(mode="OBJECT")
        assert widths_at_seam(addon, source) == pytest.approx(expected, abs=1e-4)
    mark_allowance(source, SEAM, kind="WIDTH", width=12.0)
    assert widths_at_seam(addon, source) == pytest.approx([12.0, 12.0], abs=1e-4)
    mark_allowance(source, SEAM, kind="DEFAULT")
    assert widths_at_seam(addon, source) == pytest.approx([10.0, 10.0], abs=1e-4)


def test_the_width_of_a_side_survives_modifiers_but_is_not_marked_on_their_pieces(source, addon):
    bpy.ops.object.wirewarp_flatten()
    select_side(source, -1)
    bpy.ops.mesh.wirewarp_allowance(kind="WIDTH", width=15.0)
    bpy.ops.object.mode_set(mode="OBJECT")
    select_only(source)
    source.modifiers.new("Subdivision", "SUBSURF").levels = 2
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    assert widths_at_seam(addon, source) == pytest.approx([15.0, 10.0], abs=1e-4)
    select_only(flat_of(source))
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    fails(bpy.ops.mesh.wirewarp_allowance, 'The pieces of "Bump" were made with Modifiers', kind="WIDTH")


def test_edges_inside_of_a_piece_get_no_allowance(source):
    select_edges(source, on_line(1, 0.0))
    fails(bpy.ops.mesh.wirewarp_allowance, "Nothing to mark: select edges on a seam or outline first", kind="WIDTH")


def drawn(addon, source, allowance=10.0):
    """Return the size of the cutting line as drawn, in Blender units."""
    pages, depsgraph = addon.overlay.pages, bpy.context.evaluated_depsgraph_get()
    parts = addon.export.read.read_outlines(bpy.context.scene, source, flat_of(source), depsgraph)
    lines = pages.cut_places(pages.cut_lines(parts, allowance, darts="close"), 100.0)
    return np.ptp(lines, axis=0) if len(lines) else np.zeros(3)


def test_an_allowance_is_drawn_as_soon_as_it_is_marked_and_in_edit_mode(source, addon):
    bpy.ops.object.wirewarp_flatten()
    flat = np.ptp(read(flat_of(source).data.vertices, "co", np.float32, 3), axis=0)
    assert drawn(addon, source, 0.0).max() == 0
    plain = drawn(addon, source)
    assert plain[:2] == pytest.approx(flat[:2] + 0.2, abs=0.04)
    select_edges(source, on_line(0, -1.0), on_line(0, 1.0), on_line(1, -1.0), on_line(1, 1.0))
    bpy.ops.mesh.wirewarp_allowance(kind="HEM", hem=30.0)
    assert source.mode == "EDIT" and (drawn(addon, source) - plain).max() == pytest.approx(2 * 0.2, abs=0.05)
    assert drawn(addon, source, 0.0).max() > 0


@pytest.mark.parametrize(
    ("settings", "what"),
    [
        ({"kind": "HEM", "hem": 25.0}, "hem of 25 mm"),
        ({"kind": "WIDTH", "width": 6.5}, "allowance of 6.5 mm"),
        ({"kind": "FOLD"}, "fold, without allowance"),
        ({"kind": "DEFAULT"}, "default allowance"),
    ],
)
def test_the_message_says_what_the_edges_got(source, capfd, settings, what):
    mark_allowance(source, HEM, kind="WIDTH", width=9.0)
    mark_allowance(source, HEM, **settings)
    assert f"8 edges marked: {what}" in capfd.readouterr().out
