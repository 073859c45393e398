# SPDX-License-Identifier: GPL-3.0-or-later
"""The measures as attributes and colors, on the flat pieces and on the model: those of the library."""

import bpy
import numpy as np
import pytest
from surfaces import bump, edge_vertices, flat_of, grid, mark, mark_seam, on_line, read, uv_of

COLORS = ("arap_energy_color", "aspect_ratio_color", "length_variation_color")


@pytest.fixture
def source():
    """Of triangles, in two pieces, with a wire that changes its length."""
    target = grid("Bump", bump, faces="triangles")
    mark_seam(target, on_line(0, 0.0))
    mark(target, on_line(1, 0.0), kind="SUPER_ELASTIC")
    bpy.ops.object.wirewarp_flatten(maps_on_model=True)
    return target


def measured(addon, source):
    """The library's own measures of the UV map that was written."""
    mesh = source.data
    faces = read(mesh.loops, "vertex_index", np.int32).reshape(-1, 3)
    edges = edge_vertices(mesh)
    corner_uv = (uv_of(mesh).astype(np.float64) * mesh["wirewarp_uv_scale"]).reshape(-1, 3, 2)
    wire = [4 * 9 + k for k in range(9)]  # along y = 0
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


@pytest.mark.parametrize(("name", "measure"), [("arap_energy", "arap"), ("aspect_ratio", "aspect_ratio")])
def test_the_maps_of_faces_are_the_librarys_measures(source, addon, name, measure):
    expected = by_source_face(measured(addon, source).pieces, measure)
    flat = flat_of(source).data
    rounding = 1e-3 * np.ptp(expected)  # the UV map is of single precision
    of_flat = expected[read(flat.attributes["source_face"].data, "value", np.int32)]
    assert attribute(flat, name) == pytest.approx(of_flat, rel=0, abs=rounding)
    assert attribute(source.data, f"wirewarp_{name}") == pytest.approx(expected, rel=0, abs=rounding)


def test_the_map_of_edges_is_the_librarys_length_variation(source, addon):
    expected = {}
    for piece in measured(addon, source).pieces:
        pairs = np.sort(piece.metrics.wire_edges, axis=1).tolist()
        expected |= dict(zip(map(tuple, pairs), piece.metrics.edge_length_variation, strict=True))
    flat = flat_of(source).data
    sources = read(flat.attributes["source_vertex"].data, "value", np.int32)
    flat_pairs, pairs = np.sort(sources[edge_vertices(flat)], axis=1), np.sort(edge_vertices(source.data), axis=1)
    assert max(expected.values()) > 1e-3
    for mesh, name, own in ((flat, "", flat_pairs), (source.data, "wirewarp_", pairs)):
        values = dict(zip(map(tuple, own.tolist()), attribute(mesh, f"{name}length_variation"), strict=True))
        assert [values[pair] for pair in expected] == pytest.approx(list(expected.values()), abs=1e-5)


def test_faces_on_the_model_have_the_colors_of_their_flat_faces(source):
    flat = flat_of(source).data
    for name in COLORS:
        on_flat = read(flat.color_attributes[name].data, "color", np.float32, 4).reshape(-1, 3, 4)
        on_model = read(source.data.color_attributes[f"wirewarp_{name}"].data, "color", np.float32, 4)
        if name != "length_variation_color":  # at a seam vertex this is the mean of more edges
            sources = read(flat.attributes["source_face"].data, "value", np.int32)
            assert np.array_equal(on_flat[:, 0], on_model.reshape(-1, 3, 4)[sources, 0])
        assert np.ptp(on_model[:, :3], axis=0).max() > 0.01
    assert source.data.color_attributes.active_color.name == "wirewarp_aspect_ratio_color"


def test_maps_leave_the_model_with_the_option_and_the_users_colors_stay(source):
    mesh = source.data
    mesh.color_attributes.new("Paint", "BYTE_COLOR", "CORNER")
    mesh.color_attributes.active_color_index = mesh.color_attributes.find("Paint")
    bpy.ops.object.wirewarp_flatten(maps_on_model=True)
    assert len([name for name in mesh.attributes.keys() if "aspect_ratio" in name]) == 2  # noqa: SIM118
    assert mesh.color_attributes.active_color.name == "Paint"
    bpy.ops.object.wirewarp_flatten()
    left = [name for name in mesh.attributes.keys() if any(part in name for part in ("arap", "aspect", "length_v"))]  # noqa: SIM118
    assert left == []
    assert [each.name for each in mesh.color_attributes] == ["Paint"]
    assert mesh.color_attributes.active_color.name == "Paint"


def test_a_face_without_a_layout_has_no_color_of_the_scale(addon):
    source = grid("Sheet", bump)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.primitive_uv_sphere_add(segments=8, ring_count=4, location=(9, 0, 0))  # closed: no layout
    bpy.ops.object.mode_set(mode="OBJECT")
    with pytest.raises(RuntimeError, match="Sheet, Left: "):
        bpy.ops.object.wirewarp_flatten(maps_on_model=True)
    ratio = attribute(source.data, "wirewarp_aspect_ratio")
    assert (ratio[:64] >= 1).all()
    assert (ratio[64:] == 0).all()
    colors = read(source.data.color_attributes["wirewarp_aspect_ratio_color"].data, "color", np.float32, 4)
    assert np.unique(colors[4 * 64 :], axis=0) == pytest.approx(addon.solve.maps.NO_LAYOUT[None])
