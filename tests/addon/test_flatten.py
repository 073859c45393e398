# SPDX-License-Identifier: GPL-3.0-or-later
"""Flatten writes pieces, attributes and UV map of a model. Outlines and wires have exact lengths."""

import math

import bmesh
import bpy
import numpy as np
import pytest
from flattening import edge_lengths, edge_vertices, flat_places, flat_sources, flatten, uv_of, wire_marks, world_box
from surfaces import (
    bump,
    flat_of,
    grid,
    half_cylinder,
    mark,
    mark_seam,
    new_object,
    on_line,
    read,
    round_bump,
    select_edges,
    select_only,
)

pytestmark = pytest.mark.api

SEAM_ID = "wirewarp_seam"
FLOAT32 = 2e-6  # relative tolerance for coordinates of about 1 and edges of about 0.2 in single precision


def lengths_by_source(source):
    """Return two arrays with the length of each flat edge: in the pieces, and on the model."""
    flat = flat_of(source).data
    pairs = np.sort(flat_sources(source)[edge_vertices(flat)], axis=1)
    known = {
        tuple(pair): length
        for pair, length in zip(np.sort(edge_vertices(source.data)).tolist(), edge_lengths(source), strict=True)
    }
    return edge_lengths(flat_of(source)), np.array([known[tuple(pair)] for pair in pairs.tolist()])


def on_outline_and_wires(source, *lines):
    """Return two masks of the flat edges: edges on the outline, and edges on these lines of the model."""
    flat = flat_of(source).data
    use = np.bincount(read(flat.loops, "edge_index", np.int32), minlength=len(flat.edges))
    places = read(source.data.vertices, "co", np.float32, 3)[flat_sources(source)][edge_vertices(flat)]
    on_wire = np.array([any(line(a, b) for line in lines) for a, b in places])
    return use == 1, on_wire


def assert_true_lengths(source, *lines, tolerance=FLOAT32):
    flat, space = lengths_by_source(source)
    mask = np.logical_or(*on_outline_and_wires(source, *lines))
    assert mask.sum() >= 4
    assert flat[mask] == pytest.approx(space[mask], rel=tolerance)


@pytest.mark.parametrize("faces", ["quads", "triangles", "ngons"])
def test_outline_and_wire_keep_their_lengths(faces):
    wire = on_line(1, 0.0)
    source = grid("Bump", round_bump, faces=faces, wire=wire)
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert_true_lengths(source, wire)
    uv, vertices = uv_of(source.data), read(source.data.loops, "vertex_index", np.int32)
    assert len(np.unique(np.column_stack([vertices, uv]), axis=0)) == len(
        source.data.vertices
    )  # one UV for each vertex
    assert len(flat_of(source).data.polygons) == len(source.data.polygons)
    assert len(flat_of(source).data.edges) == len(source.data.edges)


def test_the_uv_map_is_active_and_in_the_unit_square_and_has_a_scale():
    source = grid("Bump", bump, seam=on_line(0, 0.0))
    source.data.uv_layers.new(name="Mine")
    bpy.ops.object.wirewarp_flatten()
    assert source.data.uv_layers.active.name == "WireWarp"
    uv = uv_of(source.data)
    assert (uv.min(), uv.max()) == (0, 1)
    flat = flat_places(source)[read(flat_of(source).data.loops, "vertex_index", np.int32)]
    scale = source.data["wirewarp_uv_scale"]
    assert uv * scale == pytest.approx(flat - flat.min(axis=0), abs=1e-6 * scale)


def test_the_flat_object_lies_in_its_own_plane_in_the_collection_and_the_model_stays():
    source = grid("Bump", bump)
    before = read(source.data.vertices, "co", np.float32, 3)
    bpy.ops.object.wirewarp_flatten()
    assert np.array_equal(read(source.data.vertices, "co", np.float32, 3), before)
    assert (bpy.context.active_object, bpy.context.selected_objects) == (source, [source])
    flat = flat_of(source)
    assert [collection.name for collection in flat.users_collection] == ["WireWarp"]
    assert np.all(read(flat.data.vertices, "co", np.float32, 3)[:, 2] == 0)
    assert np.all(read(flat.data.polygons, "normal", np.float32, 3)[:, 2] > 0.99)
    assert tuple(flat.scale) == (1, 1, 1)
    kinds = {a.name: (a.domain, a.data_type) for a in flat.data.attributes if not a.name.startswith(".")}
    assert kinds["source_vertex"] == ("POINT", "INT")
    assert kinds["arap_energy"] == kinds["aspect_ratio"] == ("FACE", "FLOAT")
    assert kinds["length_variation"] == ("EDGE", "FLOAT")
    for name in ("arap_energy", "aspect_ratio", "length_variation"):
        assert f"{name}_color" in flat.data.color_attributes


