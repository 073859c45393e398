# SPDX-License-Identifier: GPL-3.0-or-later
"""Notches along seams are at one place of the model on all pieces that meet there, on round ones too."""

import dataclasses
import math

import bpy
import numpy as np
import pytest
from drawing import Drawing
from surfaces import bump, edge_vertices, flat_of, flatten, grid, make_object, mark, mark_seam, on_line, read

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
    apart = [np.linalg.norm(first - second) for first, second in found.values()]
    assert apart[0] == pytest.approx(apart[1], abs=0.1)
    assert RADIUS < apart[0] < 1.95 * RADIUS  # or the ring could be sewn in turned by half
    assert [len(points) for points in on_pieces(tmp_path, notch_spacing=0.0).values()] == [0, 0]


def test_seams_that_meet_on_a_smooth_outline_end_at_notches(disc, tmp_path):
    mark_seam(disc, lambda a, b: abs(a.y) + abs(b.y) < 1e-6 and min(a.length, b.length) > 0.5)
    bpy.ops.object.wirewarp_flatten()
    path = tmp_path / "pattern.svg"
    bpy.ops.object.wirewarp_export_svg(filepath=str(path), notch_spacing=1000.0)
    drawing = Drawing(path)
    counts = sorted(len(drawing.lines(piece, "Notches")) for piece in drawing.pieces)
    # The disc has two ends and two middles; each half of the ring has corners there, and middles of three seams.
    assert counts == [3, 3, 4]


def places_on_model(addon, source, spacing):
    """Of the notches along seams: (k,3) their places on the model, and the piece of each; a Blender unit is 100 mm."""
    choices = addon.solve.pattern_parts.PatternChoices(0.0, spacing, "cut")
    pattern = addon.solve.steps.in_one_go(addon.flat.pattern.read_pattern(bpy.context.scene, source).making(choices))
    flat = addon.flat.read.read_flat_pieces(flat_of(source).data, 100.0)
    flat = dataclasses.replace(flat, vertices=flat.vertices - flat.vertices.min(axis=0))
    outline = addon.pattern.outlines.outline_of(flat)
    model, found, pieces = read(source.data.vertices, "co", np.float32, 3), [], []
    for index, piece in enumerate(pattern.pieces):
        own = outline.edges[outline.piece == index]
        a, along = flat.vertices[own[:, 0]], flat.vertices[own[:, 1]] - flat.vertices[own[:, 0]]
        for notch in (point for point in piece.points if point.role == "notch"):
            share = np.clip(((notch.at - a) * along).sum(axis=1) / (along**2).sum(axis=1), 0, 1)
            distance = np.linalg.norm(a + share[:, None] * along - notch.at, axis=1)
            row = np.argmin(distance)
            assert distance[row] < 1e-3
            first, second = model[flat.source_vertex[own[row]]]
            found.append(first + share[row] * (second - first))
            pieces.append(index)
    return np.array(found).reshape(-1, 3), np.array(pieces)


def matched(addon, source, spacing):
    """The places on the model that have notches, each once, and in how many pieces; notches of the two sides of a dart
    count twice.
    """
    found, pieces = places_on_model(addon, source, spacing)
    groups = []
    for place, piece in zip(found, pieces, strict=True):
        group = next((group for group in groups if np.linalg.norm(group[0] - place) < 1e-3), None)
        if group is None:
            groups.append((place, [piece]))
        else:
            group[1].append(piece)
    return [(place, len(of)) for place, of in groups]


@pytest.mark.parametrize("settings", [{}, {"mirror": True}])
def test_both_sides_of_a_seam_and_of_a_dart_have_notches_at_the_same_places(addon, settings):
    bpy.context.scene.unit_settings.scale_length = 0.1
    source = grid("Bump", bump)
    mark_seam(source, on_line(0, 0.0))
    mark_seam(source, lambda a, b: on_line(1, 0.0)(a, b) and a.x + b.x > 0 and max(a.x, b.x) < 0.8)
    flatten(source, **settings)
    found = matched(addon, source, 30.0)
    assert len(found) >= 8
    for place, count in found:
        assert min(abs(place[0]), abs(place[1])) < 1e-3
        assert count == (1 if abs(place[0]) + abs(place[1]) < 1e-3 else 2)  # the other piece has a corner there


def test_a_notch_is_at_the_same_places_where_a_wire_runs_on_the_seam(addon):
    bpy.context.scene.unit_settings.scale_length = 0.1
    source = grid("Bump", bump)
    mark_seam(source, on_line(0, 0.0))
    flatten(source)
    before = places_on_model(addon, source, 30.0)[0]
    mark(source, on_line(0, 0.0))
    flatten(source)
    after = places_on_model(addon, source, 30.0)[0]
    assert len(after) == len(before) > 0
    assert np.abs(np.sort(after[:, 1]) - np.sort(before[:, 1])).max() < 1e-3


@pytest.mark.parametrize(("length", "count"), [(0.14, 0), (0.16, 1)])
def test_a_seam_shorter_than_the_spacing_has_a_notch_beside_its_middle_from_15_mm_on(addon, length, count):
    bpy.context.scene.unit_settings.scale_length = 0.1
    vertices = [(x, y, 0) for y in (0, length) for x in (-1, 0, 1)]
    source = make_object("Strap", vertices, [[0, 1, 4, 3], [1, 2, 5, 4]])
    mark_seam(source, on_line(0, 0.0))
    flatten(source)
    found = matched(addon, source, 100.0)
    assert [number for _, number in found] == [2] * count
    for place, _ in found:
        assert min(place[1], length - place[1]) == pytest.approx(0.4 * length, abs=1e-4)


def test_where_four_pieces_meet_the_one_that_is_straight_there_has_a_notch(addon):
    """One piece below; three with corners of 60 degrees above."""
    bpy.context.scene.unit_settings.scale_length = 0.1
    rim = [(math.cos(math.radians(60 * k)), math.sin(math.radians(60 * k)), 0) for k in range(6)]
    source = make_object("Hexagon", [(0, 0, 0), *rim], [[0, 1 + k, 1 + (k + 1) % 6] for k in range(6)])
    spokes = [set(pair) in ({0, 1}, {0, 2}, {0, 3}, {0, 4}) for pair in edge_vertices(source.data).tolist()]
    source.data.edges.foreach_set("use_seam", spokes)
    flatten(source)
    found, pieces = places_on_model(addon, source, 1000.0)
    at_center = np.linalg.norm(found, axis=1) < 1e-3
    assert len(pieces[at_center]) == 1
    assert [count for place, count in matched(addon, source, 1000.0) if np.linalg.norm(place) > 0.1] == [2] * 4
