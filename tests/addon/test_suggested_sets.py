# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts are suggested up to a target, for closed models and models with modifiers, and not in painted areas."""

from dataclasses import replace
from itertools import pairwise
from unittest.mock import MagicMock

import bpy
import numpy as np
import pytest
from everything import draw_panels, drawn_buttons
from flattening import fails, flatten_fails, flattened, notify, report_after
from suggesting import SUGGEST, cancel_at, found, needed, pairs, suggested
from surfaces import bump, flat_of, grid, join_cube, new_object, on_line, read
from test_proposals import seams_of
from view_context import view_context


def ball():
    """Return a closed ball of triangles, smaller on one side."""
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=2)
    source = bpy.context.object
    places = read(source.data.vertices, "co", np.float32, 3)
    source.data.vertices.foreach_set("co", (places * (1 + 0.3 * places[:, :1])).ravel())
    source.data.update()
    return source


def test_a_closed_model_gets_cut_sets_of_which_one_is_marked(addon, capfd):
    source = ball()
    bpy.context.scene.wirewarp.dart_lines = "EDGES"
    flatten_fails("is closed")
    buttons = drawn_buttons(addon)
    assert "object.wirewarp_suggest_seams" in buttons and "object.wirewarp_suggest_darts" not in buttons
    suggestions = suggested(addon, source, "SEAMS")
    cuts, chosen = suggestions.cuts, suggestions.cuts[suggestions.chosen]
    assert f"{len(cuts)} sets of seams. Chosen: {chosen.num_pieces} piece" in capfd.readouterr().out
    assert all(cut.is_first and cut.piece == 0 and len(cut.lengths) == 1 for cut in cuts)
    for few, more in pairwise(cuts):
        assert few.num_pieces <= more.num_pieces and few.strain > more.strain
    words = draw_panels(addon)
    assert f"Suggested Seams, {source.name}" in words and "→" not in words
    row = addon.solve.suggest.row_text("SEAMS", chosen, None, addon.blender.objects.length_text(bpy.context.scene))
    assert row in words and "stretch" not in row  # The stretch is in the sentence below the list.
    (drawn,) = (each for each in addon.overlay.shown.drawings(view_context()) if each.target == source)
    places = read(source.data.vertices, "co", np.float32, 3)[np.unique(chosen.edges)]
    proposed = {tuple(place) for place in drawn.failures.lines["proposed"].tolist()}
    assert {tuple(place) for place in places.tolist()} <= proposed
    assert bpy.ops.object.wirewarp_mend(what="SUGGESTION") == {"FINISHED"}
    assert pairs(seams_of(source)) == pairs(chosen.edges)
    pieces = addon.state.reports.last_report(source).pieces
    assert pieces and all(piece.ok for piece in pieces)
    assert needed(addon, source) <= chosen.strain * 1.05


def test_a_canceled_search_keeps_the_sets_found_by_then(addon):
    bpy.context.scene.wirewarp.dart_lines = "EDGES"  # faster than smooth lines
    run = addon.suggest.operators.begin_search(bpy.context, ball(), "SEAMS", None).steps
    cuts, shares = cancel_at(addon, run, 0.8 * 0.3)  # when the search for a second set begins
    assert cuts and all(cut.is_set and cut.width is not None for cut in cuts)
    assert shares == sorted(shares)


@pytest.mark.core
def test_sets_with_pieces_narrower_than_two_allowances_have_a_warning(addon):
    source = ball()
    settings = bpy.context.scene.wirewarp
    settings.dart_lines = "EDGES"  # smooth sets of a ball have no narrow pieces
    # This fabric stretches far enough for every set.
    settings.cloth, settings.gives_across, settings.gives_along = "SWIM", 100, 100
    cuts = suggested(addon, source, "SEAMS").cuts
    limit = (min(cut.width for cut in cuts) + max(cut.width for cut in cuts)) / 2
    assert not any(cut.is_narrow for cut in cuts) and "too narrow" not in draw_panels(addon)
    bpy.context.scene.unit_settings.scale_length = 0.02 / limit  # The limit becomes 20 mm, which is two allowances.
    suggestions = suggested(addon, source, "SEAMS")
    widths = [cut.width for cut in suggestions.cuts]
    is_narrow = [cut.is_narrow for cut in suggestions.cuts]
    assert is_narrow == [width < limit for width in widths] and 0 < sum(is_narrow) < len(is_narrow)
    assert len(widths) >= len(cuts) and not is_narrow[suggestions.chosen]
    assert "too narrow" not in draw_panels(addon)
    bpy.ops.object.wirewarp_choose_suggestion(index=is_narrow.index(True))
    assert "less than two allowances. It may be too narrow to sew." in draw_panels(addon)
    settings.allowance = 0.0
    assert not any(cut.is_narrow for cut in suggested(addon, source, "SEAMS").cuts)


