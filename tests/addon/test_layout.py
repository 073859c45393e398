# SPDX-License-Identifier: GPL-3.0-or-later
"""The placement of pieces: packed or in a row, and which direction is up."""

import bpy
import numpy as np
import pytest
from surfaces import (
    bump,
    edge_vertices,
    flat_of,
    flat_places,
    flat_sources,
    flatten,
    grid,
    half_cylinder,
    mark,
    mark_seam,
    on_line,
    read,
    select_edges,
)


def difference(source, a, b):
    """Return the vector on the flat piece between two vertices of the model."""
    sources = flat_sources(source).tolist()
    return flat_places(source)[sources.index(b)] - flat_places(source)[sources.index(a)]


def direction_of(source, a, b):
    along = difference(source, a, b)
    return along / np.linalg.norm(along)


def test_one_row_stands_on_a_line():
    source = grid("Bump", bump)
    for line in (-0.5, 0.0, 0.5):
        mark_seam(source, on_line(0, line))
    flatten(source, layout_kind="ROW")
    flat = flat_of(source).data
    places, pieces = flat_places(source), read(flat.attributes["piece"].data, "value", np.int32)
    boxes = []
    for piece in range(4):
        own = places[[v for face in np.flatnonzero(pieces == piece) for v in flat.polygons[face].vertices]]
        boxes.append((own.min(axis=0), own.max(axis=0)))
    assert [box[0][1] for box in boxes] == pytest.approx([0] * 4, abs=1e-6)
    assert all(left[1][0] < right[0][0] for left, right in zip(boxes[:-1], boxes[1:], strict=True))
    flatten(source)  # another layout moves them, whatever Keep Places is
    assert np.ptp(flat_places(source)[:, 0]) < 1.6 * np.ptp(flat_places(source)[:, 1])


def two_wires():
    """Return wires across a half cylinder: along x at y = 0.5, the wire in front, and along y at x = 0."""
    source = grid("Half Cylinder", half_cylinder)
    mark(source, on_line(1, 0.5))
    mark(source, on_line(0, 0.0))
    return source


ALONG_X, ALONG_Y = (54, 62), (4, 76)  # ends of the wires: 9 vertices in a row


def edge_of_wire(source, ends):
    """Return the first edge from that end."""
    ids = read(source.data.attributes["wirewarp_wire"].data, "value", np.int32)
    return next(
        row for row, pair in enumerate(edge_vertices(source.data).tolist()) if ends[0] in pair and ids[row] != 0
    )


@pytest.mark.parametrize("ends", [ALONG_X, ALONG_Y])
def test_the_grain_wire_stands_upright(ends):
    source = two_wires()
    bpy.ops.mesh.wirewarp_grain_wire(edge=edge_of_wire(source, ends))
    flatten(source)
    assert abs(direction_of(source, *ends)[1]) == pytest.approx(1, abs=1e-4)


def test_a_chosen_grain_wire_moves_pieces_that_were_laid_out_otherwise_and_can_be_taken_back():
    source = two_wires()
    flatten(source)
    before = direction_of(source, *ALONG_X)
    upright, other = (ALONG_X, ALONG_Y) if abs(before[1]) > 0.9 else (ALONG_Y, ALONG_X)
    edge = edge_of_wire(source, other)
    bpy.ops.mesh.wirewarp_grain_wire(edge=edge)
    flatten(source)
    assert abs(direction_of(source, *other)[1]) == pytest.approx(1, abs=1e-4)
    bpy.ops.mesh.wirewarp_grain_wire(edge=edge)
    assert source.data.wirewarp_grain == 0
    flatten(source)
    assert abs(direction_of(source, *upright)[1]) == pytest.approx(1, abs=1e-4)


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_of_a_wire_and_its_copy_the_one_chosen_is_the_grain_wire(mode):
    source = two_wires()
    select_edges(source, lambda *_: True)
    bpy.ops.mesh.duplicate_move(TRANSFORM_OT_translate={"value": (0, 5, 0)})
    bpy.ops.object.mode_set(mode="OBJECT")
    original, copy = edge_of_wire(source, ALONG_X), edge_of_wire(source, [81 + vertex for vertex in ALONG_X])
    bpy.ops.object.mode_set(mode=mode)
    bpy.ops.mesh.wirewarp_grain_wire(edge=copy)
    assert source.mode == mode
    bpy.ops.object.mode_set(mode="OBJECT")
    ids = read(source.data.attributes["wirewarp_wire"].data, "value", np.int32)
    assert ids[original] != ids[copy]
    assert source.data.wirewarp_grain == ids[copy]


def test_a_grain_wire_that_is_gone_counts_as_none():
    source = two_wires()
    source.data.wirewarp_grain = 12345
    flatten(source)
    assert max(abs(direction_of(source, *ends)[1]) for ends in (ALONG_X, ALONG_Y)) == pytest.approx(1, abs=1e-4)


def test_while_no_wire_is_the_grain_wire_pieces_stand_as_on_the_model():
    source = two_wires()
    source.rotation_euler = (np.pi / 2, 0, 0)  # its y is up
    flatten(source)
    assert direction_of(source, *ALONG_Y)[1] == pytest.approx(1, abs=1e-4)
    source.rotation_euler = (np.pi / 2, np.pi / 2, 0)  # its x is down, although it is equally a wire
    flatten(source, keep_places=False)
    assert direction_of(source, *ALONG_X)[1] == pytest.approx(-1, abs=1e-4)


def test_world_up_and_the_longest_straight_edge():
    source = grid("Half Cylinder", lambda x, y: half_cylinder(x, 1.2 * y))
    source.rotation_euler = (0, np.pi / 2, 0)  # on its side: x of the mesh is down
    mark(source, on_line(1, 0.0))
    flatten(source, orientation="UP")
    assert direction_of(source, 36, 37) == pytest.approx([0, -1], abs=1e-4)
    flatten(source, orientation="BOUNDARY")
    longest = max(((0, 8), (0, 72)), key=lambda ends: np.linalg.norm(difference(source, *ends)))
    assert abs(direction_of(source, *longest)[1]) == pytest.approx(1, abs=1e-4)


def test_a_wire_that_is_not_there_cannot_be_chosen():
    source = two_wires()
    with pytest.raises(RuntimeError):
        bpy.ops.mesh.wirewarp_grain_wire(edge=0)
    assert source.data.wirewarp_grain == 0
