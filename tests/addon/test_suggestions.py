# SPDX-License-Identifier: GPL-3.0-or-later
"""Suggested darts and seams have the figures of a run with them. They are shown, marked, undone and refused."""

import math
from dataclasses import replace

import bpy
import numpy as np
import pytest
from everything import AnyLayout, draw_panels, drawn_buttons, sidebar
from flattening import edge_vertices, fails, flattened, raise_vertex
from suggesting import SUGGEST, are_mirrored, found, needed, pairs, suggested
from surfaces import bump, flat_of, grid, half_cylinder, make_object, mark, on_line, read, tube
from test_proposals import seams_of
from view_context import view_context

SIDES = ("wirewarp_side_ease", "wirewarp_side_allowance")


def two_hills(size=8):
    """Return a model that is its own mirror image across x = 0, in shape and mesh."""
    steps = [2 * i / size - 1 for i in range(size + 1)]
    vertices = [(x, y, 0.5 * math.exp(-6 * ((abs(x) - 0.5) ** 2 + (y - 0.75) ** 2))) for y in steps for x in steps]
    row, faces = size + 1, []
    for y in range(size):
        for x in range(size):
            a, b, c, d = (y * row + x + offset for offset in (0, 1, row + 1, row))
            faces += [[a, b, c], [a, c, d]] if 2 * x < size else [[a, b, d], [b, c, d]]
    return make_object("Hills", vertices, faces)


@pytest.mark.parametrize(("kind", "faces"), [("SEAMS", "triangles"), ("DARTS", "quads")])
def test_the_figures_are_those_of_flattening_with_the_cut(addon, kind, faces):
    source = grid("Bump", bump, size=6, faces=faces)
    bpy.context.scene.wirewarp.dart_lines = "EDGES"
    assert SUGGEST[kind]() == {"FINISHED"}
    suggestions = found(addon, source)
    assert (suggestions.kind, suggestions.chosen, suggestions.target) == (kind, 0, None)
    edges = pairs(edge_vertices(source.data))
    for cut in suggestions.cuts:
        assert pairs(cut.edges) - edges == pairs(cut.diagonals) and cut.strain < cut.strain_before
        places = read(source.data.vertices, "co", np.float32, 3)[np.array(cut.edges)]
        assert sum(cut.lengths) == pytest.approx(np.linalg.norm(places[:, 1] - places[:, 0], axis=1).sum(), rel=1e-6)
    assert bpy.ops.object.wirewarp_mend(what="SUGGESTION") == {"FINISHED"}
    assert pairs(seams_of(source)) == pairs(suggestions.cuts[0].edges)
    assert pairs(edge_vertices(source.data)) - edges == pairs(suggestions.cuts[0].diagonals)
    flattened = addon.state.reports.last_report(source).pieces
    assert len(flattened) == (1 if kind == "DARTS" else 1 + len(suggestions.cuts[0].lengths))
    # A quad has one figure for two triangles, so quads are not compared.
    if faces == "triangles":
        assert needed(addon, source) == pytest.approx(suggestions.cuts[0].strain, rel=1e-5)


def test_mirror_images_are_one_suggestion_and_the_least_strain_is_first(addon, capfd):
    source = two_hills()
    cuts = suggested(addon, source, "DARTS", lines="EDGES").cuts
    mirrored = [cut for cut in cuts if len(cut.lengths) == 2]
    assert mirrored and [cut.strain for cut in cuts] == sorted(cut.strain for cut in cuts)
    assert all(are_mirrored(source, cut.edges) for cut in mirrored)
    assert "2×" in draw_panels(addon)
    assert f"{len(cuts)} suggestions. Best: stretch" in capfd.readouterr().out


