# SPDX-License-Identifier: GPL-3.0-or-later
"""What would make good pieces better: how cloth is strained, and where."""

import math

import bpy
import numpy as np
import pytest
from surfaces import bump, flatten, grid, half_cylinder, join_cube, mark, mark_seam, on_line


def flattened(addon, target, **settings):
    flatten(target, **settings)
    return addon.state.reports.last_report(target)


def two_bumps(x, y):
    """Flat but for two domes, the one on the right higher."""
    height = sum(h * math.exp(-((x - c) ** 2 + y * y) / 0.05) for c, h in ((-0.5, 0.22), (0.5, 0.32)))
    return (x, y, height)


def test_the_places_of_most_strain_are_named_largest_first(addon):
    target = grid("Two Bumps", two_bumps, size=32)
    report = flattened(addon, target)
    hints = [hint for hint in report.hints if hint.code == "strained"]
    assert 2 <= len(hints) <= 4
    centers = np.array([polygon.center for polygon in target.data.polygons])
    places = [centers[hint.faces].mean(axis=0) for hint in hints[:2]]
    assert np.hypot(places[0][0] - 0.5, places[0][1]) < 0.2
    assert hints[0].sentence.endswith("most here. Add a dart or seam.")
    assert "most" not in hints[1].sentence
    for hint in hints:
        assert 0 < len(hint.faces) < len(target.data.polygons) / 2


def test_places_that_read_alike_are_one_line(addon):
    """Two equal domes, each as strained as the other."""
    target = grid("Domes", lambda x, y: (x, y, 0.3 * math.exp(-((abs(x) - 0.5) ** 2 + y * y) / 0.05)), size=32)
    (hint,) = flattened(addon, target).hints
    assert hint.short.endswith("most, at 2 places")
    centers = np.array([polygon.center for polygon in target.data.polygons])[hint.faces]
    assert centers[:, 0].min() < -0.4 and centers[:, 0].max() > 0.4
    assert np.abs(centers[:, 0]).min() > 0.1


def test_the_worst_face_of_a_piece_is_in_its_first_hint(addon):
    """Though it is that of one small peak, beside places where a dart would do far more."""
    target = grid("Two Bumps", two_bumps, size=32)
    target.data.vertices[33 * 4 + 16].co.z = 0.07
    report = flattened(addon, target)
    (piece,) = report.pieces
    worst = piece.stretch_faces if piece.stretch_max >= piece.ease_max else piece.ease_faces
    assert set(worst) & set(report.hints[0].faces)


def test_where_all_of_a_piece_is_strained_the_worst_is_pointed_at(addon):
    target = grid("Dome", lambda x, y: (x, y, 2.5 * (1 - x * x) * (1 - y * y)), size=16)
    report = flattened(addon, target)
    assert report.pieces[0].area_3d > 2 * 4  # on a square of 4: more than the limit is missing nearly everywhere
    pointed_at = [face for hint in report.hints for face in hint.faces]
    assert 0 < len(pointed_at) < 0.5 * len(target.data.polygons)
    assert set(report.pieces[0].stretch_faces) & set(pointed_at)


def test_developable_pieces_need_no_advice(addon):
    report = flattened(addon, grid("Half Cylinder", half_cylinder))
    assert report.hints == []
    assert report.pieces[0].stretch_max == pytest.approx(0, abs=1e-6)
    assert report.pieces[0].ease_max == pytest.approx(0, abs=1e-6)


def test_wires_at_their_limit_are_advised_longest_change_first(addon):
    target = grid("Bump", bump)
    mark(target, on_line(1, 0.0), kind="ELASTIC", tolerance=0.001)
    mark(target, on_line(0, 0.5), kind="ELASTIC", tolerance=0.002)
    report = flattened(addon, target)
    wires = [hint for hint in report.hints if hint.code == "wire_at_limit"]
    assert [addon.core.hint_text(report, hint) for hint in wires] == ['"Wire 2" ±0.2%', '"Wire 1" ±0.1%']
    assert all(len(hint.edges) == 8 for hint in wires)


def test_what_failed_gets_no_advice(addon):
    source = grid("Bump", lambda x, y: (x, y, 1.5 * (1 - x * x) * (1 - y * y)))
    mark_seam(source, on_line(0, 0.0))
    join_cube(source)
    with pytest.raises(RuntimeError, match="is closed"):
        bpy.ops.object.wirewarp_flatten()
    report = addon.state.reports.last_report(source)
    failed = [piece.index for piece in report.pieces if not piece.ok]
    assert report.hints
    assert not {hint.piece for hint in report.hints} & set(failed)
    assert [report.pieces[index].stretch_max for index in failed] == [None]
