# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces are packed or placed in a row, apart from each other and from models, with the correct direction upward."""

import bpy
import numpy as np
import pytest
from flattening import edge_vertices, flat_places, flat_sources, flatten, flattened, world_box
from surfaces import bump, flat_of, grid, half_cylinder, mark, mark_seam, on_edges, on_line, read, select_only
from two_sided import select_side


def direction_of(source, a, b):
    """Return the unit vector on the flat piece between two vertices of the model."""
    sources = flat_sources(source).tolist()
    along = flat_places(source)[sources.index(b)] - flat_places(source)[sources.index(a)]
    return along / np.linalg.norm(along)


def boxes_of(source):
    """Return the lowest and the highest corner of each piece."""
    flat, places = flat_of(source).data, flat_places(source)
    pieces = read(flat.attributes["piece"].data, "value", np.int32)
    own = [
        places[[vertex for face in np.flatnonzero(pieces == piece) for vertex in flat.polygons[face].vertices]]
        for piece in range(pieces.max() + 1)
    ]
    return [(each.min(axis=0), each.max(axis=0)) for each in own]


def test_one_row_is_on_a_line():
    source = grid("Bump", bump)
    for line in (-0.5, 0.0, 0.5):
        mark_seam(source, on_line(0, line))
    flatten(source, layout_kind="ROW")
    boxes = boxes_of(source)
    assert len(boxes) == 4 and [box[0][1] for box in boxes] == pytest.approx([0] * 4, abs=1e-6)
    assert all(left[1][0] < right[0][0] for left, right in zip(boxes[:-1], boxes[1:], strict=True))
    flatten(source)  # With another layout, pieces move, even with Keep Places.
    assert np.ptp(flat_places(source)[:, 0]) < 1.6 * np.ptp(flat_places(source)[:, 1])


def two_wires(rotation=(0, 0, 0)):
    """Return a half cylinder with two wires: one along x at y = 0.5, and one along y at x = 0."""
    source = grid("Half Cylinder", half_cylinder, wire=on_line(1, 0.5))
    mark(source, on_line(0, 0.0))
    source.rotation_euler = rotation
    return source


UPRIGHT = (np.pi / 2, 0, 0)  # With this rotation, the model's y axis points up.


ALONG_X, ALONG_Y = (54, 62), (4, 76)  # end vertices of the wires; each row of the grid has 9 vertices


def edge_of_wire(source, ends):
    """Return the index of the wire's edge that ends at the first vertex of `ends`."""
    ids = read(source.data.attributes["wirewarp_wire"].data, "value", np.int32)
    return next(
        row for row, pair in enumerate(edge_vertices(source.data).tolist()) if ends[0] in pair and ids[row] != 0
    )


def test_a_chosen_grain_wire_turns_pieces_and_can_be_undone():
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
    bpy.ops.mesh.wirewarp_grain_wire(edge=edge_of_wire(source, upright))
    flatten(source)
    assert abs(direction_of(source, *upright)[1]) == pytest.approx(1, abs=1e-4)


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_either_a_wire_or_its_copy_can_be_the_grain_wire(mode):
    source = two_wires()
    on_edges(source, bpy.ops.mesh.duplicate_move, lambda *_: True, TRANSFORM_OT_translate={"value": (0, 5, 0)})
    original, copy = edge_of_wire(source, ALONG_X), edge_of_wire(source, [81 + vertex for vertex in ALONG_X])
    bpy.ops.object.mode_set(mode=mode)
    bpy.ops.mesh.wirewarp_grain_wire(edge=copy)
    assert source.mode == mode
    bpy.ops.object.mode_set(mode="OBJECT")
    ids = read(source.data.attributes["wirewarp_wire"].data, "value", np.int32)
    assert ids[original] != ids[copy] and source.data.wirewarp_grain == ids[copy]


def test_pieces_without_the_grain_wire_are_upright_as_on_the_model():
    """For example, a grain wire on the front must not rotate the back."""
    source = two_wires(UPRIGHT)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.duplicate_move(TRANSFORM_OT_translate={"value": (0, 5, 0)})
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.mesh.wirewarp_grain_wire(edge=edge_of_wire(source, ALONG_X))
    flatten(source)
    assert abs(direction_of(source, *ALONG_X)[1]) == pytest.approx(1, abs=1e-4)
    low, high = (81 + vertex for vertex in ALONG_Y)
    assert direction_of(source, low, high)[1] == pytest.approx(1, abs=1e-4)