# The seam is a full cut, a dart, or one edge inside the piece. In the last case, both sides of the seam have the same
# ends, so Blender makes one edge of them.
@pytest.mark.parametrize("reach", [(-2.0, 2.0), (-2.0, 0.4), (-0.1, 0.4)])
@pytest.mark.parametrize(("faces", "scale"), [("quads", -1.0), ("ngons", 1.0)])
def test_the_edges_of_the_flat_object_are_those_that_blender_finds(reach, faces, scale):
    def seam(a, b):
        return on_line(0, 0.0)(a, b) and reach[0] <= min(a[1], b[1]) and max(a[1], b[1]) <= reach[1]

    source = grid("Bump", round_bump, faces=faces, seam=seam)
    source.scale.x = scale
    bpy.ops.object.wirewarp_flatten()
    flat = flat_of(source).data
    other = bpy.data.meshes.new("Other")
    other.from_pydata([vertex.co for vertex in flat.vertices], [], [list(face.vertices) for face in flat.polygons])
    assert sorted(flat.edge_keys) == sorted(other.edge_keys)
    sides = [(corner.vertex_index, flat.edges[corner.edge_index].vertices) for corner in flat.loops]
    assert all(vertex in ends for vertex, ends in sides)
    assert not flat.validate()
    variation = read(flat.attributes["length_variation"].data, "value", np.float32)
    flat_length, space = lengths_by_source(source)
    assert variation == pytest.approx(np.abs(flat_length - space) / space, abs=1e-5)


def test_the_flat_pieces_carry_the_seams_and_wires_of_the_model():
    source = grid("Bump", bump, seam=on_line(0, 0.0), wire=on_line(1, 0.0))
    mark(source, on_line(1, 0.5), kind="ELASTIC", tolerance=0.02)
    source.data.wirewarp_names[0].name = "Bust"
    bpy.ops.object.wirewarp_flatten()
    flat = flat_of(source).data
    places = read(source.data.vertices, "co", np.float32, 3)[flat_sources(source)][edge_vertices(flat)]
    on = {value: np.array([on_line(1, value)(a, b) for a, b in places]) for value in (0.0, 0.5)}
    seam = np.array([on_line(0, 0.0)(a, b) for a, b in places])
    assert seam.sum() == 16 and np.array_equal(read(flat.edges, "use_seam", bool), seam)
    assert np.array_equal(read(flat.edges, "use_edge_sharp", bool), on[0.0] | on[0.5])
    assert wire_marks(flat) == wire_marks(source.data)
    ids = read(flat.attributes["wirewarp_wire"].data, "value", np.int32)
    names = {entry.wire_id: entry.name for entry in flat.wirewarp_names}
    assert {names[i] for i in ids[on[0.0]]} == {"Bust"}
    assert {names[i] for i in ids[on[0.5]]} == {"Wire 2"}


def corner(x, y):
    """Return a point of a half cylinder whose corner at +x, +y is cut off, to distinguish left and right."""
    return half_cylinder(x, y * (1 if x < 0.9 or y < 0 else 0.5))


@pytest.mark.parametrize("scale", [(1, 1, 1), (-1, 1, 1), (1, 1, -1), (-1, -1, -1)])
def test_pieces_come_out_as_seen_from_outside(scale):
    """Three corners have the same orientation in the flat piece as on the model seen from outside. A negative scale
    reverses this orientation.
    """
    source = grid("Corner", corner)
    source.scale = scale
    bpy.ops.object.wirewarp_flatten(mirror=True)
    assert np.all(read(flat_of(source).data.polygons, "normal", np.float32, 3)[:, 2] < -0.99)
    bpy.ops.object.wirewarp_flatten()
    flat = flat_of(source).data
    assert np.all(read(flat.polygons, "normal", np.float32, 3)[:, 2] > 0.99)
    to_flat = {int(s): i for i, s in enumerate(flat_sources(source))}
    a, b, c = (np.array(flat.vertices[to_flat[i]].co) for i in (0, 8, 80))
    mirrored = math.prod(scale) < 0
    assert (np.cross(b - a, c - a)[2] < 0) == mirrored


