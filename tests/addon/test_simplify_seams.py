# SPDX-License-Identifier: GPL-3.0-or-later
"""Simplify Seams suggests fewer seams. Its suggestions have the figures of a run, and are shown, used and refused."""

from itertools import pairwise

import bpy
import numpy as np
import pytest
from everything import draw_panels, drawn_buttons
from flattening import edge_lengths, edge_vertices, fails
from suggesting import SIMPLIFY, cancel_at, found, needed, pairs
from surfaces import bump, flat_of, grid, half_cylinder, join_cube, mark_seam, on_line, read, tube
from test_proposals import seams_of
from view_context import view_context


def strips(shape, rows=(-0.5, 0.0, 0.5), **settings):
    source = grid("Strips", shape, size=8, **settings)
    for row in rows:
        mark_seam(source, on_line(1, row))
    return source


def test_developable_strips_become_one_piece_again(addon, capfd):
    source = strips(half_cylinder, rows=(-0.5, 0.5))
    bpy.ops.object.wirewarp_flatten()
    buttons = drawn_buttons(addon)
    assert "object.wirewarp_simplify_seams" in buttons and "object.wirewarp_suggest_seams" not in buttons
    seams, settings = pairs(seams_of(source)), bpy.context.scene.wirewarp
    settings.aim_stretch = 37.5
    assert "37.5" not in draw_panels(addon)
    settings.suggest_together = True
    assert "True 37.5" in draw_panels(addon)  # the switch of the target and its value
    settings.suggest_together = False
    assert SIMPLIFY() == {"FINISHED"}
    (cut,) = found(addon, source).cuts
    assert pairs(cut.cleared) == seams and cut.num_pieces == 1
    marked = [(min(edge), max(edge)) in seams for edge in edge_vertices(source.data).tolist()]
    assert cut.lengths == pytest.approx([edge_lengths(source)[marked].sum()], rel=1e-6)
    assert "1 way to simplify. Chosen: 1 piece, stretch" in capfd.readouterr().out
    words = draw_panels(addon)
    assert "Fewer Seams, Strips 1 piece, 0.0%, −" in words
    assert cut.width == pytest.approx(2, rel=0.001) and not cut.is_narrow  # The piece is a rectangle of 2 by π.
    assert "length of cleared seams." in words and "Above" not in words and "Clear and Flatten" in words
    assert "Narrowest place of a piece: 2" in words
    places = read(source.data.vertices, "co", np.float32, 3)[np.unique(cut.cleared)]
    for target in (source, flat_of(source)):
        (drawn,) = (each for each in addon.overlay.shown.drawings(view_context()) if each.target == target)
        ends = {tuple(end) for end in drawn.failures.lines["proposed"].tolist()}
        assert len(ends) == (1 if target == source else 2) * len(places)  # on both sides of each seam of the pieces
    assert bpy.ops.object.wirewarp_mend(what="SUGGESTION") == {"FINISHED"}
    assert len(seams_of(source)) == 0 and len(addon.state.reports.last_report(source).pieces) == 1
    assert found(addon, source) is None


@pytest.mark.parametrize("is_mirrored", [False, True])
def test_a_wide_hem_leaves_room_if_it_has_no_neighbor(addon, is_mirrored):
    """The strips become a rectangle of 2 by π."""
    source = strips(half_cylinder, rows=(-0.5, 0.5))
    source.scale.x = -1 if is_mirrored else 1
    bpy.context.scene.wirewarp.allowance = 0.0
    places = read(source.data.vertices, "co", np.float32, 3)[edge_vertices(source.data)]

    def is_narrow(axis, end, width):
        rows = np.flatnonzero((abs(places[:, :, axis] - end) < 1e-6).all(axis=1))
        addon.state.allowances.mark_edges(source.data, rows, width)
        SIMPLIFY()
        (cut,) = found(addon, source).cuts
        assert cut.width == pytest.approx(2, rel=0.001)
        return cut.is_narrow

    assert not is_narrow(0, 1.0, 2.5)  # a hem along one short side
    assert not is_narrow(1, 1.0, 1.5)  # a hem along one long side
    # Hems along both long sides are too wide if their sum is above 2. Along both short sides, the limit is π.
    assert is_narrow(1, -1.0, 1.0) and not is_narrow(1, -1.0, 0.4)
    assert is_narrow(0, -1.0, 1.0)


