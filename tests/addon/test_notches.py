# SPDX-License-Identifier: GPL-3.0-or-later
"""Notches of round pieces, which have no corners to be matched by."""

import math

import bpy
import numpy as np
import pytest
from drawing import Drawing
from surfaces import make_object, mark_seam

CORNERS, RADIUS = 24, 100.0  # millimeters


@pytest.fixture
def disc():
    """A disc in a ring, cut apart along the circle between; a Blender unit is 100 mm."""
    bpy.context.scene.unit_settings.scale_length = 0.1
    circle = [(math.cos(2 * math.pi * k / CORNERS), math.sin(2 * math.pi * k / CORNERS)) for k in range(CORNERS)]
    vertices = [(0, 0, 0), *((r * x, r * y, 0) for r in (1, 2) for x, y in circle)]
    inner = [[0, 1 + k, 1 + (k + 1) % CORNERS] for k in range(CORNERS)]
    outer = [[1 + k, 1 + CORNERS + k, 1 + CORNERS + (k + 1) % CORNERS, 1 + (k + 1) % CORNERS] for k in range(CORNERS)]
    target = make_object("Disc", vertices, inner + outer)
    mark_seam(target, lambda a, b: abs(a.length - 1) < 1e-6 and abs(b.length - 1) < 1e-6)
    return target


def on_pieces(tmp_path, **settings):
    """By piece, the points of its notches that lie on the circle, from the middle of that."""
    bpy.ops.object.wirewarp_flatten()
    path = tmp_path / "pattern.svg"
    assert bpy.ops.object.wirewarp_export_svg(filepath=str(path), **settings) == {"FINISHED"}
    drawing, found = Drawing(path), {}
    for piece in drawing.pieces:
        middle = drawing.lines(piece, "Cut")[0][:-1].mean(axis=0)  # of any of its circles
        points = np.array([notch[0] for notch in drawing.lines(piece, "Notches")]).reshape(-1, 2) - middle
        found[piece] = points[np.abs(np.linalg.norm(points, axis=1) - RADIUS) < 1.5]
    return found


def test_a_seam_all_around_begins_at_a_notch_and_has_one_more(disc, tmp_path):
    found = on_pieces(tmp_path, notch_spacing=1000.0)
    assert [len(points) for points in found.values()] == [2, 2]
    for first, second in found.values():
        assert np.linalg.norm(first - second) == pytest.approx(2 * RADIUS, rel=1e-3)
    assert [len(points) for points in on_pieces(tmp_path, notch_spacing=0.0).values()] == [0, 0]


def test_seams_that_meet_on_a_smooth_outline_end_at_notches(disc, tmp_path):
    mark_seam(disc, lambda a, b: abs(a.y) + abs(b.y) < 1e-6 and min(a.length, b.length) > 0.5)
    bpy.ops.object.wirewarp_flatten()
    path = tmp_path / "pattern.svg"
    bpy.ops.object.wirewarp_export_svg(filepath=str(path), notch_spacing=1000.0)
    drawing = Drawing(path)
    counts = sorted(len(drawing.lines(piece, "Notches")) for piece in drawing.pieces)
    # The disc has two ends and two middles; each half of the ring the same ends, and the middles of three seams.
    assert counts == [4, 5, 5]
