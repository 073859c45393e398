# SPDX-License-Identifier: GPL-3.0-or-later
"""A hint reports curves that have corners because the model is coarse. It ignores corners that are on purpose."""

import numpy as np
import pytest
import wirewarp
from patterns import quads
from surfaces import grid
from wirewarp.report import COARSE, make_report


def disc(count, radius=0.1, **options):
    """Return a regular polygon of `count` triangles around its center. radius: meters."""
    angles = 2 * np.pi * np.arange(count) / count
    rim = radius * np.column_stack([np.cos(angles), np.sin(angles), np.zeros(count)])
    faces = np.array([(0, 1 + k, 1 + (k + 1) % count) for k in range(count)])
    return np.concatenate([np.zeros((1, 3)), rim]), faces, options


def hints(vertices, faces, options):
    result = wirewarp.flatten(vertices, faces, **options)
    return [hint for hint in make_report(result, vertices, faces).hints if hint.code == COARSE]


@pytest.mark.parametrize(("count", "turn"), [(8, 45), (12, 30), (20, 18)])
def test_a_circle_of_few_edges_is_named(count, turn):
    (hint,) = hints(*disc(count))
    assert hint.vertices == list(range(1, 1 + count)) and hint.short == f"{count} corners of up to {turn}°"
    assert hint.sentence.startswith("The model is coarse here") and hint.piece is None


@pytest.mark.parametrize("count", [4, 5, 25])  # a square, a pentagon, and a circle with turns of 14 degrees
def test_corners_and_round_outlines_are_not_named(count):
    assert hints(*disc(count)) == []


@pytest.mark.parametrize(("error", "is_named"), [(0.9e-3, False), (1.1e-3, True)])
def test_a_curve_is_coarse_if_scissors_miss_it_by_a_millimeter(error, is_named):
    """Edges of a circle with radius R span the angle a. Their middles are R (1 - cos(a / 2)) inside of the circle."""
    radius = error / (1 - np.cos(np.pi / 16))
    assert bool(hints(*disc(16, radius))) == is_named
    vertices, faces, _ = disc(16, 1000 * radius)
    result = wirewarp.flatten(vertices, faces)
    report = make_report(result, vertices, faces, meters=1e-3)
    assert any(hint.code == COARSE for hint in report.hints) == is_named


def test_a_single_bend_is_a_corner():
    points = [(0, 0), (100, 0), (200, 0), (0, 100), (100, 130), (200, 100)]
    result = quads(points, [(0, 1, 4, 3), (1, 2, 5, 4)])
    vertices = np.column_stack([np.array(points) / 1000, np.zeros(6)])
    assert make_report(result, vertices, [(0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4)]).hints == []


def test_both_sides_of_a_seam_name_its_vertices_once():
    vertices, faces, _ = disc(12)
    outer = 2 * vertices[1:]
    ring = [(1 + k, 13 + k, 13 + (k + 1) % 12) for k in range(12)]
    ring += [(1 + k, 13 + (k + 1) % 12, 1 + (k + 1) % 12) for k in range(12)]
    seams = [(1 + k, 1 + (k + 1) % 12) for k in range(12)]
    (hint,) = hints(np.concatenate([vertices, outer]), np.concatenate([faces, ring]), {"seams": seams})
    assert hint.vertices == list(range(1, 25))


def test_a_slit_of_one_edge_inside_a_piece_has_no_outline_of_its_own():
    vertices, faces = grid(4, 4, lambda u, v: (0.4 * u, 0.4 * v, 0))
    assert hints(vertices, faces, {"seams": [(11, 12)]}) == []
