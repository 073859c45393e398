# SPDX-License-Identifier: GPL-3.0-or-later
"""A piece that breaks a promise does not look like a good one."""

import bpy
import numpy as np
import pytest
from surfaces import bump, flat_of, grid, mark, on_line, read, select_only


def spike(x, y):
    """So steep that a rigid cross on it makes WireWarping turn faces over."""
    return (x + 3, y, 2 * (1 - x * x) * (1 - y * y))


@pytest.fixture
def source():
    """A piece that can be flattened, and one that cannot."""
    target, other = grid("Both", bump), grid("Spike", spike)
    mark(other, on_line(0, 3.0), on_line(1, 0.0))
    select_only(target, other)
    bpy.ops.object.join()
    return target


def flatten_fails():
    with pytest.raises(RuntimeError, match="Both, Top Left: The piece is flipped"):
        bpy.ops.object.wirewarp_flatten(method="WIREWARPING")


def red_pieces(source):
    flat = flat_of(source).data
    slots = read(flat.polygons, "material_index", np.int32)
    red = [i for i, material in enumerate(flat.materials) if material and material.name == "WireWarp Failed Piece"]
    return set(read(flat.attributes["piece"].data, "value", np.int32)[np.isin(slots, red)])


def test_only_the_failed_piece_is_red(source, addon):
    flatten_fails()
    report = addon.state.reports.last_report(source)
    assert [piece.has_layout for piece in report.pieces] == [True, True]
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
    flatten_fails()
    flat = flat_of(source).data
    felt = bpy.data.materials.new("Felt")
    flat.materials[0] = felt
    flatten_fails()
    assert [material.name for material in flat.materials] == ["Felt", "WireWarp Failed Piece"]
    assert red_pieces(source) == {1}
