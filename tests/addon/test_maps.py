# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat pieces have the library's measures as attributes, and the materials and UV maps of their model."""

import math

import bpy
import numpy as np
import pytest
from flattening import edge_vertices, flat_places, flat_sources, uv_of
from surfaces import bump, flat_of, grid, half_cylinder, mark, on_line, read
from two_sided import ease

pytestmark = pytest.mark.api


@pytest.fixture
def source():
    """Return a flattened model of two pieces of triangles, with a wire whose length changes."""
    target = grid("Bump", bump, faces="triangles", seam=on_line(0, 0.0))
    mark(target, on_line(1, 0.0), kind="SUPER_ELASTIC")
    bpy.ops.object.wirewarp_flatten()
    return target


def measured(addon, source):
    """Return the library's measures of the UV map."""
    mesh = source.data
    faces = read(mesh.loops, "vertex_index", np.int32).reshape(-1, 3)
    edges = edge_vertices(mesh)
    corner_uv = (uv_of(mesh).astype(np.float64) * mesh["wirewarp_uv_scale"]).reshape(-1, 3, 2)
    wire = [4 * 9 + k for k in range(9)]  # vertices of the wire along y = 0
    library = addon.core.library()
    return library.measure(
        read(mesh.vertices, "co", np.float32, 3).astype(np.float64),
        faces,
        corner_uv,
        seams=edges[read(mesh.edges, "use_seam", bool)],
        wires=[library.Wire(wire)],
    )


def by_source_face(pieces, name):
    values = {}
    for piece in pieces:
        values |= dict(zip(piece.source_face, getattr(piece.metrics, f"face_{name}"), strict=True))
    return np.array([values[face] for face in range(len(values))])


def attribute(mesh, name):
    return read(mesh.attributes[name].data, "value", np.float32)


def test_the_maps_are_the_librarys_measures(source, addon):
    flat, pieces = flat_of(source).data, measured(addon, source).pieces
    for name, measure in (("arap_energy", "arap"), ("aspect_ratio", "aspect_ratio")):
        expected = by_source_face(pieces, measure)
        of_flat = expected[read(flat.attributes["source_face"].data, "value", np.int32)]
        rounding = 1e-3 * np.ptp(expected)  # because the UV map has single precision
        assert attribute(flat, name) == pytest.approx(of_flat, rel=0, abs=rounding)
    expected = {}
    for piece in pieces:
        pairs = np.sort(piece.metrics.wire_edges, axis=1).tolist()
        expected |= dict(zip(map(tuple, pairs), piece.metrics.edge_length_variation, strict=True))
    pairs = np.sort(flat_sources(source)[edge_vertices(flat)], axis=1)
    assert max(expected.values()) > 1e-3
    values = dict(zip(map(tuple, pairs.tolist()), attribute(flat, "length_variation"), strict=True))
    assert [values[pair] for pair in expected] == pytest.approx(list(expected.values()), abs=1e-5)


def variations(source):
    """Return the relative length changes of the flat edges, and a mask of the edges on outlines."""
    flat = flat_of(source).data
    on_outline = np.bincount(read(flat.loops, "edge_index", np.int32)) == 1
    return attribute(flat, "length_variation"), on_outline


def test_thick_material_that_unfolds_changes_no_length(addon):
    """WireWarp flattens the surface in the middle of the thickness, and compares flat lengths with lengths on it."""
    bpy.context.scene.unit_settings.scale_length = 0.1
    target = grid("Half", half_cylinder, size=16)
    bpy.ops.object.wirewarp_flatten(thickness=20.0)
    values, _ = variations(target)
    assert values == pytest.approx(0, abs=1e-6)
    half_turn = math.pi / 32  # half of the angle that a face spans
    middle = 0.1  # half of the thickness, in Blender units
    # The vertices at both ends move along the normal of their only face, so the end faces are narrower than the others.
    width = 16 * 2 * math.sin(half_turn) * (1 + middle) - 2 * middle * math.sin(half_turn)
    assert np.ptp(flat_places(target), axis=0).max() == pytest.approx(width, rel=1e-3)
    report = addon.state.reports.last_report(target)
    assert report.hints == [] and addon.core.verdict(report).kind == "ready for any fabric"
    assert "Lengths on the model are measured in the middle" in report.notes[-1].text


def test_lines_with_their_target_length_have_no_change(addon):
    """Negative ease of the fabric changes the target lengths of all lines. An ease changes that of its line only."""
    target = grid("Half", half_cylinder, size=16, faces="triangles")
    bpy.ops.object.wirewarp_flatten(cloth="SWIM", worn_across=20.0, worn_along=20.0, orientation="UP")
    values, _ = variations(target)
    assert values == pytest.approx(0, abs=1e-5)
    ease(target, on_line(1, -1.0), sides="ONE", ease_percent=5.0)
    bpy.ops.object.wirewarp_flatten()
    values, on_outline = variations(target)
    assert values[on_outline] == pytest.approx(0, abs=1e-5) and values.max() > 0.01


def printed():
    """Return a model of two pieces of different materials, with a UV map projected from above."""
    source = grid("Bump", bump, seam=on_line(0, 0.0))
    for name in ("Stripes", "Dots"):
        source.data.materials.append(bpy.data.materials.new(name))
    for face in source.data.polygons:
        face.material_index = int(face.center.x > 0)
    layer = source.data.uv_layers.new(name="Print")
    for loop in source.data.loops:
        layer.data[loop.index].uv = source.data.vertices[loop.vertex_index].co[:2]
    return source


def assert_printed(source):
    flat = flat_of(source).data
    corners = read(flat.attributes["source_corner"].data, "value", np.int32)
    there = read(source.data.uv_layers["Print"].data, "uv", np.float32, 2)
    assert np.array_equal(read(flat.uv_layers["Print"].data, "uv", np.float32, 2), there[corners])
    faces = read(flat.attributes["source_face"].data, "value", np.int32)
    slots = read(source.data.polygons, "material_index", np.int32)
    assert np.array_equal(read(flat.polygons, "material_index", np.int32), slots[faces])


def test_pieces_have_the_materials_and_the_maps_of_their_model():
    source = printed()
    for _ in range(2):
        bpy.ops.object.wirewarp_flatten()
        flat = flat_of(source).data
        assert [material.name for material in flat.materials] == ["Stripes", "Dots"]
        assert [layer.name for layer in flat.uv_layers] == ["Print", "WireWarp"]
        assert flat.uv_layers.active.name == "Print"
        assert_printed(source)
    places = read(flat.vertices, "co", np.float32, 3)[read(flat.loops, "vertex_index", np.int32), :2]
    size = np.ptp(places, axis=0).max()
    uv = read(flat.uv_layers["WireWarp"].data, "uv", np.float32, 2)
    assert np.allclose(uv, (places - places.min(axis=0)) / size, atol=1e-6)
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    assert_printed(source)