def test_a_missing_grain_wire_has_no_effect():
    source = two_wires()
    with pytest.raises(RuntimeError):
        bpy.ops.mesh.wirewarp_grain_wire(edge=0)
    assert source.data.wirewarp_grain == 0
    source.data.wirewarp_grain = 12345
    flatten(source)
    assert max(abs(direction_of(source, *ends)[1]) for ends in (ALONG_X, ALONG_Y)) == pytest.approx(1, abs=1e-4)


def test_without_a_grain_wire_pieces_are_upright_as_on_the_model():
    source = two_wires(UPRIGHT)
    flatten(source)
    assert direction_of(source, *ALONG_Y)[1] == pytest.approx(1, abs=1e-4)
    source.rotation_euler = (np.pi / 2, np.pi / 2, 0)  # Now, the x axis points down.
    flatten(source, keep_places=False)
    assert direction_of(source, *ALONG_X)[1] == pytest.approx(-1, abs=1e-4)


def test_pieces_of_models_flattened_together_are_at_one_height_and_not_under_a_model():
    """A third model hovers above the place where the pieces of the first model would be."""
    models = [grid(name, bump) for name in ("Left", "Tall", "Hovering")]
    for model, place in zip(models, [(0, 0, 0), (7, 0, -1), (3.5, 0, 4)], strict=True):
        model.location = place
    models[1].scale = (1, 1, 3)
    select_only(*models)
    bpy.ops.object.wirewarp_flatten()
    flats = [flat_of(model) for model in models]
    assert len({round(flat.location.z, 5) for flat in flats}) == 1
    boxes = [world_box(each) for each in (*models, *flats)]
    for flat in boxes[3:]:
        assert not any(np.all((flat[0] < other[1]) & (other[0] < flat[1])) for other in boxes if other is not flat)


def gap_of_two(size, meters, mark_widths=lambda _: None):
    """Return the distance of two pieces in meters, for a gap of 50 mm. mark_widths: marks allowances on the model."""
    bpy.context.scene.unit_settings.scale_length = meters
    source = grid("Plane", lambda x, y: (size * x, size * y, 0), seam=on_line(0, 0.0))
    mark_widths(source)
    flatten(source, spacing=50.0)
    (low, high), (other_low, other_high) = boxes_of(source)
    return np.maximum(other_low - high, low - other_high).max() * meters


@pytest.mark.parametrize(("size", "meters"), [(0.5, 1.0), (4.0, 1.0), (500.0, 0.001)])
def test_the_gap_is_a_length_whatever_the_size_of_the_pieces_and_the_unit(size, meters):
    """The gap is between cutting lines, which are 10 mm outside the pieces here."""
    assert gap_of_two(size, meters) == pytest.approx(0.05 + 2 * 0.01, abs=1e-5)


def mark_everywhere(source):
    widths = source.data.attributes.new("wirewarp_allowance", "FLOAT", "EDGE")
    widths.data.foreach_set("value", np.full(len(source.data.edges), 0.04, dtype=np.float32))


def mark_one_side(source):
    flatten(source, spacing=50.0)
    select_side(source, -1)
    assert bpy.ops.mesh.wirewarp_allowance(kind="WIDTH", width=40.0) == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.data.objects.remove(flat_of(source))  # Otherwise, pieces would keep their places.
    select_only(source)


def mark_one_side_and_clear_it(source):
    mark_one_side(source)
    assert on_edges(source, bpy.ops.mesh.wirewarp_allowance, on_line(0, 0.0), kind="DEFAULT") == {"FINISHED"}


def mark_a_former_seam(source):
    line = on_line(1, 0.0)
    mark_seam(source, line)
    assert on_edges(source, bpy.ops.mesh.wirewarp_allowance, line, kind="WIDTH", width=40.0) == {"FINISHED"}
    on_edges(source, bpy.ops.mesh.mark_seam, line, clear=True)


@pytest.mark.parametrize(
    ("mark_widths", "widest"),
    [
        (mark_everywhere, 0.04),
        (mark_one_side, 0.04),
        (mark_one_side_and_clear_it, 0.01),
        (mark_a_former_seam, 0.01),
    ],
)
def test_the_gap_counts_from_the_widest_allowance_on_an_outline(mark_widths, widest):
    """widest: width of the widest allowance on the outline, in meters."""
    assert gap_of_two(0.5, 1.0, mark_widths) == pytest.approx(0.05 + 2 * widest, abs=1e-5)


def test_another_allowance_alone_moves_no_piece():
    source = flattened("Plane", lambda x, y: (x, y, 0), seam=on_line(0, 0.0))
    before = read(flat_of(source).data.vertices, "co", np.float32, 3)
    bpy.context.scene.wirewarp.allowance = 40.0
    flatten(source)
    assert np.allclose(read(flat_of(source).data.vertices, "co", np.float32, 3), before, atol=1e-6)
