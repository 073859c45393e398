# SPDX-License-Identifier: GPL-3.0-or-later
"""Allowances marked on edges: they reach the pattern, are drawn at once, and survive what wires survive."""

import bpy
import numpy as np
import pytest
from drawing import Drawing
from surfaces import edge_vertices, flat_of, grid, mark_seam, on_line, read, select_edges, select_only
from two_sided import HEM, SEAM, join_split_and_turn_over, select_side, two_pieces


@pytest.fixture
def source():
    return two_pieces()


def mark_allowance(target, line, **settings):
    select_edges(target, line)
    assert bpy.ops.mesh.wirewarp_allowance(**settings) == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")


def distances(tmp_path, source, line):
    """Of the middles of edges of the model on the line: how far they are from the cut line, in each piece."""
    path = tmp_path / "pattern.svg"
    bpy.ops.object.wirewarp_export(filepath=str(path), allowance=10.0, arrangement="AS_LAID_OUT")
    drawing, flat = Drawing(path), flat_of(source).data
    places = 100 * read(flat.vertices, "co", np.float32, 3)[:, :2]
    model = read(source.data.vertices, "co", np.float32, 3)[
        read(flat.attributes["source_vertex"].data, "value", np.int32)
    ]
    sew = np.concatenate(
        [line for piece in drawing.pieces for layer in ("Sew", "Fold") for line in drawing.lines(piece, layer)]
    )
    offset = (sew * (1, -1)).min(axis=0) - places.min(axis=0)
    edges = [(a, b) for a, b in edge_vertices(flat) if line(model[a], model[b])]
    middles = np.array([(places[a] + places[b]) / 2 for a, b in edges]) + offset
    cuts = [outline * (1, -1) for outline in drawing.outlines()]
    a, along = np.concatenate([cut[:-1] for cut in cuts]), np.concatenate([np.diff(cut, axis=0) for cut in cuts])
    share = np.clip(((middles[:, None] - a) * along).sum(axis=2) / (along**2).sum(axis=1), 0, 1)
    return np.linalg.norm(a + share[..., None] * along - middles[:, None], axis=2).min(axis=1)


def test_marked_widths_are_those_of_the_pattern(source, tmp_path):
    mark_allowance(source, SEAM, kind="WIDTH", width=6.0)
    mark_allowance(source, HEM, kind="HEM", hem=25.0)
    mark_allowance(source, on_line(0, 1.0), kind="FOLD")
    select_only(source)
    bpy.ops.object.wirewarp_flatten(spacing=50.0)
    for line, width in ((SEAM, 6.0), (HEM, 25.0), (on_line(0, 1.0), 0.0), (on_line(0, -1.0), 10.0)):
        assert np.max(distances(tmp_path, source, line)) == pytest.approx(width, abs=0.02)


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_marked_widths_stay_when_the_unit_is_set(addon, source, mode):
    mark_allowance(source, SEAM, kind="WIDTH", width=6.0)
    mark_allowance(source, HEM, kind="FOLD")
    twin = bpy.data.objects.new("Twin", source.data)  # of the same mesh
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


def test_a_mark_goes_back_to_the_default(source, tmp_path):
    bpy.ops.object.wirewarp_flatten(spacing=50.0)
    mark_allowance(source, SEAM, kind="WIDTH", width=6.0)
    mark_allowance(source, SEAM, kind="DEFAULT")
    assert np.max(distances(tmp_path, source, SEAM)) == pytest.approx(10.0, abs=0.02)


def test_edges_that_come_from_elsewhere_have_the_default(source, tmp_path):
    """Blender gives them 0, which is no width."""
    mark_allowance(source, SEAM, kind="WIDTH", width=6.0)
    other = grid("Other", lambda x, y: (x + 3, y, 0))
    select_only(source, other)
    bpy.context.view_layer.objects.active = source
    bpy.ops.object.join()
    bpy.ops.object.wirewarp_flatten(spacing=50.0)
    assert np.max(distances(tmp_path, source, SEAM)) == pytest.approx(6.0, abs=0.02)
    assert np.max(distances(tmp_path, source, on_line(0, 4.0))) == pytest.approx(10.0, abs=0.02)


