# SPDX-License-Identifier: GPL-3.0-or-later
"""Borders of UV islands can become seams, and Flatten offers them if they help."""

import bpy
import numpy as np
import pytest
from everything import draw_panels, drawn_buttons
from flattening import edge_vertices, fails, flatten, flatten_fails, flattened
from mathutils import Vector
from surfaces import bump, everywhere, grid, mark_seam, on_edges, on_line, read, select_only

CUT, ACROSS = on_line(0, 0.0), on_line(1, 0.0)
MARK = bpy.ops.mesh.wirewarp_seams_from_uv_islands


def with_islands(faces="quads"):
    """Return a grid with a UV map of its x and y, in which the faces at x > 0 are moved aside."""
    target = grid("Bump", bump, faces=faces)
    mesh = target.data
    layer = mesh.uv_layers.new(name="Map")
    for face in mesh.polygons:
        for loop in face.loop_indices:
            x, y, _ = mesh.vertices[mesh.loops[loop].vertex_index].co
            layer.data[loop].uv = (x + 5 * (face.center.x > 0), y)
    return target


def seam_edges(mesh):
    return set(map(tuple, np.sort(edge_vertices(mesh)[read(mesh.edges, "use_seam", bool)], axis=1).tolist()))


def edges_on(mesh, *lines):
    ends = ((pair, [mesh.vertices[v].co for v in pair]) for pair in np.sort(edge_vertices(mesh), axis=1).tolist())
    return {tuple(pair) for pair, (a, b) in ends if any(line(a, b) for line in lines)}


@pytest.mark.api
@pytest.mark.parametrize("faces", ["quads", "triangles", "ngons"])
def test_the_borders_of_islands_become_seams_and_present_ones_stay(faces):
    target = with_islands(faces)
    mark_seam(target, ACROSS)
    present = edges_on(target.data, ACROSS)
    assert on_edges(target, MARK) == {"FINISHED"}
    borders = edges_on(target.data, CUT)
    assert len(borders) == 8 and seam_edges(target.data) == borders | present


@pytest.mark.api
def test_after_a_run_the_users_own_map_is_read(capfd):
    target = with_islands()
    flatten(target)
    assert target.data.uv_layers.active.name == "WireWarp"
    on_edges(target, MARK)
    assert '8 edges marked as seam, from the UV map "Map"' in capfd.readouterr().out
    assert seam_edges(target.data) == edges_on(target.data, CUT)
    target.data.uv_layers["Map"].name = "Lightmap"
    target.data.uv_layers.new(name="Islands", do_init=False).active_render = True
    target.data.uv_layers.active = target.data.uv_layers["WireWarp"]
    on_edges(target, MARK)
    assert 'the UV map "Islands"' in capfd.readouterr().out


@pytest.mark.api
def test_the_active_map_is_read_and_a_missing_map_is_refused(capfd):
    target = with_islands()
    plain = target.data.uv_layers.new(name="Plain", do_init=False)  # All corners are at one point of this map.
    target.data.uv_layers.active = plain
    assert on_edges(target, MARK) == {"CANCELLED"}
    assert 'No new seams: every island border of the UV map "Plain" is a seam already' in capfd.readouterr().out
    assert seam_edges(target.data) == set()
    select_only(target, grid("Bare", bump))
    bpy.ops.object.mode_set(mode="EDIT")
    fails(MARK, '"Bare" has no UV map')
    bpy.ops.object.mode_set(mode="OBJECT")
    assert seam_edges(target.data) == set()  # Either all selected models get seams or none does.
    other = flattened("Bump", bump, seam=CUT)
    on_edges(other, bpy.ops.mesh.mark_seam, everywhere, clear=True)
    on_edges(other, MARK)
    assert '8 edges marked as seam, from the UV map "WireWarp"' in capfd.readouterr().out


def cube(*, with_map=True):
    """Return a closed cube. Its UV map has one island with all six faces."""
    bpy.ops.mesh.primitive_cube_add(calc_uvs=with_map)
    return bpy.context.active_object


def uv_seams_of(addon, source):
    return addon.state.reports.last_report(source).uv_seams


def test_the_seams_of_the_map_are_tried_and_offered_first_if_pieces_fail(addon):
    source = cube()
    flatten_fails("is closed")
    found = uv_seams_of(addon, source)
    assert (found.pieces, found.failed, found.is_good) == (1, 0, True)
    assert found.stretch == pytest.approx(0, abs=1e-6)
    assert len(seam_edges(source.data)) == 0
    report = addon.state.reports.last_report(source)
    step = addon.report_panel.next_step.next_step(report, [])
    assert step.sentence == "The seams of the UV map make 1 piece, with a stretch of 0.0%."
    assert bpy.ops.object.wirewarp_mend(**step.settings) == {"FINISHED"}
    assert len(seam_edges(source.data)) == 7  # 12 edges, minus 5 that connect the 6 faces of the island
    assert addon.core.verdict(addon.state.reports.last_report(source)).is_ready
    assert uv_seams_of(addon, source) is None


