# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat pieces do not overlap each other or models, and keep the requested spacing."""

import bpy
import numpy as np
import pytest
from mathutils import Vector
from surfaces import bump, flat_of, flatten, grid, mark_seam, on_line, read, select_edges, select_only
from two_sided import select_side


def test_models_flattened_together_have_their_pieces_at_one_height_and_under_none_of_them():
    """A small model, a tall one on its right, and one that hovers where the pieces of the first would be."""
    models = [grid(name, bump) for name in ("Left", "Tall", "Hovering")]
    for model, place in zip(models, [(0, 0, 0), (7, 0, -1), (3.5, 0, 4)], strict=True):
        model.location = place
    models[1].scale = (1, 1, 3)
    select_only(*models)
    bpy.ops.object.wirewarp_flatten()
    bpy.context.view_layer.update()
    flats = [flat_of(model) for model in models]
    assert len({round(flat.location.z, 5) for flat in flats}) == 1
    boxes = [world_box(each) for each in (*models, *flats)]
    for flat in boxes[3:]:
        assert not any(np.all((flat[0] < other[1]) & (other[0] < flat[1])) for other in boxes if other is not flat)


def world_box(target):
    """Return its box (2,2) from above."""
    corners = np.array([(target.matrix_world @ Vector(corner))[:2] for corner in target.bound_box])
    return np.array([corners.min(axis=0), corners.max(axis=0)])


def gap_of_two(size, meters, mark_widths=lambda _: None):
    """Return the space between two pieces 50 mm apart, in meters. mark_widths: marks allowances on the model."""
    bpy.context.scene.unit_settings.scale_length = meters
    source = grid("Plane", lambda x, y: (size * x, size * y, 0))
    mark_seam(source, on_line(0, 0.0))
    mark_widths(source)
    flatten(source, spacing=50.0)
    mesh = flat_of(source).data
    boxes = []
    for piece in (0, 1):
        faces = [face for face in mesh.polygons if mesh.attributes["piece"].data[face.index].value == piece]
        places = np.array([mesh.vertices[vertex].co[:2] for face in faces for vertex in face.vertices])
        boxes.append((places.min(axis=0), places.max(axis=0)))
    (low, high), (other_low, other_high) = boxes
    apart = np.maximum(other_low - high, low - other_high).max()
    return apart * meters


@pytest.mark.parametrize(("size", "meters"), [(0.5, 1.0), (4.0, 1.0), (500.0, 0.001)])
def test_the_gap_is_a_length_whatever_the_size_of_the_pieces_and_the_unit(size, meters):
    """It is the distance of the cutting lines, which are 10 mm outside the pieces here."""
    assert gap_of_two(size, meters) == pytest.approx(0.05 + 2 * 0.01, abs=1e-5)


def mark_everywhere(source):
    """Mark 40 mm on all edges."""
    widths = source.data.attributes.new("wirewarp_allowance", "FLOAT", "EDGE")
    widths.data.foreach_set("value", np.full(len(source.data.edges), 0.04, dtype=np.float32))


def mark_one_side(source):
    """Mark 40 mm on one side of the seam."""
    flatten(source, spacing=50.0)
    select_side(source, -1)
    assert bpy.ops.mesh.wirewarp_allowance(kind="WIDTH", width=40.0) == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.data.objects.remove(flat_of(source))  # otherwise its pieces would keep their places
    select_only(source)


def mark_one_side_and_clear_it(source):
    mark_one_side(source)
    select_edges(source, on_line(0, 0.0))
    assert bpy.ops.mesh.wirewarp_allowance(kind="DEFAULT") == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")


def mark_what_is_no_seam_any_more(source):
    select_edges(source, on_line(1, 0.0))
    bpy.ops.mesh.mark_seam()
    assert bpy.ops.mesh.wirewarp_allowance(kind="WIDTH", width=40.0) == {"FINISHED"}
    bpy.ops.mesh.mark_seam(clear=True)
    bpy.ops.object.mode_set(mode="OBJECT")


@pytest.mark.parametrize(
    ("mark_widths", "widest"),
    [
        (mark_everywhere, 0.04),
        (mark_one_side, 0.04),
        (mark_one_side_and_clear_it, 0.01),
        (mark_what_is_no_seam_any_more, 0.01),
    ],
)
def test_the_gap_counts_from_the_widest_allowance_on_an_outline(mark_widths, widest):
    assert gap_of_two(0.5, 1.0, mark_widths) == pytest.approx(0.05 + 2 * widest, abs=1e-5)


def test_another_allowance_moves_no_piece_by_itself():
    source = grid("Plane", lambda x, y: (x, y, 0))
    mark_seam(source, on_line(0, 0.0))
    flatten(source)
    before = read(flat_of(source).data.vertices, "co", np.float32, 3)
    bpy.context.scene.wirewarp.allowance = 40.0
    flatten(source)
    assert np.allclose(read(flat_of(source).data.vertices, "co", np.float32, 3), before, atol=1e-6)
