# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth Seam cuts smooth lines into the mesh in place of the user's seams. Surface, marks and maps stay."""

import bpy
import numpy as np
import pytest
from flattening import edge_vertices, fails
from suggesting import add_layers, check_layers, pairs, places
from surfaces import bump, flat_of, grid, mark_seam, on_edges, on_line, read, round_bump, select_edges, select_only
from test_proposals import seams_of

pytestmark = pytest.mark.api

SIZE = 8
# Columns and rows of the vertices of a path. Grids of n-gons have all edges of this path, too.
STAIRS = [(2, 2), (3, 2), (4, 2), (4, 3), (5, 3), (6, 3), (6, 4)]


def stairs(target):
    """Mark a seam along stair steps inside the grid, and return the places of its ends."""
    path = [x + (SIZE + 1) * y for x, y in STAIRS]
    steps = {frozenset(pair) for pair in zip(path, path[1:], strict=False)}
    for edge in target.data.edges:
        edge.use_seam |= frozenset(edge.vertices) in steps
    return places(target)[[path[0], path[-1]]]


def smooth(target, line=lambda a, b: True):
    return on_edges(target, bpy.ops.mesh.wirewarp_smooth_seam, line)


def seam_places(source):
    """Return the ends (k,2,3) of each seam edge."""
    return places(source)[np.array(seams_of(source)).reshape(-1, 2)]


def surface(source):
    """Return the area of the displayed triangles, and the volume between them and the ground."""
    source.data.calc_loop_triangles()
    corners = places(source)[np.array([each.vertices for each in source.data.loop_triangles])]
    u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    normals = np.cross(u, v)
    return np.linalg.norm(normals, axis=1).sum() / 2, (normals[:, 2] * corners[:, :, 2].mean(axis=1)).sum() / 2


@pytest.mark.parametrize("faces", ["triangles", "quads"])
def test_a_seam_along_stairs_becomes_a_straight_line_and_all_else_stays(faces):
    source = grid("Grid", lambda x, y: (x, y, 0.0), faces=faces)
    add_layers(source)
    before, area = places(source), surface(source)
    start, end = stairs(source)
    assert smooth(source) == {"FINISHED"}
    assert np.array_equal(places(source)[: len(before)], before)
    assert surface(source) == pytest.approx(area, abs=1e-6)
    ends, length = seam_places(source), np.linalg.norm(end - start)
    aside = np.cross(ends - start, (end - start) / length)
    assert np.linalg.norm(aside, axis=2).max() < 0.2 * 2 / SIZE
    assert np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum() == pytest.approx(length, rel=2e-3)
    check_layers(source)


@pytest.mark.parametrize("faces", ["quads", "ngons"])
def test_a_curved_surface_stays(faces):
    source = grid("Bump", round_bump, faces=faces)
    area = surface(source)
    stairs(source)
    assert smooth(source) == {"FINISHED"}
    assert surface(source) == pytest.approx(area, rel=1e-6)


def test_painted_faces_are_not_entered():
    source = grid("Bump", bump)
    stairs(source)
    free = source.data.copy()
    painted = source.data.attributes.new("wirewarp_no_seam", "BOOLEAN", "FACE")
    painted.data.foreach_set("value", [3 + SIZE * 2 <= index < 8 + SIZE * 2 for index in range(SIZE * SIZE)])
    assert smooth(source) == {"FINISHED"}
    assert np.count_nonzero(read(source.data.attributes["wirewarp_no_seam"].data, "value", bool)) == 5
    source.data = free
    painted = free.attributes.new("wirewarp_no_seam", "BOOLEAN", "FACE")
    assert smooth(source) == {"FINISHED"}
    assert len(free.polygons) > SIZE * SIZE + 5


def test_the_new_line_is_selected_and_the_old_one_is_not_a_seam():
    source = grid("Bump", bump)
    stairs(source)
    old = pairs(seams_of(source))
    smooth(source)
    new = pairs(seams_of(source))
    selected = {tuple(sorted(each.vertices)) for each in source.data.edges if each.select}
    assert new == selected
    assert old - new  # The lines may share edges, but not all.