def test_the_list_belongs_to_the_chosen_piece_and_is_cleared_when_the_model_changes(addon, capfd):
    source = flattened("Bump", bump, size=6, seam=on_line(0, 0.0))
    source.wirewarp_pieces[1].name = "Left Half"
    buttons = drawn_buttons(addon)
    assert {"object.wirewarp_suggest_darts", "object.wirewarp_suggest_seams"} <= set(buttons)
    assert "object.wirewarp_choose_suggestion" not in buttons
    SUGGEST["DARTS"](piece=1)
    assert ', for "Left Half".' in capfd.readouterr().out
    assert {cut.piece for cut in found(addon, source).cuts} == {1}
    words = draw_panels(addon)
    assert "Suggested Darts, Left Half" in words
    assert words.count("stretch") >= 2 * len(found(addon, source).cuts)  # narrow and wide
    assert "object.wirewarp_mend" in drawn_buttons(addon)
    raise_vertex(source, vertex=24)
    assert found(addon, source) is None
    assert "Suggested Darts" not in draw_panels(addon)
    fails(bpy.ops.object.wirewarp_mend, 'There are no suggestions for the present shape of "Bump"', what="SUGGESTION")
    fails(SUGGEST["DARTS"], '"Bump" has changed since it was flattened', piece=1)


def test_the_chosen_cut_is_drawn_on_model_and_pieces(addon, at_once):
    source = flattened("Bump", bump, size=6)
    first, second, *_ = suggested(addon, source, "DARTS", lines="EDGES").cuts

    def drawn():
        lines = {each.target: each.failures for each in addon.overlay.shown.drawings(view_context())}
        return [
            {tuple(place) for place in lines[target].lines["proposed"].tolist()} if lines[target] else None
            for target in (source, flat_of(source))
        ]

    def expected(cut):
        places = read(source.data.vertices, "co", np.float32, 3)
        flat = flat_of(source).data
        sources = read(flat.attributes["source_vertex"].data, "value", np.int32)
        flat_places = read(flat.vertices, "co", np.float32, 3)[np.isin(sources, np.array(cut.edges))]
        return [{tuple(place) for place in each.tolist()} for each in (places[np.unique(cut.edges)], flat_places)]

    assert drawn() == expected(first)
    assert bpy.ops.object.wirewarp_choose_suggestion(index=1) == {"FINISHED"}
    assert drawn() == expected(second)
    bpy.ops.object.wirewarp_choose_suggestion(index=100)
    assert found(addon, source).chosen == 1
    source.scale.x = 2.0
    bpy.context.view_layer.update()
    assert drawn() == [None, None]
    source.scale.x = 1.0
    bpy.context.view_layer.update()
    assert drawn() == expected(second)
    bpy.ops.object.wirewarp_drop_suggestions()
    assert drawn() == [None, None]
    bpy.context.view_layer.objects.active = None
    for operator in (bpy.ops.object.wirewarp_choose_suggestion, bpy.ops.object.wirewarp_drop_suggestions):
        assert not operator.poll()


def test_the_chosen_cut_is_drawn_in_edit_mode_until_the_mesh_changes(addon, at_once):
    source = flattened("Bump", bump, size=6)
    SUGGEST["DARTS"]()

    def drawn(target=source):
        (own,) = (each for each in addon.overlay.shown.drawings(view_context()) if each.target == target)
        return own.failures.lines["proposed"] if own.failures else None

    in_object_mode, on_flat = drawn(), drawn(flat_of(source))
    bpy.ops.object.mode_set(mode="EDIT")
    assert np.array_equal(drawn(), in_object_mode) and np.array_equal(drawn(flat_of(source)), on_flat)
    raise_vertex(source, vertex=24)
    assert drawn() is None and drawn(flat_of(source)) is None


class Buttons(AnyLayout):
    """Accepts everything that a panel draws, and keeps the names of operators that can be clicked."""

    def __init__(self, words, clickable, is_enabled=True):
        vars(self).update(words=words, clickable=clickable, is_enabled=is_enabled)

    def __getattr__(self, _name):
        return lambda *_, **__: Buttons(self.words, self.clickable, self.is_enabled)

    def __setattr__(self, name, value):
        if name == "enabled":
            vars(self)["is_enabled"] &= value

    def operator(self, name, **_):
        if self.is_enabled:
            self.clickable.append(name)
        return Buttons(self.words, self.clickable, self.is_enabled)


