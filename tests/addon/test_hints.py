# SPDX-License-Identifier: GPL-3.0-or-later
"""Hints suggest how to improve good pieces: darts where fabric is strained, finer outlines, and joined edges."""

import math

import bpy
import numpy as np
import pytest
from flattening import edited, flatten, flatten_fails, flattened
from surfaces import bump, flat_of, grid, make_object, on_edges, on_line


def hints(addon, source, code):
    return [hint for hint in addon.state.reports.last_report(source).hints if hint.code == code]


def test_places_with_equal_strain_are_one_hint(addon):
    target = flattened("Domes", lambda x, y: (x, y, 0.3 * math.exp(-((abs(x) - 0.5) ** 2 + y * y) / 0.05)), size=32)
    (hint,) = addon.state.reports.last_report(target).hints
    assert hint.short.endswith("most, at 2 places")
    across = np.array([polygon.center.x for polygon in target.data.polygons])[hint.faces]
    assert across.min() < -0.4 and across.max() > 0.4 and np.abs(across).min() > 0.1


def disc(count):
    """Return a regular polygon of `count` corners, surrounded by a ring of quads with two corners each on the rim."""
    angles = [2 * math.pi * k / count for k in range(count)]
    points = [(r * math.cos(a), r * math.sin(a), 0.0) for r in (0.5, 1.0) for a in angles]
    faces = [(k, count + k, count + (k + 1) % count, (k + 1) % count) for k in range(count)] + [tuple(range(count))]
    return make_object("Disc", points, faces)


@pytest.mark.api
def test_a_modifier_smooths_the_outline_and_both_sides_of_a_seam(addon):
    source = disc(12)
    for edge in source.data.edges:
        edge.use_seam = all(vertex < 12 for vertex in edge.vertices)
    bpy.ops.object.wirewarp_flatten()
    (hint,) = hints(addon, source, "coarse")
    assert len(hint.vertices) == 24 and "up to 30°" in hint.short
    faces = len(flat_of(source).data.polygons)
    bpy.ops.object.wirewarp_mend(what="SUBDIVIDE")
    assert hints(addon, source, "coarse") == [] and bpy.context.scene.wirewarp.use_modifiers
    (modifier,) = source.modifiers
    assert (modifier.type, modifier.levels) == ("SUBSURF", 2) and len(flat_of(source).data.polygons) > 10 * faces
    report = addon.state.reports.last_report(source)
    (seam,) = report.seams
    assert report.with_modifiers and seam.length_2d == pytest.approx([seam.length_2d[0]] * 2, rel=1e-6)


@pytest.mark.api
def test_the_shortening_of_outlines_is_reported_and_levels_are_limited(addon, capfd):
    """Subdivision replaces the twelve sides by the B-spline of their corners. This B-spline is almost a circle, and its
    radius is (4 + 2 cos 30°) / 6 times the radius of the corners.
    """
    source = disc(12)
    bpy.ops.object.wirewarp_flatten()
    for _ in range(6):
        bpy.ops.object.wirewarp_mend(what="SUBDIVIDE")
    said = capfd.readouterr().out
    circle, polygon = 2 * math.pi * (4 + 2 * math.cos(math.pi / 6)) / 6, 24 * math.sin(math.pi / 12)
    shorter = addon.core.percent_text(1 - circle / polygon)
    assert f"Subdivision makes the outlines {shorter} shorter." in said
    (modifier,) = source.modifiers
    assert modifier.levels == addon.state.read_model.MOST_LEVELS


@pytest.mark.parametrize(
    ("line", "count"),
    [
        (on_line(0, 0.0), 16),  # a gap that divides the model
        (lambda a, b: on_line(0, 0.0)(a, b) and max(a.y, b.y) < 0.1, 8),  # a slit of four edges
    ],
)
def test_overlapping_edges_are_reported_until_they_are_merged(addon, line, count):
    source = grid("Bump", bump)
    on_edges(source, bpy.ops.mesh.edge_split, line)
    flatten(source)
    (hint,) = hints(addon, source, "torn")
    report = addon.state.reports.last_report(source)
    assert hint.short == f"{count} edges" and report.notes == []  # The gap may be intended, so it is only a hint.
    bpy.ops.mesh.wirewarp_select_result(what="HINT", index=report.hints.index(hint))
    bpy.ops.object.mode_set(mode="OBJECT")
    chosen = [[source.data.vertices[end].co for end in edge.vertices] for edge in source.data.edges if edge.select]
    assert len(chosen) == count and all(line(*ends) for ends in chosen)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.remove_doubles()
    bpy.ops.object.mode_set(mode="OBJECT")
    flatten(source)
    assert hints(addon, source, "torn") == []


def test_separate_panels_are_not_tears(addon):
    source = grid("Bump", bump)
    on_edges(source, bpy.ops.mesh.edge_split, on_line(0, 0.0))
    with edited(source.data) as edit:
        for vertex in {vertex for face in edit.faces if face.calc_center_median().x > 0 for vertex in face.verts}:
            vertex.co.x += 1e-3
    flatten(source)
    assert hints(addon, source, "torn") == []


def test_the_error_of_a_failed_piece_names_its_tears():
    source = grid("Bump", bump)
    on_edges(source, bpy.ops.mesh.edge_split, on_line(0, 0.0))
    source.data.polygons[0].flip()
    flatten_fails("point to opposite sides(.|\\n)*Some edges overlap but are not joined")
