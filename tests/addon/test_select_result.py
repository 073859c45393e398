# SPDX-License-Identifier: GPL-3.0-or-later
"""From a line of the report to its edges and faces."""

import bpy
import numpy as np
import pytest
from surfaces import bump, edge_vertices, flat_of, grid, mark_seam, on_line, read, select_only

SEAM = on_line(0, 0.0)


@pytest.fixture
def source():
    target = grid("Bump", bump)
    mark_seam(target, SEAM)
    select_only(target)
    bpy.ops.object.wirewarp_flatten()
    return target


def selected(target, elements):
    assert (bpy.context.active_object, target.mode) == (target, "EDIT")
    bpy.ops.object.mode_set(mode="OBJECT")
    return np.flatnonzero(read(getattr(target.data, elements), "select", bool))


def test_a_seam_on_the_model(source):
    bpy.ops.mesh.wirewarp_select_result(what="SEAM", index=0)
    assert np.array_equal(selected(source, "edges"), np.flatnonzero(read(source.data.edges, "use_seam", bool)))


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_both_sides_of_a_seam_on_the_flat_pieces(source, mode):
    flat = flat_of(source)
    select_only(flat)
    bpy.ops.object.mode_set(mode=mode)
    bpy.ops.mesh.wirewarp_select_result(what="SEAM", index=0)
    edges = selected(flat, "edges")
    assert len(edges) == 16
    sources = read(flat.data.attributes["source_vertex"].data, "value", np.int32)[edge_vertices(flat.data)[edges]]
    places = read(source.data.vertices, "co", np.float32, 3)[sources]
    assert all(SEAM(a, b) for a, b in places)


@pytest.mark.parametrize("index", [0, 1])
def test_a_flat_piece_from_the_model(source, index):
    bpy.ops.mesh.wirewarp_select_result(what="PIECE", index=index)
    flat = flat_of(source)
    faces = selected(flat, "polygons")
    pieces = read(flat.data.attributes["piece"].data, "value", np.int32)
    assert np.array_equal(faces, np.flatnonzero(pieces == index))


def select_fails(match, **what):
    with pytest.raises(RuntimeError, match=match):
        bpy.ops.mesh.wirewarp_select_result(**what)


def test_what_is_not_there_is_said(source):
    select_fails('report of "Bump" has no such seam', what="SEAM", index=1)
    bpy.data.objects.remove(flat_of(source))
    select_fails('no flat pieces to this report: flatten "Bump" again', what="PIECE", index=0)
    other = grid("Other", bump)
    select_fails('report of "Other" has no such piece', what="PIECE", index=0)
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    mark_seam(other, SEAM)
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    select_fails("of the mesh with modifiers", what="SEAM", index=0)


def test_a_model_that_has_changed_is_said(source):
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide()
    select_fails('"Bump" has changed since it was flattened', what="SEAM", index=0)