def mark_side(source, side, **settings):
    """On the piece that lies left (-1) or right (1) of the seam on the model."""
    select_side(source, side)
    assert bpy.ops.mesh.wirewarp_allowance(**settings) == {"FINISHED"}
    assert flat_of(source).mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    select_only(source)


def widths_at_seam(tmp_path, source):
    """Of its sides, the smallest first."""
    found = np.sort(distances(tmp_path, source, SEAM))
    half = len(found) // 2
    return [float(np.median(found[:half])), float(np.median(found[half:]))]


def test_each_side_of_a_seam_can_have_its_own_width(source, tmp_path):
    bpy.ops.object.wirewarp_flatten(spacing=50.0)
    mark_side(source, -1, kind="WIDTH", width=15.0)
    assert widths_at_seam(tmp_path, source) == pytest.approx([10.0, 15.0], abs=0.02)
    mark_side(source, 1, kind="WIDTH", width=6.0)
    assert widths_at_seam(tmp_path, source) == pytest.approx([6.0, 15.0], abs=0.02)
    mark_side(source, -1, kind="DEFAULT")
    assert widths_at_seam(tmp_path, source) == pytest.approx([6.0, 10.0], abs=0.02)
    mark_side(source, -1, kind="FOLD")
    assert widths_at_seam(tmp_path, source) == pytest.approx([0.0, 6.0], abs=0.02)
    mark_allowance(source, SEAM, kind="WIDTH", width=12.0)
    select_only(source)
    assert widths_at_seam(tmp_path, source) == pytest.approx([12.0, 12.0], abs=0.02)


def test_both_sides_of_a_seam_can_be_marked_at_once(source, tmp_path):
    bpy.ops.object.wirewarp_flatten(spacing=50.0)
    select_only(flat_of(source))
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.wirewarp_allowance(kind="WIDTH", width=15.0)
    bpy.ops.object.mode_set(mode="OBJECT")
    select_only(source)
    assert widths_at_seam(tmp_path, source) == pytest.approx([15.0, 15.0], abs=0.02)


def test_the_width_of_a_side_survives_what_wires_survive(source, tmp_path):
    """Splitting edges, turning faces over, joining, another unit, a mirrored object and modifiers."""
    bpy.ops.object.wirewarp_flatten(spacing=50.0)
    mark_side(source, -1, kind="WIDTH", width=15.0)
    mark_side(source, 1, kind="WIDTH", width=6.0)
    join_split_and_turn_over(source)
    bpy.ops.scene.wirewarp_set_unit(meters=0.1)
    source.scale.x = -1
    bpy.ops.object.wirewarp_flatten(spacing=50.0)
    assert widths_at_seam(tmp_path, source) == pytest.approx([6.0, 15.0], abs=0.02)


def test_scripts_may_write_the_width_of_a_side_on_corners(source, tmp_path):
    sides = source.data.attributes.new("wirewarp_side_allowance", "FLOAT", "CORNER")
    places = read(source.data.vertices, "co", np.float32, 3)
    for polygon in source.data.polygons:
        for corner, vertex, following in zip(
            polygon.loop_indices, polygon.vertices, [*polygon.vertices[1:], polygon.vertices[0]], strict=True
        ):
            if SEAM(places[vertex], places[following]) and polygon.center.x < 0:
                sides.data[corner].value = 0.15
    bpy.ops.object.wirewarp_flatten(spacing=50.0)
    assert widths_at_seam(tmp_path, source) == pytest.approx([10.0, 15.0], abs=0.02)
    mark_side(source, 1, kind="WIDTH", width=6.0)
    assert widths_at_seam(tmp_path, source) == pytest.approx([6.0, 15.0], abs=0.02)


