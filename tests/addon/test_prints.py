# SPDX-License-Identifier: GPL-3.0-or-later
"""A print or a stripe is checked on the flat pieces: they have the model's materials and UV maps."""

import bpy
import numpy as np
from surfaces import bump, flat_of, grid, mark_seam, on_line, read

SEAM = on_line(0, 0.0)


def printed():
    """Two pieces, each of another material, with a map of their own from above."""
    source = grid("Bump", bump)
    mark_seam(source, SEAM)
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
    for _ in range(2):  # a second run leaves no second ones
        bpy.ops.object.wirewarp_flatten()
        flat = flat_of(source).data
        assert [material.name for material in flat.materials] == ["Stripes", "Dots"]
        assert [layer.name for layer in flat.uv_layers] == ["Print", "WireWarp"]
        assert flat.uv_layers.active.name == "Print"
        assert_printed(source)
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    assert_printed(source)


def test_the_map_of_the_pieces_is_their_own_shape():
    source = printed()
    bpy.ops.object.wirewarp_flatten()
    flat = flat_of(source).data
    places = read(flat.vertices, "co", np.float32, 3)[read(flat.loops, "vertex_index", np.int32), :2]
    size = np.ptp(places, axis=0).max()
    uv = read(flat.uv_layers["WireWarp"].data, "uv", np.float32, 2)
    assert np.allclose(uv, (places - places.min(axis=0)) / size, atol=1e-6)