def test_wires_other_seams_and_eases_stay_and_the_wire_is_met_at_the_same_places(addon):
    source = grid("Bump", bump, wire=on_line(0, 0.25))
    mark_seam(source, on_line(1, 0.5))
    source.data.attributes.new("wirewarp_side_ease", "FLOAT", "CORNER")
    edges = read(source.data.loops, "edge_index", np.int32)
    outline = np.bincount(edges)[edges] == 1
    eases = np.where(outline, 0.01, 0).astype(np.float32)
    source.data.attributes["wirewarp_side_ease"].data.foreach_set("value", eases)
    stairs(source)
    crossed = on_the_wire(source)
    count = len(source.data.vertices)
    wires = read(source.data.attributes["wirewarp_wire"].data, "value", np.int32)
    select_edges(source, lambda a, b: True)
    fails(mark_allowance_and_smooth, 'selected edges of "Bump" would lose a mark: a wire')
    assert len(source.data.vertices) == count
    assert smooth(source, lambda a, b: max(a[1], b[1]) < 0.45) == {"FINISHED"}
    assert len(crossed) == 2 and crossed == on_the_wire(source)  # where both seams cross the wire
    marked = read(source.data.attributes["wirewarp_wire"].data, "value", np.int32)
    assert np.count_nonzero(marked) == np.count_nonzero(wires)
    eases = read(source.data.attributes["wirewarp_side_ease"].data, "value", np.float32)
    assert np.count_nonzero(eases) == np.count_nonzero(outline)
    assert set(np.unique(eases)) == {np.float32(0), np.float32(0.01)}


def on_the_wire(source):
    seams = seam_places(source).reshape(-1, 3).round(5)
    return {tuple(place) for place in seams[np.abs(seams[:, 0] - 0.25) < 1e-6].tolist()}


def mark_allowance_and_smooth():
    bpy.ops.mesh.wirewarp_allowance(kind="WIDTH", width=5)
    try:
        bpy.ops.mesh.wirewarp_smooth_seam()
    finally:
        bpy.ops.mesh.wirewarp_allowance(kind="DEFAULT")
        bpy.ops.object.mode_set(mode="OBJECT")


def test_lines_that_cannot_be_smoothed_are_reported_and_stay(addon):
    source = grid("Bump", bump)
    fails(smooth, "Nothing to smooth: select edges of a seam first", target=source)
    bpy.ops.object.mode_set(mode="OBJECT")
    mark_seam(source, lambda a, b: all(max(abs(each[0]), abs(each[1])) == 0.5 for each in (a, b, (a + b) / 2)))
    before = edge_vertices(source.data)
    fails(smooth, 'A line of "Bump" meets itself at vertex .* smooth each part', target=source)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert np.array_equal(edge_vertices(source.data), before)
    bpy.ops.object.wirewarp_flatten()
    flat = flat_of(source)
    bpy.context.view_layer.objects.active = flat
    bpy.ops.object.mode_set(mode="EDIT")
    assert not bpy.ops.mesh.wirewarp_smooth_seam.poll()


def edit_with_stairs(*targets):
    """Edit several objects at once, each with a seam along stair steps and all edges selected."""
    for target in targets:
        stairs(target)
        select_edges(target, lambda a, b: True)
        bpy.ops.object.mode_set(mode="OBJECT")
    select_only(*targets)
    bpy.ops.object.mode_set(mode="EDIT")


def test_seams_of_all_edited_objects_are_smoothed():
    targets = [grid(name, bump) for name in ("First", "Second")]
    edit_with_stairs(*targets)
    before = [pairs(seams_of(target)) for target in targets]
    assert bpy.ops.mesh.wirewarp_smooth_seam() == {"FINISHED"}
    assert [target.mode for target in targets] == ["EDIT", "EDIT"]
    bpy.ops.object.mode_set(mode="OBJECT")
    for target, old in zip(targets, before, strict=True):
        selected = {tuple(sorted(each.vertices)) for each in target.data.edges if each.select}
        assert pairs(seams_of(target)) == selected and old - selected


@pytest.mark.parametrize("of", ["one object", "two objects"])
def test_if_a_second_line_fails_the_first_is_not_cut(addon, monkeypatch, of):
    source = grid("Bump", bump)
    if of == "one object":
        stairs(source)
        mark_seam(source, on_line(1, 0.75))
        select_edges(source, lambda a, b: True)
    else:
        edit_with_stairs(source, grid("Other", bump))
    bpy.ops.object.mode_set(mode="OBJECT")
    before = edge_vertices(source.data), seams_of(source), places(source)
    bpy.ops.object.mode_set(mode="EDIT")
    run, calls = addon.suggest.smooth, []
    cut_lines = run.cut_lines

    def cut_once(*arguments):
        if calls:
            raise addon.issues.object_error("no_room", "No.")
        calls.append(arguments)
        return cut_lines(*arguments)

    monkeypatch.setattr(run, "cut_lines", cut_once)
    fails(bpy.ops.mesh.wirewarp_smooth_seam, "No")
    bpy.ops.object.mode_set(mode="OBJECT")
    assert calls
    assert np.array_equal(edge_vertices(source.data), before[0])
    assert np.array_equal(seams_of(source), before[1]) and np.array_equal(places(source), before[2])
