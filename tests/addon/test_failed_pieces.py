# SPDX-License-Identifier: GPL-3.0-or-later
"""A piece that breaks a promise does not look like a good one."""

import bpy
import numpy as np
import pytest
from surfaces import bump, flat_of, grid, mark, on_line, read, select_only


def spike(x, y):
    """So steep that rigid lines across it turn faces over."""
    return (x + 3, y, 3 * (1 - x * x) * (1 - y * y))


@pytest.fixture
def source():
    """A piece that can be flattened, and one with so many rigid lines that it cannot."""
    target, other = grid("Both", bump), grid("Spike", spike)
    lines = [on_line(0, 3 + k / 4) for k in range(-3, 4)] + [on_line(1, k / 4) for k in range(-3, 4)]
    mark(other, *lines)
    select_only(target, other)
    bpy.ops.object.join()
    return target


def red_pieces(source):
    flat = flat_of(source).data
    slots = read(flat.polygons, "material_index", np.int32)
    red = [i for i, material in enumerate(flat.materials) if material and material.name == "WireWarp Failed Piece"]
    return set(read(flat.attributes["piece"].data, "value", np.int32)[np.isin(slots, red)])


def test_only_the_failed_piece_is_red(source, addon):
    with pytest.raises(RuntimeError, match="Both, piece 2: The piece "):
        bpy.ops.object.wirewarp_flatten()
    report = addon.report_store.last_report(source)
    assert [piece["has_layout"] for piece in report["pieces"]] == [True, True]
    assert red_pieces(source) == {1}
    flat = flat_of(source).data
    assert len(flat.materials) == 2

    mesh = source.data
    mesh.attributes.remove(mesh.attributes["wirewarp_wire"])
    spike_vertices = slice(81, None)
    places = read(mesh.vertices, "co", np.float32, 3)
    places[spike_vertices, 2] *= 0.05
    mesh.vertices.foreach_set("co", places.ravel())
    bpy.ops.object.wirewarp_flatten()
    assert red_pieces(source) == set()
    assert "WireWarp Failed Piece" not in flat.materials


def test_materials_of_the_user_stay(source):
    with pytest.raises(RuntimeError, match="Both, piece 2"):
        bpy.ops.object.wirewarp_flatten()
    flat = flat_of(source).data
    felt = bpy.data.materials.new("Felt")
    flat.materials[0] = felt
    with pytest.raises(RuntimeError, match="Both, piece 2"):
        bpy.ops.object.wirewarp_flatten()
    assert [material.name for material in flat.materials] == ["Felt", "WireWarp Failed Piece"]
    assert red_pieces(source) == {1}