def test_seams_of_the_map_beyond_the_fabric_come_after_suggestions(addon):
    bpy.ops.mesh.primitive_uv_sphere_add(segments=16, ring_count=8)
    source = bpy.context.active_object
    flatten_fails("is closed", cloth="MINKY")
    found = uv_seams_of(addon, source)
    assert found.is_beyond_fabric and not found.is_good and found.stretch > 0.2  # Minky stretches 20% across.
    assert ", too much for this fabric." in draw_panels(addon)
    buttons = drawn_buttons(addon)
    assert buttons.index("object.wirewarp_suggest_seams") < buttons.index("object.wirewarp_mend")
    flatten_fails("is closed")  # Without a fabric, the seams of the map are good enough.
    assert uv_seams_of(addon, source).is_good


def test_before_the_first_run_the_seams_of_the_map_are_a_button(addon):
    source = with_islands()
    assert "object.wirewarp_mend" in drawn_buttons(addon)
    assert bpy.ops.object.wirewarp_mend(what="UV_SEAMS") == {"FINISHED"}
    assert len(addon.state.reports.last_report(source).pieces) == 2
    marked = with_islands()
    mark_seam(marked, ACROSS)
    assert "object.wirewarp_mend" not in drawn_buttons(addon)


def test_without_a_map_or_with_modifiers_no_seams_of_a_map_are_tried(addon):
    source = cube(with_map=False)
    flatten_fails("is closed")
    assert uv_seams_of(addon, source) is None
    bpy.ops.object.delete()
    source = cube()
    source.modifiers.new("Finer", "SUBSURF").levels = 1
    flatten_fails("is closed", use_modifiers=True)
    assert uv_seams_of(addon, source) is None


def test_seams_of_a_map_that_lowers_the_stretch_are_offered_for_a_model_without_seams(addon):
    source = with_islands()
    flatten(source)
    _, by_map = addon.flatten.read.solved_pieces(source)
    assert by_map.size == 2  # pieces that are kept, so that marking the seams solves nothing again
    report = addon.state.reports.last_report(source)
    assert report.uv_seams.pieces == 2 and 0 < report.uv_seams.stretch < report.pieces[0].needed
    mark_seam(source, ACROSS)
    flatten(source)
    assert uv_seams_of(addon, source) is None


def test_canceling_while_the_seams_of_the_map_are_tried_keeps_the_pieces(addon, monkeypatch):
    source, scene, solver = with_islands(), bpy.context.scene, addon.flatten.models
    flatten_arrays, runs, fractions = solver.flatten_arrays, [], []

    def counting(*what):
        runs.append(what)
        yield 0.0
        return (yield from flatten_arrays(*what))

    monkeypatch.setattr(solver, "flatten_arrays", counting)
    models = addon.flatten.read.read_models(bpy.context, [source], scene.wirewarp)
    choices = addon.state.settings.choices_of(scene.wirewarp, 1.0)
    running = solver.solve_models(models, choices, 1.0)
    while len(runs) < 2:
        fractions.append(next(running))
    with pytest.raises(StopIteration) as end:
        running.throw(addon.solve.steps.CanceledError())
    (outcome,) = end.value.value
    assert outcome.pieces is not None and outcome.report.uv_seams is None
    assert fractions == sorted(fractions) and fractions[-1] == 0.5


def test_seams_of_the_map_are_offered_although_some_of_their_pieces_exceed_every_fabric(addon):
    """The model is a cube, which unfolds, and a sphere of two islands. The larger island must stretch too far."""
    bpy.ops.mesh.primitive_uv_sphere_add(segments=16, ring_count=8)
    sphere = bpy.context.active_object
    mesh = sphere.data
    uv = mesh.uv_layers.active.data
    for face in mesh.polygons:
        for loop in face.loop_indices:
            uv[loop].uv = mesh.vertices[mesh.loops[loop].vertex_index].co.xy / 4 + Vector((face.center.z > 0.4, 0.5))
    source = cube()
    sphere.select_set(True)
    bpy.ops.object.join()
    flatten_fails("is closed")
    found = uv_seams_of(addon, source)
    assert (found.pieces, found.failed, found.beyond_any, found.is_good) == (3, 0, 1, True)
    said = f"make 3 pieces, 1 with a stretch over 100%, the others with {addon.core.percent_text(found.stretch)}."
    assert said in draw_panels(addon)
    assert bpy.ops.object.wirewarp_mend(what="UV_SEAMS") == {"FINISHED"}
    pieces = addon.state.reports.last_report(source).pieces
    assert sorted(piece.needed > 1 for piece in pieces) == [False, False, True]


def test_an_island_for_each_face_comes_after_suggestions(addon):
    source = cube()
    on_edges(source, bpy.ops.mesh.subdivide, everywhere, number_cuts=3)
    uv = source.data.uv_layers.active.data
    for face in source.data.polygons:
        for loop in face.loop_indices:
            uv[loop].uv.x += 2 * face.index
    flatten_fails("is closed")
    found = uv_seams_of(addon, source)
    assert (found.pieces, found.usable, found.is_good) == (96, 96, False)
    buttons = drawn_buttons(addon)
    assert buttons.index("object.wirewarp_suggest_seams") < buttons.index("object.wirewarp_mend")