def test_a_set_that_makes_too_many_pieces_of_the_model_has_a_warning(addon, monkeypatch):
    source = ball()
    join_cube(source)
    bpy.context.scene.wirewarp.dart_lines = "EDGES"
    flatten_fails("is closed")
    SUGGEST["SEAMS"]()
    count = found(addon, source).cuts[found(addon, source).chosen].num_pieces + 1  # plus the cube
    for most, has_warning in ((count, False), (count - 1, True)):
        monkeypatch.setattr(addon.suggest.panel, "MOST_SEWN", most)
        shown = draw_panels(addon)
        assert (f"With these seams, the model has {count} pieces, too many to sew." in shown) == has_warning


def test_seams_of_a_strained_piece_are_for_its_fabric(addon):
    source = grid("Bump", bump)
    bpy.context.scene.wirewarp.cloth = "MINKY"
    (piece,) = report_after(addon, source, cloth="MINKY").pieces
    assert not suggested(addon, source, "SEAMS").cuts[0].is_set
    assert found(addon, source).cuts[0].strain_before == pytest.approx(piece.needed, rel=1e-6)


@pytest.mark.core
def test_the_search_is_for_the_fabric(addon):
    """Woven cotton stretches 3%, and the sets for unknown fabrics need 5% or more."""
    source = ball()
    settings = bpy.context.scene.wirewarp
    assert min(cut.strain for cut in suggested(addon, source, "SEAMS", lines="EDGES").cuts) > 0.03
    settings.cloth = "WOVEN"
    suggestions = suggested(addon, source, "SEAMS")
    assert suggestions.cuts[suggestions.chosen].strain <= 0.03


def test_pieces_get_seams_even_if_their_fabric_stretches_far_enough(addon):
    source = grid("Bump", bump, size=6)
    settings = bpy.context.scene.wirewarp
    settings.cloth, settings.gives_across, settings.gives_along = "MINKY", 90, 19
    assert report_after(addon, source, cloth="MINKY", gives_across=0.9, gives_along=0.19).pieces[0].needed < 0.19
    assert SUGGEST["SEAMS"]() == {"FINISHED"}


@pytest.mark.parametrize("lines", ["SMOOTH", "EDGES"])
def test_a_cut_of_a_modified_mesh_applies_the_modifiers_when_it_is_marked(addon, lines):
    source = grid("Bump", bump, size=4)
    source.modifiers.new("Finer", "SUBSURF").levels = 1
    settings = bpy.context.scene.wirewarp
    settings.use_modifiers, settings.dart_lines = True, lines
    before = report_after(addon, source, use_modifiers=True).pieces[0].needed
    assert SUGGEST["DARTS"]() == {"FINISHED"}
    assert "applies the modifiers" in draw_panels(addon)
    cut = found(addon, source).cuts[0]
    depsgraph = bpy.context.evaluated_depsgraph_get()
    for target in (source, flat_of(source)):
        assert len(addon.overlay.failures.suggested_lines(target, depsgraph)) == 2 * len(cut.segments.polygons)
    assert bpy.ops.object.wirewarp_mend(what="SUGGESTION") == {"FINISHED"}
    assert not source.modifiers and not settings.use_modifiers
    if lines == "EDGES":
        assert pairs(seams_of(source)) == pairs(cut.edges)
    assert addon.state.reports.last_report(source).pieces[0].needed == pytest.approx(cut.strain, abs=1e-6)
    assert cut.strain < before


def test_a_refused_cut_applies_no_modifiers(addon, monkeypatch):
    source = grid("Bump", bump, size=4)
    source.modifiers.new("Finer", "SUBSURF").levels = 1
    settings = bpy.context.scene.wirewarp
    settings.use_modifiers = True
    SUGGEST["DARTS"]()

    def fail(*_):
        raise addon.core.FlattenError("invalid_option", "The line is refused.")

    monkeypatch.setattr(addon.solve.cut_faces, "cut_mesh", fail)
    fails(bpy.ops.object.wirewarp_mend, "The line is refused", what="SUGGESTION")
    assert len(source.modifiers) == 1 and settings.use_modifiers and len(source.data.vertices) == 25