def test_rows_go_from_few_pieces_to_little_stretch_with_the_figures_of_flattening(addon):
    source = strips(bump, rows=(-0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75), faces="triangles")
    before, seams = needed(addon, source), pairs(seams_of(source))
    SIMPLIFY()
    suggestions = found(addon, source)
    cuts = suggestions.cuts
    assert len(cuts) > 1 and "Above: fewer pieces. Below: less stretch." in draw_panels(addon)
    for few, more in pairwise(cuts):
        assert few.num_pieces <= more.num_pieces and few.strain > more.strain
        assert pairs(few.cleared) > pairs(more.cleared) and few.lengths[0] > more.lengths[0]
    assert all(cut.strain_before == pytest.approx(before, rel=1e-5) for cut in cuts)
    assert suggestions.chosen == 0 and cuts[0].strain <= 0.2  # Without a fabric, 20% is the limit.
    bpy.ops.object.wirewarp_choose_suggestion(index=1)
    bpy.ops.object.wirewarp_mend(what="SUGGESTION")
    assert pairs(seams_of(source)) == seams - pairs(cuts[1].cleared)
    assert len(addon.state.reports.last_report(source).pieces) == cuts[1].num_pieces
    assert needed(addon, source) == pytest.approx(cuts[1].strain, rel=1e-5)


def test_the_fabric_and_the_target_limit_the_stretch(addon):
    source = strips(bump, faces="triangles")
    settings = bpy.context.scene.wirewarp
    settings.cloth, settings.gives_across, settings.gives_along = "WOVEN", 1, 1
    SIMPLIFY()
    (cut,) = found(addon, source).cuts
    assert cut.num_pieces > 1 and cut.strain <= 0.01
    settings.suggest_together, settings.aim_stretch = True, 0.0
    fails(SIMPLIFY, "Every seam is needed for a stretch of 0.0% or less. Set a larger target")
    settings.aim_stretch = 60.0
    SIMPLIFY()
    (cut,) = found(addon, source).cuts
    assert cut.num_pieces == 1


def test_modifiers_are_applied_before_seams_on_their_edges_are_cleared(addon):
    source = strips(half_cylinder)
    source.modifiers.new("Finer", "SUBSURF").levels = 1
    settings = bpy.context.scene.wirewarp
    settings.use_modifiers = True
    SIMPLIFY()
    assert "applies the modifiers" in draw_panels(addon)
    (cut,) = (each for each in found(addon, source).cuts if each.num_pieces == 1)
    assert len(cut.cleared) == 3 * 16
    assert bpy.ops.object.wirewarp_mend(what="SUGGESTION") == {"FINISHED"}
    assert not source.modifiers and not settings.use_modifiers
    assert len(seams_of(source)) == 0 and len(source.data.vertices) == 17 * 17


def test_a_canceled_search_keeps_its_results(addon, monkeypatch):
    source = strips(bump, rows=(-0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75), faces="triangles")
    steps = addon.solve.steps

    def in_two(job):
        yield 0.5
        return job.result()

    monkeypatch.setattr(addon.solve.seam_sets, "result_of", in_two)

    def search(share):
        run = addon.suggest.operators.begin_search(bpy.context, source, "FEWER", None).steps
        return cancel_at(addon, run, share)

    whole, shares = search(0.8)  # before the widths are measured
    assert len(whole) > 1 and all(cut.width is None and not cut.is_narrow for cut in whole)
    assert shares == sorted(shares)
    some, _ = search(0.8 * 2.4 / 3)  # during the search for the last of three limits
    assert [cut.strain for cut in some] == [cut.strain for cut in whole if cut.strain <= 0.1]
    assert all(cut.width is not None for cut in some)
    with pytest.raises(steps.CanceledError):
        search(0.0)


def no_flat_piece():
    join_cube(strips(bump))


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: grid("Bump", bump), "has no seams to simplify. Mark seams, or press Suggest Seams."),
        (
            lambda: mark_seam(tube(), on_line(0, 0.5)),
            "Every seam is needed for a stretch of 20% or less. Choose a fabric that stretches more.",
        ),
        (no_flat_piece, "A piece has no flat shape. Flatten, and fix the failed pieces before"),
    ],
)
def test_the_reason_for_nothing_to_simplify_is_reported(make, said):
    make()
    fails(SIMPLIFY, said)
