# SPDX-License-Identifier: GPL-3.0-or-later
"""Suggested darts and seams can be smooth lines. The mesh is cut as drawn, and a run has the shown figures."""

import bpy
import numpy as np
import pytest
from everything import draw_panels
from flattening import fails, flatten_fails, flattened
from mathutils import Vector
from suggesting import SUGGEST, add_layers, bent_ring, check_layers, choose_smooth, found, places, suggested
from surfaces import bump, flat_of, grid, on_line, round_bump
from test_smooth_lines import seam_places, surface
from test_suggestions import two_hills


def drawn_on(addon, target):
    """Return the ends of each drawn segment (k,2,3)."""
    lines = addon.overlay.failures.suggested_lines(target, bpy.context.evaluated_depsgraph_get())
    return lines.reshape(-1, 2, 3).astype(float)


def lengths(ends):
    return np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)


def are_alike(ends, others):
    """Return whether lines, given by their ends (k,2,3), equal other lines in any order and direction."""
    apart = [np.abs(ends[:, None] - turned[None]).max(axis=(2, 3)) for turned in (others, others[:, ::-1])]
    is_same = np.minimum(*apart) < 1e-5
    return len(ends) == len(others) and is_same.any(axis=0).all() and is_same.any(axis=1).all()


@pytest.mark.parametrize(
    ("faces", "shape"),
    [("triangles", bump), ("quads", bump), pytest.param("ngons", round_bump, marks=pytest.mark.api)],
)
def test_the_dart_is_cut_as_drawn_and_has_the_claimed_figure(addon, faces, shape):
    source = flattened("Bump", shape, faces=faces)
    cut = choose_smooth(addon, source, "DARTS")
    words = draw_panels(addon)
    assert words.index("Mark and Flatten") < words.index("Marking it adds vertices and edges")
    drawn, on_pieces = drawn_on(addon, source), drawn_on(addon, flat_of(source))
    assert len(on_pieces) == len(drawn)
    area, before = surface(source), places(source)
    assert bpy.ops.object.wirewarp_mend(what="SUGGESTION") == {"FINISHED"}
    assert surface(source) == pytest.approx(area, rel=1e-6)
    assert len(source.data.vertices) > len(before) and np.array_equal(places(source)[: len(before)], before)
    assert are_alike(seam_places(source), drawn)
    assert lengths(seam_places(source)).sum() == pytest.approx(sum(cut.lengths), rel=1e-5)
    (piece,) = addon.state.reports.last_report(source).pieces
    assert piece.ok and piece.needed == pytest.approx(cut.strain, abs=1e-6)
    assert found(addon, source) is None


def test_mirror_images_are_cut_together(addon):
    source = two_hills()
    cuts = suggested(addon, source, "DARTS").cuts
    index, cut = next((index, cut) for index, cut in enumerate(cuts) if len(cut.lengths) == 2 and not cut.edges)
    bpy.ops.object.wirewarp_choose_suggestion(index=index)
    bpy.ops.object.wirewarp_mend(what="SUGGESTION")
    line = seam_places(source).reshape(-1, 3)
    apart = np.linalg.norm(line[:, None] * (-1, 1, 1) - line[None], axis=2).min(axis=1)
    assert apart.max() < 1e-5
    (piece,) = addon.state.reports.last_report(source).pieces
    assert piece.needed == pytest.approx(cut.strain, abs=1e-6)


def test_painted_faces_are_not_entered(addon):
    source = grid("Bump", bump)
    crossed = set(choose_smooth(addon, source, "DARTS").segments.polygons.tolist())
    painted = source.data.attributes.new("wirewarp_no_seam", "BOOLEAN", "FACE")
    painted.data.foreach_set("value", [index in crossed for index in range(len(source.data.polygons))])
    smooth = [cut for cut in suggested(addon, source, "DARTS").cuts if not cut.edges]
    assert smooth
    for cut in smooth:
        assert crossed.isdisjoint(cut.segments.polygons.tolist())