def test_a_second_run_replaces_pieces_and_a_copy_gets_its_own():
    source = grid("Bump", bump)
    bpy.ops.object.wirewarp_flatten()
    flat, mesh = flat_of(source), flat_of(source).data
    flat.name, flat.location = "My Pattern", (5, 6, 7)
    before = len(bpy.data.objects), len(bpy.data.meshes), len(source.data.uv_layers)
    mark_seam(source, on_line(0, 0.0))
    flatten(source)
    assert (len(bpy.data.objects), len(bpy.data.meshes), len(source.data.uv_layers)) == before
    assert flat.data == mesh and tuple(flat.location) == (5, 6, 7)
    assert len(mesh.vertices) == len(source.data.vertices) + 9
    assert len(mesh.attributes["source_vertex"].data) == len(mesh.vertices)
    flat.name = "Bump Flat"
    select_only(source)
    bpy.ops.object.duplicate()
    copy = bpy.context.active_object
    bpy.ops.object.wirewarp_flatten()
    assert flat_of(copy) != flat_of(source)


def test_several_objects_are_flattened_and_others_ignored():
    models = [grid("First", bump), grid("Second", half_cylinder)]
    new_object("Camera", bpy.data.cameras.new("Camera"))
    for _ in range(2):
        bpy.ops.object.select_all(action="SELECT")  # The second time, this selects the flat objects, too.
        bpy.ops.object.wirewarp_flatten()
    assert sorted(o.name for o in bpy.data.objects if o.name.endswith("Flat")) == ["First Flat", "Second Flat"]
    (low, high), (other_low, other_high) = (world_box(flat_of(model))[:, 0] for model in models)
    assert high < other_low or other_high < low


def test_a_run_in_edit_mode_uses_the_edits_and_stays_in_edit_mode():
    source = grid("Bump", bump)
    select_edges(source, on_line(1, 0.0))
    bpy.ops.mesh.wirewarp_mark()
    bpy.ops.mesh.mark_seam(clear=False)
    edit = bmesh.from_edit_mesh(source.data)
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert edit.is_valid and bpy.context.mode == "EDIT_MESH"  # The end of Edit Mode would make `edit` invalid.
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(flat_of(source).data.vertices) == len(source.data.vertices) + 9
    assert sum(read(source.data.edges, "select", bool)) == 8

    def written():
        values = [read(source.data.attributes[name].data, "value", np.int32) for name in ("wirewarp_piece", SEAM_ID)]
        return [*values, uv_of(source.data)], wire_marks(source.data), source.data.uv_layers.active.name

    arrays, *others = written()
    assert [np.count_nonzero(each) for each in arrays[:2]] == [64, 8]
    # In Object Mode, a run writes the same data.
    bpy.ops.object.wirewarp_flatten()
    arrays_after, *others_after = written()
    assert others == others_after
    for before, after in zip(arrays, arrays_after, strict=True):
        np.testing.assert_array_equal(before, after)


@pytest.mark.parametrize("shape", ["modifiers", "shape keys", "edited pieces"])
def test_a_run_leaves_edit_mode_and_returns_if_edit_mode_hides_the_shape(shape):
    source = grid("Bump", bump)
    flatten(source)
    if shape == "modifiers":
        source.modifiers.new("Subdivision", "SUBSURF")
    elif shape == "shape keys":
        source.shape_key_add(name="Basis")
    select_only(source, *([flat_of(source)] if shape == "edited pieces" else []))
    bpy.ops.object.mode_set(mode="EDIT")
    edit = bmesh.from_edit_mesh(source.data)
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert not edit.is_valid and bpy.context.mode == "EDIT_MESH"


def test_only_pieces_that_changed_are_solved_again(addon):
    source = grid("Bump", bump, seam=on_line(0, 0.0))

    def reused_pieces():
        bpy.ops.object.wirewarp_flatten()
        return addon.state.reports.last_report(source).reused_pieces

    assert [reused_pieces(), reused_pieces()] == [0, 2]
    before = uv_of(source.data)
    mark(source, on_line(0, 0.5))
    assert reused_pieces() == 1
    mark(source, on_line(0, -0.5))
    source.scale.x = 1.1
    assert reused_pieces() == 0
    assert not np.allclose(uv_of(source.data), before)
    addon.state.memory.forget()  # as if another file were opened
    assert reused_pieces() == 0