def test_two_widths_of_one_side_are_refused_until_it_is_marked_again(source, tmp_path):
    bpy.ops.object.wirewarp_flatten(spacing=50.0)
    mark_side(source, -1, kind="WIDTH", width=15.0)
    corners = source.data.attributes.new("wirewarp_side_allowance", "FLOAT", "CORNER").data
    corners.foreach_set("value", np.full(len(corners), 0.06, dtype=np.float32))
    with pytest.raises(RuntimeError, match="have two allowances of one side.*mark their allowance again"):
        distances(tmp_path, source, SEAM)
    mark_side(source, -1, kind="WIDTH", width=15.0)
    mark_side(source, 1, kind="WIDTH", width=6.0)
    assert widths_at_seam(tmp_path, source) == pytest.approx([6.0, 15.0], abs=0.02)


def test_one_side_of_pieces_made_with_modifiers_is_refused(source):
    source.modifiers.new("Subdivision", "SUBSURF").levels = 1
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    select_only(flat_of(source))
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    with pytest.raises(RuntimeError, match='The pieces of "Bump" were made with Modifiers'):
        bpy.ops.mesh.wirewarp_allowance(kind="WIDTH")


def test_the_width_of_a_side_goes_through_modifiers(source, addon):
    bpy.ops.object.wirewarp_flatten(spacing=50.0)
    mark_side(source, -1, kind="WIDTH", width=15.0)
    source.modifiers.new("Subdivision", "SUBSURF").levels = 2
    bpy.ops.object.wirewarp_flatten(spacing=50.0, use_modifiers=True)
    choices = addon.export.export.PatternChoices(10.0, 100.0, "close")
    pieces = addon.solve.steps.in_one_go(
        addon.export.read.read_pattern(bpy.context.scene, source).making(choices)
    ).pieces
    sewn = [[line.width for line in piece.of_role("sew") if line.seam is not None] for piece in pieces]
    assert sorted(sewn) == [pytest.approx([10.0]), pytest.approx([15.0])]


def test_one_side_of_a_seam_between_parts_of_a_face_can_be_marked(source, addon):
    """A loop cut copies what tells faces apart."""
    bpy.ops.object.wirewarp_flatten()
    mark_side(source, 1, kind="WIDTH", width=15.0)
    select_edges(source, lambda a, b: min(a.x, b.x) == 0 and max(a.x, b.x) == 0.25)
    bpy.ops.mesh.subdivide(number_cuts=1)
    beside = on_line(0, 0.125)
    mark_seam(source, beside)
    mesh = source.data
    edges = [edge.index for edge in mesh.edges if beside(*(mesh.vertices[v].co for v in edge.vertices))]
    faces = [polygon for polygon in mesh.polygons if 0 < polygon.center.x < 0.125]
    loops = [loop for polygon in faces for loop in polygon.loop_indices if mesh.loops[loop].edge_index in edges]
    assert addon.state.allowances.mark_sides(mesh, np.array(loops), 0.2) == 8
    widths = addon.state.allowances.read_allowances(mesh).side_widths
    assert sorted(widths) == pytest.approx(8 * [0.15] + 8 * [0.2])


def test_edges_inside_of_a_piece_get_none(source):
    select_edges(source, on_line(1, 0.0))
    with pytest.raises(RuntimeError, match="Nothing to mark: select edges on a seam or outline first"):
        bpy.ops.mesh.wirewarp_allowance(kind="WIDTH")


def test_another_attribute_of_the_name_is_a_sentence(source):
    source.data.attributes.new("wirewarp_allowance", "INT", "FACE")
    select_edges(source, SEAM)
    with pytest.raises(RuntimeError, match='"wirewarp_allowance" of mesh "Bump" is not of type FLOAT on edges'):
        bpy.ops.mesh.wirewarp_allowance(kind="WIDTH")


def drawn(addon, source, allowance=10.0):
    """The size of the line to cut, as it is drawn, in Blender units."""
    depsgraph = bpy.context.evaluated_depsgraph_get()
    pages = addon.overlay.pages
    parts = pages.outlines(bpy.context.scene, source, flat_of(source), depsgraph)
    cut = pages.cut_lines(parts, allowance, "close")
    lines = pages.cut_places(cut, 100.0)
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