def test_the_list_of_an_earlier_search_cannot_be_clicked_during_the_next_search(addon, monkeypatch):
    grid("Bump", bump, size=6)
    SUGGEST["DARTS"]()
    panel = addon.suggest.panel

    def drawn():
        words, clickable = [], []
        panel.draw_suggestions(sidebar(600), Buttons(words, clickable), "FLATTEN")
        return " ".join(words), clickable

    assert panel.EARLIER not in drawn()[0] and "object.wirewarp_choose_suggestion" in drawn()[1]
    monkeypatch.setattr(panel, "is_running", lambda task: task is panel.SUGGEST)
    assert panel.EARLIER in drawn()[0] and drawn()[1] == []


def flattened_for(addon, source, index):
    """Mark a suggested set, and flatten for the fabric of the panel.

    Return the set, the texts of the panels before it was marked, and the verdict.
    """
    bpy.ops.object.wirewarp_choose_suggestion(index=index)
    suggestions, shown = found(addon, source), draw_panels(addon)
    bpy.ops.object.wirewarp_mend(what="SUGGESTION")
    settings = bpy.context.scene.wirewarp
    bpy.ops.object.wirewarp_flatten(
        cloth=settings.cloth, gives_across=settings.gives_across, gives_along=settings.gives_along
    )
    return suggestions.cuts[index], shown, addon.state.reports.last_report(source).tables.verdict


@pytest.mark.core
def test_a_set_that_needs_more_than_the_tighter_direction_is_chosen_if_the_verdict_allows_it(addon):
    bpy.ops.mesh.primitive_torus_add(major_radius=0.1, minor_radius=0.05)
    source = bpy.context.object
    bpy.context.scene.wirewarp.cloth = "MINKY"  # It stretches 20% across and 5% along the grain.
    SUGGEST["SEAMS"]()
    cut, shown, verdict = flattened_for(addon, source, found(addon, source).chosen)
    assert cut.strain > 0.05 and "more than this minky can" not in shown
    needs = max(piece.needed for piece in addon.state.reports.last_report(source).pieces)
    assert cut.strain == pytest.approx(needs, rel=1e-6)
    assert verdict.kind is addon.core.Kind.READY


@pytest.mark.core
def test_a_set_beyond_the_fabric_says_so_before_it_is_marked_and_names_the_next_step(addon):
    bpy.ops.mesh.primitive_uv_sphere_add(segments=24, ring_count=12, radius=0.1)
    source, settings, keep = bpy.context.object, bpy.context.scene.wirewarp, addon.state.suggestions.keep
    settings.cloth, settings.gives_across, settings.gives_along = "MINKY", 30, 0.5
    suggestions = suggested(addon, source, "SEAMS")
    beyond, name = suggestions.cuts[0], suggestions.names[:1]
    enough = replace(beyond, threads=replace(beyond.threads, across=0.0, along=0.0))
    keep(source, replace(suggestions, cuts=[beyond, enough], names=2 * name))
    bpy.ops.object.wirewarp_choose_suggestion(index=0)
    assert "more than this minky can. Click a row with less stretch." in draw_panels(addon)
    bpy.ops.object.wirewarp_choose_suggestion(index=1)
    assert "more than this minky can" not in draw_panels(addon)
    keep(source, replace(suggestions, cuts=[replace(beyond, cleared=[(0, 1)])], names=name, chosen=0))
    assert "can. Choose a fabric that stretches more, or enter a smaller Max Stretch" in draw_panels(addon)
    keep(source, replace(suggestions, cuts=[beyond], names=name, chosen=0))
    cut, shown, verdict = flattened_for(addon, source, 0)
    across, along = (addon.core.percent_text(each) for each in (cut.threads.across, cut.threads.along))
    said = f"A piece must stretch {across} across and {along} along, more than this minky can."
    assert f"{said} Choose a fabric that stretches more, or mark this set and then add darts." in shown
    assert verdict.kind is addon.core.Kind.BEYOND_FABRIC and any(along in line.text for line in verdict.lines)


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: grid("Half", half_cylinder), "is flat enough"),
        (lambda: mark(grid("Small", bump, size=2), on_line(0, 0.0)), "has no room for a dart"),
        (tube, "mark a seam"),
        (bpy.ops.mesh.primitive_cube_add, "closed"),
    ],
)
def test_without_suggestions_the_reason_is_reported(make, said):
    make()
    fails(SUGGEST["DARTS"], said)