def test_darts_along_edges_may_run_around_painted_faces(addon):
    """Every second face is painted, so smooth lines have no room, and each inner edge is beside a painted face."""
    source = grid("Bump", bump)
    painted = source.data.attributes.new("wirewarp_no_seam", "BOOLEAN", "FACE")
    painted.data.foreach_set("value", [(index + index // 8) % 2 == 0 for index in range(64)])
    cuts = suggested(addon, source, "DARTS", lines="SMOOTH").cuts
    assert all(cut.edges for cut in cuts)
    for polygon, value in zip(source.data.polygons, painted.data, strict=True):
        if value.value:
            assert not any({a, b} <= set(polygon.vertices) for cut in cuts for a, b in cut.diagonals)


def test_a_dart_along_edges_does_not_change_the_mesh(addon):
    source = grid("Bump", bump, faces="triangles")
    cuts = suggested(addon, source, "DARTS", lines="EDGES").cuts
    assert all(cut.edges for cut in cuts)
    both = suggested(addon, source, "DARTS", lines="SMOOTH").cuts
    # A line with a corner is listed only if its strain is lower by at least this share.
    worth_elbows = 0.05
    assert min(cut.strain for cut in both) <= cuts[0].strain / (1 - worth_elbows)
    order = [(cut.is_bent, cut.strain) for cut in both]
    assert order == sorted(order) and not both[0].is_bent
    before, index = places(source), next(index for index, cut in enumerate(both) if cut.edges)
    bpy.ops.object.wirewarp_choose_suggestion(index=index)
    assert bpy.ops.object.wirewarp_mend(what="SUGGESTION") == {"FINISHED"}
    assert np.array_equal(places(source), before)


def test_a_dart_along_diagonals_adds_only_their_edges(addon):
    source = grid("Bump", round_bump, faces="ngons")
    cuts = suggested(addon, source, "DARTS", lines="EDGES").cuts
    index = next(index for index, cut in enumerate(cuts) if cut.diagonals)
    bpy.ops.object.wirewarp_choose_suggestion(index=index)
    new, mesh = len(cuts[index].diagonals), source.data
    assert f"Marking it adds {new} edge" in draw_panels(addon)
    before = len(mesh.vertices), len(mesh.edges) + new, len(mesh.polygons) + new
    bpy.ops.object.wirewarp_mend(what="SUGGESTION")
    assert (len(mesh.vertices), len(mesh.edges), len(mesh.polygons)) == before


@pytest.mark.api
@pytest.mark.parametrize("scale", [1, -1])
def test_lines_that_cross_in_a_face_meet_there(addon, scale):
    source = grid("Bump", bump, faces="triangles")
    source.scale.x = scale
    mesh = source.data
    for name, domain in (("Height", "POINT"), ("Shade", "CORNER")):
        made = mesh.attributes.new(name, "FLOAT", domain)
        corners = range(len(mesh.vertices)) if domain == "POINT" else [loop.vertex_index for loop in mesh.loops]
        for item, vertex in zip(made.data, corners, strict=True):
            item.value = mesh.vertices[vertex].co @ Vector((1, 2, 3))
    line = addon.core.library().SurfacePath
    paths = [line([0, 0], [(0.5, 0.5, 0), (0, 0, 1)]), line([0, 0], [(0, 0.5, 0.5), (1, 0, 0)])]
    before, area, normals = len(mesh.vertices), surface(source), sum((face.normal for face in mesh.polygons), Vector())
    assert addon.suggest.smooth.take_lines(source, paths, with_modifiers=False) == 4
    assert len(mesh.vertices) == before + 3  # one for each end of a line inside an edge, and one for the crossing
    assert surface(source) == pytest.approx(area, rel=1e-6)
    assert sum((face.normal for face in mesh.polygons), Vector()).normalized() @ normals.normalized() > 0.999
    assert not mesh.validate()
    crossing = mesh.vertices[before + 2]
    met = seam_places(source).reshape(-1, 3)
    assert np.isclose(met, list(crossing.co), atol=1e-6).all(axis=1).sum() == 4
    for vertex, item in zip(mesh.vertices, mesh.attributes["Height"].data, strict=True):
        assert item.value == pytest.approx(vertex.co @ Vector((1, 2, 3)), abs=1e-5)
    for loop, item in zip(mesh.loops, mesh.attributes["Shade"].data, strict=True):
        assert item.value == pytest.approx(mesh.vertices[loop.vertex_index].co @ Vector((1, 2, 3)), abs=1e-5)


def test_a_piece_that_no_dart_helps_is_reported_in_one_sentence(addon, monkeypatch):
    source = flattened("Bump", bump, wire=on_line(0, -0.75))
    source.wirewarp_pieces[0].name = "Front"

    def fail(faces, **_):
        why = {"reason": "no_gain", "kind": "dart", "strain": 0.149, "wires": [0]}
        raise addon.core.FlattenError("no_proposal", "", faces=range(len(faces)), arguments=why)

    monkeypatch.setattr(addon.solve.suggest, "start_darts", fail)
    sentence = 'No dart helps "Front", which must stretch by 14.9%: loosen wire "Wire 1" or divide the piece by a seam'
    fails(SUGGEST["DARTS"], sentence)


def narrowest(addon, source):
    """Return the smallest width of a piece of the current model."""
    arrays = addon.state.read_model.object_to_arrays(source, addon.state.marked_mesh.marked_mesh(source), None)
    choices = addon.state.settings.choices_of(bpy.context.scene.wirewarp, 1.0)
    steps = addon.solve.flatten.flatten_arrays(arrays, choices)
    result = addon.solve.steps.in_one_go(steps)
    return min(addon.core.pattern.piece_width(piece) for piece in result.pieces)


def entered(cut):
    """Return the faces that the lines of a cut cross, not only touch."""
    return cut.segments.polygons[(cut.segments.weights.mean(axis=1) > 1e-9).all(axis=1)].tolist()


def choose_beside_painted_face(addon, source):
    """Paint a face that a smooth cut crosses, and choose another smooth cut. No cut may enter the painted face."""
    crossed = entered(choose_smooth(addon, source, "SEAMS"))[0]
    painted = source.data.attributes.new("wirewarp_no_seam", "BOOLEAN", "FACE")
    painted.data.foreach_set("value", [index == crossed for index in range(len(source.data.polygons))])
    chosen = choose_smooth(addon, source, "SEAMS")
    assert not any(crossed in entered(cut) for cut in found(addon, source).cuts if not cut.edges)
    return chosen


def test_a_set_beside_a_painted_face_is_cut_as_drawn_and_has_the_claimed_figures(addon):
    source = bent_ring(12, 6)  # a coarse ring, because the searches take most of the time of this test
    mesh = source.data
    add_layers(source)
    flatten_fails("is closed")
    assert "SMOOTH" in draw_panels(addon)  # the choice of smooth lines
    cut = choose_beside_painted_face(addon, source)
    assert cut.is_set and "Marking it adds vertices and edges" in draw_panels(addon)
    drawn, area, before = drawn_on(addon, source), surface(source), places(source)
    assert bpy.ops.object.wirewarp_mend(what="SUGGESTION") == {"FINISHED"}
    assert surface(source) == pytest.approx(area, rel=1e-5)
    assert len(mesh.vertices) > len(before) and np.array_equal(places(source)[: len(before)], before)
    assert are_alike(seam_places(source), drawn)
    assert lengths(seam_places(source)).sum() == pytest.approx(cut.lengths[0], rel=1e-5)
    pieces = addon.state.reports.last_report(source).pieces
    assert len(pieces) == cut.num_pieces and all(piece.ok for piece in pieces)
    assert max(piece.needed for piece in pieces) == pytest.approx(cut.strain, abs=1e-6)
    assert narrowest(addon, source) == pytest.approx(cut.width, rel=1e-4)
    check_layers(source)
