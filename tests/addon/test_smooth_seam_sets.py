# SPDX-License-Identifier: GPL-3.0-or-later
"""Suggested seams can be smooth lines. The drawn lines are cut, have the shown figures, and change nothing else."""

import bpy
import numpy as np
import pytest
from everything import draw_panels
from suggesting import add_layers, bent_ring, check_layers, choose_smooth, found, places
from test_smooth_darts import are_alike, drawn_on, lengths
from test_smooth_lines import seam_places, surface


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
    """Paint a face that an earlier smooth cut crosses, and choose a smooth cut again. No cut may enter this face."""
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
    with pytest.raises(RuntimeError):
        bpy.ops.object.wirewarp_flatten()
    assert "SMOOTH" in draw_panels(addon)  # a closed model has the choice of smooth lines
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