def test_changed_settings_are_reported(addon, capfd):
    source = grid("Bump", bump, size=6, wire=on_line(0, 0.0))
    settings = bpy.context.scene.wirewarp
    SUGGEST["DARTS"]()
    assert ", for Piece 1." in capfd.readouterr().out  # The piece has no name yet.
    settings.spacing, settings.mirror, settings.layout_kind = 50, True, "ROW"
    settings.orientation, settings.grain_angle, settings.gives_across = "BOUNDARY", 0.5, 10
    assert "Search again" not in draw_panels(addon)  # These settings do not affect the figures.
    settings.fairness = 0.2
    assert "Settings changed after the search: Smooth Outlines. Search again." in draw_panels(addon)
    settings.cloth, settings.orientation = "WOVEN", "WIRE"  # With a fabric, the figures depend on the grain wire.
    SUGGEST["DARTS"]()
    source.data.wirewarp_grain = source.data.wirewarp_names[0].wire_id
    assert "Settings changed after the search: Grain Wire. Search again." in draw_panels(addon)
    SUGGEST["DARTS"]()
    assert "Search again" not in draw_panels(addon)
    settings.grain_angle = 0.7
    assert "Settings changed after the search: Grain Angle. Search again." in draw_panels(addon)


def test_a_cut_across_quads_leaves_marks_maps_and_surface(addon):
    """The best cut follows a ridge along the diagonals of faces."""
    source = grid("Ridge", lambda x, y: (x, y, 0.6 * math.exp(-8 * (x - y) ** 2) * (1 - x * x) * (1 - y * y)))
    mark(source, lambda a, b: on_line(1, -0.75)(a, b) and max(a[0], b[0]) < -0.4)
    for name in SIDES:
        write_sides(source.data, name)
    layer = source.data.uv_layers.new(name="Mine")
    layer.data.foreach_set("uv", np.arange(2 * len(source.data.loops), dtype=np.float32))
    source.vertex_groups.new(name="Half").add([0, 1, 2], 0.5, "REPLACE")
    cuts = suggested(addon, source, "SEAMS").cuts
    index = next(index for index, cut in enumerate(cuts) if cut.diagonals)
    bpy.ops.object.wirewarp_choose_suggestion(index=index)
    assert "across faces of the model" in draw_panels(addon)
    uv = {tuple(corner.uv) for corner in layer.data}
    triangles = triangles_of(source)
    wires = read(source.data.attributes["wirewarp_wire"].data, "value", np.int32)
    sides = [sides_of(source.data, name) for name in SIDES]
    bpy.ops.object.wirewarp_mend(what="SUGGESTION")
    mesh = source.data
    assert triangles_of(source) == triangles
    after = read(mesh.attributes["wirewarp_wire"].data, "value", np.int32)
    assert np.array_equal(after[: len(wires)], wires) and not after[len(wires) :].any()
    assert [sides_of(mesh, name) for name in SIDES] == sides
    assert source.vertex_groups["Half"].weight(1) == 0.5
    assert {tuple(corner.uv) for corner in mesh.uv_layers["Mine"].data} == uv
    assert addon.state.reports.last_report(source).pieces[0].ok


def write_sides(mesh, name):
    """Set a different value on each side of each edge. Without seams, eases of one side need outline edges."""
    edges = read(mesh.loops, "edge_index", np.int32)
    is_asked = (name == "wirewarp_side_allowance") | (np.bincount(edges)[edges] == 1)
    values = np.where(is_asked, np.linspace(0.01, 0.02, len(edges)), 0).astype(np.float32)
    mesh.attributes.new(name, "FLOAT", "CORNER").data.foreach_set("value", values)


def sides_of(mesh, name):
    """Return the nonzero values, keyed by the two vertices of their edges in the order of the corners."""
    starts = read(mesh.loops, "vertex_index", np.int32)
    following = np.concatenate([np.roll(polygon.loop_indices, -1) for polygon in mesh.polygons])
    values = read(mesh.attributes[name].data, "value", np.float32)
    return {(a, b): value for a, b, value in zip(starts, starts[following], values, strict=True) if value}


def triangles_of(source):
    source.data.calc_loop_triangles()
    return {tuple(sorted(each.vertices)) for each in source.data.loop_triangles}
