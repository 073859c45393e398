# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts suggested towards a target: each row includes those before it, and its figures are those of Flatten."""

import bpy
import numpy as np
import pytest
from everything import draw_panels
from suggesting import SUGGEST, are_mirrored, found, needed, pairs
from surfaces import bump, grid, mark, mark_seam, on_line, read
from test_proposals import seams_of
from test_suggested_sets import ball
from test_suggestions import two_hills


@pytest.fixture
def settings():
    """Set two cuts and any remaining stretch."""
    wanted = bpy.context.scene.wirewarp
    wanted.suggest_together, wanted.aim_stretch, wanted.aim_cuts = True, 0.0, 2
    return wanted


@pytest.mark.parametrize("row", [0, 1])
def test_a_row_is_marked_with_all_before_it_and_leaves_what_it_says(addon, settings, row):
    source = grid("Bump", bump, size=6, faces="triangles")
    before = needed(addon, source)
    SUGGEST["DARTS"]()
    first, second = found(addon, source).cuts
    assert found(addon, source).chosen == 1 and first.strain_before == pytest.approx(before, rel=1e-5)
    assert pairs(first.edges) < pairs(second.edges)
    assert second.lengths[:1] == first.lengths
    assert first.strain_before == second.strain_before > first.strain > second.strain
    bpy.ops.object.wirewarp_choose_suggestion(index=row)
    chosen = (first, second)[row]
    ends = addon.overlay.failures.suggested_lines(source, bpy.context.evaluated_depsgraph_get())
    places = read(source.data.vertices, "co", np.float32, 3)[np.unique(chosen.edges)]
    assert {tuple(end) for end in ends.tolist()} == {tuple(place) for place in places.tolist()}
    assert bpy.ops.object.wirewarp_mend(what="SUGGESTION") == {"FINISHED"}
    assert pairs(seams_of(source)) == pairs(chosen.edges)
    assert needed(addon, source) == pytest.approx(chosen.strain, rel=1e-5)  # single precision


def test_seams_divide_the_piece_and_its_parts(addon, settings):
    source = grid("Bump", bump, size=6)
    bpy.ops.object.wirewarp_flatten()
    SUGGEST["SEAMS"](piece=0)
    words = draw_panels(addon)
    assert "Stretch with Seams, Bump 1 seam: " in words and " 2 seams: " in words
    assert bpy.ops.object.wirewarp_mend(what="SUGGESTION") == {"FINISHED"}
    pieces = addon.state.reports.last_report(source).pieces
    assert len(pieces) == 3 and all(piece.ok for piece in pieces)


def test_of_any_piece_the_figures_are_those_of_the_worst_one(addon, settings):
    source = grid("Bump", bump)
    mark_seam(source, on_line(0, 0.25))
    bpy.ops.object.wirewarp_flatten()
    settings.aim_cuts = 1
    apart = []
    for piece in (0, 1):
        SUGGEST["DARTS"](piece=piece)
        apart += found(addon, source).cuts
    SUGGEST["DARTS"]()
    (cut,) = found(addon, source).cuts
    assert cut.strain_before == pytest.approx(max(each.strain_before for each in apart), rel=1e-6)
    left = max(apart[cut.piece].strain, apart[1 - cut.piece].strain_before)
    assert cut.strain == pytest.approx(left, rel=1e-6)
    assert "Stretch with Darts, Bump 1 dart: " in draw_panels(addon)


def test_mirror_images_are_one_row(addon, settings):
    source = two_hills()
    mark(source, on_line(0, 0.0))  # no dart crosses it, so two hills need two darts
    SUGGEST["DARTS"]()
    (cut,) = found(addon, source).cuts
    assert len(cut.lengths) == 2
    assert are_mirrored(source, cut.edges)
    assert "2 darts: " in draw_panels(addon)


def test_the_target_reaches_the_search_and_what_is_missing_is_said(addon, settings, capfd):
    """How a plan keeps to its target is tested in tests/bindings."""
    source = grid("Bump", bump, size=6)
    SUGGEST["DARTS"]()
    first, second = found(addon, source).cuts
    assert "left, more than your target of 0.0%. Allow more cuts." in draw_panels(addon)
    assert "your target of 0.0%. Allow more cuts." in capfd.readouterr().out
    settings.aim_length, settings.aim_cuts = 0.9 * first.lengths[0], 9
    SUGGEST["DARTS"]()
    assert sum(found(addon, source).cuts[-1].lengths) <= settings.aim_length
    assert "Allow more length, if any other cut helps." in draw_panels(addon)
    settings.aim_length, settings.aim_cuts = 0.0, 2
    settings.aim_stretch = 100 * (first.strain + first.strain_before) / 2
    SUGGEST["DARTS"]()
    assert [cut.edges for cut in found(addon, source).cuts] == [first.edges]
    assert "more than your target" not in draw_panels(addon)
    settings.aim_stretch = 100.0
    with pytest.raises(RuntimeError, match=r"is flat enough.* and 100% is accepted"):
        SUGGEST["DARTS"]()


def test_first_cuts_meet_the_target(addon, settings):
    source = ball()
    settings.aim_stretch = 30.0
    SUGGEST["SEAMS"]()
    (cut,) = found(addon, source).cuts
    assert cut.is_first and cut.strain <= 0.3
    assert f"Stretch with Seams, {source.name} First seams: " in draw_panels(addon)
