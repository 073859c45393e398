# SPDX-License-Identifier: GPL-3.0-or-later
"""One click gives a coarse model smooth outlines."""

import math

import bpy
import pytest
from surfaces import flat_of, select_only

pytestmark = pytest.mark.api


def disc(count):
    """A regular polygon, of quads around a smaller one: two corners of each on the rim."""
    angles = [2 * math.pi * k / count for k in range(count)]
    points = [(r * math.cos(a), r * math.sin(a), 0.0) for r in (0.5, 1.0) for a in angles]
    faces = [(k, count + k, count + (k + 1) % count, (k + 1) % count) for k in range(count)] + [tuple(range(count))]
    mesh = bpy.data.meshes.new("Disc")
    mesh.from_pydata(points, [], faces)
    source = bpy.data.objects.new("Disc", mesh)
    bpy.context.scene.collection.objects.link(source)
    select_only(source)
    return source


def hints(addon, source):
    return [hint for hint in addon.state.reports.last_report(source).hints if hint.code == "coarse"]


def test_a_modifier_smooths_the_outline_and_both_sides_of_a_seam(addon):
    source = disc(12)
    for edge in source.data.edges:
        edge.use_seam = all(vertex < 12 for vertex in edge.vertices)
    bpy.ops.object.wirewarp_flatten()
    (hint,) = hints(addon, source)
    assert len(hint.vertices) == 24 and "up to 30°" in hint.short
    faces = len(flat_of(source).data.polygons)
    bpy.ops.object.wirewarp_mend(what="SUBDIVIDE")
    assert hints(addon, source) == [] and bpy.context.scene.wirewarp.use_modifiers
    (modifier,) = source.modifiers
    assert (modifier.type, modifier.levels) == ("SUBSURF", 2) and len(flat_of(source).data.polygons) > 10 * faces
    report = addon.state.reports.last_report(source)
    (seam,) = report.seams
    assert report.with_modifiers and len(seam.length_2d) == 2
    assert seam.length_2d[0] == pytest.approx(seam.length_2d[1], rel=1e-6)
    bpy.ops.object.wirewarp_mend(what="SUBDIVIDE")
    assert modifier.levels == 3 and len(source.modifiers) == 1


def test_how_much_shorter_outlines_become_is_said_and_levels_have_an_end(addon, capfd):
    """Of 12 sides becomes the B-spline of their corners, nearly a circle of (4 + 2 cos 30°) / 6 of the radius."""
    source = disc(12)
    bpy.ops.object.wirewarp_flatten()
    for _ in range(6):
        bpy.ops.object.wirewarp_mend(what="SUBDIVIDE")
    said = capfd.readouterr().out
    circle, polygon = 2 * math.pi * (4 + 2 * math.cos(math.pi / 6)) / 6, 24 * math.sin(math.pi / 12)
    shorter = addon.core.percent_text(1 - circle / polygon)
    assert f"Subdivision makes the outlines {shorter} shorter." in said
    assert source.modifiers[0].levels == addon.state.read_model.MOST_LEVELS