def test_faces_split_apart_need_no_cut_and_modifiers_that_cannot_be_applied_are_named():
    source = grid("Bump", bump, size=6)
    source.modifiers.new("Apart", "EDGE_SPLIT").split_angle = 0
    bpy.context.scene.wirewarp.use_modifiers = True
    fails(SUGGEST["DARTS"], "The piece is flat enough")
    source.modifiers.clear()
    source.shape_key_add(name="Basis")
    source.modifiers.new("Finer", "SUBSURF").levels = 1
    fails(SUGGEST["DARTS"], "has shape keys, so modifiers cannot be applied")


def paint(source, data_type="BOOLEAN", domain="FACE"):
    attribute = source.data.attributes.new("wirewarp_no_seam", data_type, domain)
    attribute.data.foreach_set("value", np.ones(len(attribute.data), dtype=np.int32))
    notify(source)


def test_cuts_disappear_if_the_model_is_painted(addon):
    source = grid("Bump", bump, size=6)
    SUGGEST["DARTS"]()
    source.vertex_groups.new(name="Keep Whole").add([0], 1.0, "REPLACE")
    bpy.context.view_layer.update()
    assert found(addon, source)
    source.vertex_groups[0].name = "wirewarp_no_seam"
    bpy.context.view_layer.update()
    assert found(addon, source) is None
    fails(bpy.ops.object.wirewarp_mend, "There are no suggestions", what="SUGGESTION")
    source.vertex_groups.clear()  # because a vertex group and an attribute cannot have the same name
    source.update_tag()
    bpy.context.view_layer.update()
    assert suggested(addon, source, "DARTS")
    paint(source)
    assert found(addon, source) is None


def become_a_curve(source):
    bpy.data.objects.remove(source)
    new_object("Bump", bpy.data.curves.new("Bump", "CURVE"))


@pytest.mark.parametrize("change", [paint, become_a_curve])
def test_a_change_during_the_search_is_noticed(addon, change):
    source = grid("Bump", bump, size=6)
    search = addon.suggest.operators.begin_search(bpy.context, source, "DARTS", None)
    cuts = addon.solve.steps.in_one_go(search.steps)
    change(source)
    with pytest.raises(addon.issues.ObjectError, match='"Bump" changed during the search. Search again'):
        addon.suggest.operators.keep_found(search, cuts)


@pytest.mark.parametrize(("data_type", "domain"), [("BOOLEAN", "POINT"), ("INT", "EDGE"), ("FLOAT", "CORNER")])
def test_an_attribute_of_another_kind_is_refused(data_type, domain):
    source = grid("Bump", bump, size=6)
    paint(source, data_type, domain)
    fails(SUGGEST["DARTS"], '"wirewarp_no_seam" of mesh "Bump" is not of type BOOLEAN, INT8, INT or')


@pytest.mark.parametrize("kind", ["FACES", "GROUP"])
def test_no_cut_enters_a_painted_area(addon, kind):
    source = grid("Bump", bump, size=6, faces="triangles")
    cut = suggested(addon, source, "DARTS", lines="EDGES").cuts[0].edges
    assert cut
    mesh = source.data
    if kind == "FACES":
        attribute = mesh.attributes.new("wirewarp_no_seam", "BOOLEAN", "FACE")
        painted = [bool(set(face.vertices) & set(np.unique(cut).tolist())) for face in mesh.polygons]
        attribute.data.foreach_set("value", painted)
    else:
        source.vertex_groups.new(name="wirewarp_no_seam").add(np.unique(cut).tolist(), 1.0, "REPLACE")
    for other in suggested(addon, source, "DARTS").cuts:
        assert not pairs(cut) & pairs(other.edges)


@pytest.mark.parametrize("data_type", ["INT8", "INT", "FLOAT"])
def test_a_fully_painted_model_has_no_cuts(data_type):
    paint(grid("Bump", bump, size=6), data_type)
    fails(SUGGEST["DARTS"], 'no room for a dart.*Seams are also not allowed where "wirewarp_no_seam" is painted')


@pytest.fixture
def settings():
    """Return settings for at most two cuts and a stretch of 0, which two cuts do not reach."""
    wanted = bpy.context.scene.wirewarp
    wanted.suggest_together, wanted.aim_stretch, wanted.aim_cuts = True, 0.0, 2
    return wanted


