# SPDX-License-Identifier: GPL-3.0-or-later
"""Allowances marked on edges: they reach the pattern, and are drawn at once. Of one side: test_sided_marks.py."""

import bpy
import numpy as np
import pytest
from surfaces import flat_of, grid, on_line, read, select_edges, select_only
from two_sided import HEM, SEAM, made, select_side, two_pieces, widths_at_seam


@pytest.fixture
def source():
    return two_pieces()


def mark_allowance(target, line, **settings):
    select_edges(target, line)
    assert bpy.ops.mesh.wirewarp_allowance(**settings) == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_marked_widths_stay_when_the_unit_is_set(addon, source, mode):
    mark_allowance(source, SEAM, kind="WIDTH", width=6.0)
    mark_allowance(source, HEM, kind="FOLD")
    twin = bpy.data.objects.new("Twin", source.data)  # with the same mesh
    bpy.context.scene.collection.objects.link(twin)
    sides = source.data.attributes.new("wirewarp_side_allowance", "FLOAT", "CORNER")
    sides.data[0].value = 0.5
    bpy.ops.object.mode_set(mode=mode)
    assert bpy.ops.scene.wirewarp_set_unit(meters=0.01) == {"FINISHED"}
    assert source.mode == mode
    with addon.blender.mesh.current_mesh(source) as mesh:
        marked = addon.state.allowances.read_allowances(mesh)
    assert np.unique(marked.widths) == pytest.approx([-1.0, 0.6])  # cm
    assert marked.side_widths == pytest.approx([5.0])


def test_edges_that_come_from_elsewhere_have_the_default(source, addon):
    """Blender sets them to 0, which is not a width."""
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
        (0, {"kind": "WIDTH", "width": 15.0}, [15.0, 15.0]),  # both at once
    ):
        select_side(source, side)
        assert bpy.ops.mesh.wirewarp_allowance(**settings) == {"FINISHED"}
        bpy.ops.object.mode_set(mode="OBJECT")
        assert widths_at_seam(addon, source) == pytest.approx(expected, abs=1e-4)
    mark_allowance(source, SEAM, kind="WIDTH", width=12.0)
    assert widths_at_seam(addon, source) == pytest.approx([12.0, 12.0], abs=1e-4)
    mark_allowance(source, SEAM, kind="DEFAULT")
    assert widths_at_seam(addon, source) == pytest.approx([10.0, 10.0], abs=1e-4)


def test_the_width_of_a_side_goes_through_modifiers_and_is_marked_without(source, addon):
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
    with pytest.raises(RuntimeError, match='The pieces of "Bump" were made with Modifiers'):
        bpy.ops.mesh.wirewarp_allowance(kind="WIDTH")


def test_edges_inside_of_a_piece_get_none(source):
    select_edges(source, on_line(1, 0.0))
    with pytest.raises(RuntimeError, match="Nothing to mark: select edges on a seam or outline first"):
        bpy.ops.mesh.wirewarp_allowance(kind="WIDTH")


def drawn(addon, source, allowance=10.0):
    """Return the size of the cutting line as drawn, in Blender units."""
    pages, depsgraph = addon.overlay.pages, bpy.context.evaluated_depsgraph_get()
    parts = pages.outlines(bpy.context.scene, source, flat_of(source), depsgraph)
    lines = pages.cut_places(pages.cut_lines(parts, allowance, "close"), 100.0)
    return np.ptp(lines, axis=0) if len(lines) else np.zeros(3)


def test_it_is_drawn_as_soon_as_it_is_marked_and_in_edit_mode(source, addon):
    bpy.ops.object.wirewarp_flatten()
    flat = np.ptp(read(flat_of(source).data.vertices, "co", np.float32, 3), axis=0)
    assert drawn(addon, source, 0.0).max() == 0
    plain = drawn(addon, source)
    assert plain[:2] == pytest.approx(flat[:2] + 0.2, abs=0.04)
    select_edges(source, on_line(0, -1.0), on_line(0, 1.0), on_line(1, -1.0), on_line(1, 1.0))
    bpy.ops.mesh.wirewarp_allowance(kind="HEM", hem=30.0)
    assert source.mode == "EDIT"
    assert (drawn(addon, source) - plain).max() == pytest.approx(2 * 0.2, abs=0.05)
    assert drawn(addon, source, 0.0).max() > 0