@pytest.mark.parametrize("row", [0, 1])
def test_a_row_is_marked_with_all_earlier_rows_and_leaves_its_stretch(addon, settings, row):
    source = grid("Bump", bump, size=6, faces="triangles")
    before = needed(addon, source)
    first, second = suggested(addon, source, "DARTS").cuts
    assert found(addon, source).chosen == 1 and first.strain_before == pytest.approx(before, rel=1e-5)
    assert pairs(first.edges) < pairs(second.edges) and second.lengths[:1] == first.lengths
    assert first.strain_before == second.strain_before > first.strain > second.strain
    bpy.ops.object.wirewarp_choose_suggestion(index=row)
    chosen = (first, second)[row]
    ends = addon.overlay.failures.suggested_lines(source, bpy.context.evaluated_depsgraph_get())
    places = read(source.data.vertices, "co", np.float32, 3)[np.unique(chosen.edges)]
    assert {tuple(end) for end in ends.tolist()} == {tuple(place) for place in places.tolist()}
    assert bpy.ops.object.wirewarp_mend(what="SUGGESTION") == {"FINISHED"}
    assert pairs(seams_of(source)) == pairs(chosen.edges)
    assert needed(addon, source) == pytest.approx(chosen.strain, rel=1e-5)


def test_figures_of_the_model_are_those_of_its_worst_piece(addon, settings):
    source = flattened("Bump", bump, seam=on_line(0, 0.25))
    settings.aim_cuts = 1
    apart = []
    for piece in (0, 1):
        apart += suggested(addon, source, "DARTS", piece=piece).cuts
    (cut,) = suggested(addon, source, "DARTS").cuts
    assert cut.strain_before == pytest.approx(max(each.strain_before for each in apart), rel=1e-6)
    left = max(apart[cut.piece].strain, apart[1 - cut.piece].strain_before)
    assert cut.strain == pytest.approx(left, rel=1e-6)
    assert "Stretch with Darts, Bump 1 dart: " in draw_panels(addon)


def test_the_target_reaches_the_search_and_the_remaining_stretch_is_reported(addon, settings, capfd):
    """That plans keep to their targets is tested in tests/bindings."""
    source = grid("Bump", bump, size=6)
    first, second = suggested(addon, source, "DARTS").cuts
    assert "is left, more than your target of 0.0%. Allow more cuts." in draw_panels(addon)
    assert "your target of 0.0%. Allow more cuts." in capfd.readouterr().out
    settings.aim_length, settings.aim_cuts = 0.9 * first.lengths[0], 9
    assert sum(suggested(addon, source, "DARTS").cuts[-1].lengths) <= settings.aim_length
    assert "Allow more length, because another cut may help." in draw_panels(addon)
    settings.aim_length, settings.aim_cuts = 0.0, 2
    settings.aim_stretch = 100 * (first.strain + first.strain_before) / 2
    assert [cut.edges for cut in suggested(addon, source, "DARTS").cuts] == [first.edges]
    assert "more than your target" not in draw_panels(addon)
    settings.aim_stretch = 100.0
    fails(SUGGEST["DARTS"], r"is flat enough.* and 100% is accepted")


def test_steps_of_a_target_fit_a_row(addon, settings):
    source = ball()
    settings.aim_stretch = 30.0
    (cut,) = suggested(addon, source, "SEAMS").cuts
    assert f"Stretch with Seams, {source.name} First seams: " in draw_panels(addon)
    step, lengths = replace(cut, lengths=[*cut.lengths, 1.0]), addon.core.LengthText("mm", 1000)
    assert addon.solve.suggest.row_text("SEAMS", step, found(addon, source).target, lengths).startswith("and 1 seam: ")


def test_a_target_is_for_all_pieces_below_flatten_and_for_one_in_the_list(addon, settings):
    for together, place, piece in ((True, "FLATTEN", -1), (True, "PIECES", 3), (False, "FLATTEN", 3)):
        settings.suggest_together = together
        layout, buttons = MagicMock(), [MagicMock(), MagicMock()]
        layout.row.return_value = layout.column.return_value = layout
        layout.operator.side_effect = buttons
        addon.suggest.panel.draw_suggest(layout, settings, place, 3, has_seams=False)
        assert [(button.place, button.piece) for button in buttons] == 2 * [(place, piece)]
