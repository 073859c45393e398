# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces are named after their places on the model, and keep their names when the model changes."""

import json
import math
import os

import bmesh
import bpy
import numpy as np
import pytest
from flattening import edited, flatten_fails
from surfaces import bump, flat_of, grid, make_object, mark_seam, new_object, on_line, read, select_edges, select_only
from view_context import marked_lines

TURN = [2 * math.pi * k / 8 for k in range(8)]
TUBE_FACES = [[k, (k + 1) % 8, (k + 1) % 8 + 8, k + 8] for k in range(8)]
HALVES = ["Top Left", "Top Right"]


def names_of(source):
    return [entry.name for entry in source.wirewarp_pieces]


def flatten(source, **settings):
    if source.mode == "OBJECT":
        select_only(source)
    bpy.ops.object.wirewarp_flatten(**settings)
    return names_of(source)


def rename(source, old, new):
    next(entry for entry in source.wirewarp_pieces if entry.name == old).name = new


@pytest.fixture
def source():
    """Return a model of two pieces, to the left and right of x = 0."""
    return grid("Bump", bump, seam=on_line(0, 0.0))


def middle_of(source, name):
    """Return the mean center of the model's faces that belong to the piece."""
    piece_id = next(entry.piece_id for entry in source.wirewarp_pieces if entry.name == name)
    ids = read(source.data.attributes["wirewarp_piece"].data, "value", np.int32)
    return read(source.data.polygons, "center", np.float32, 3)[ids == piece_id].mean(axis=0)


def test_pieces_are_named_after_their_side_as_the_object_is_turned(source):
    assert sorted(flatten(source)) == HALVES
    assert middle_of(source, "Top Left")[0] > 0.4  # the left of the wearer, who faces -Y
    assert middle_of(source, "Top Right")[0] < -0.4
    source.wirewarp_pieces.clear()
    source.rotation_euler = (np.pi / 2, 0, 0)  # Now, its top faces -Y.
    assert sorted(flatten(source)) == ["Front Left", "Front Right"]


def test_a_tube_turned_inside_out_keeps_front_and_back_and_is_reported():
    around = [(math.cos(turn), math.sin(turn)) for turn in TURN]
    tube = make_object("Tube", [(x, y, z) for z in (0, 1) for x, y in around], TUBE_FACES)
    mark_seam(tube, on_line(1, 0.0))
    assert sorted(flatten(tube)) == ["Back", "Front"]
    assert middle_of(tube, "Front")[1] < 0 and json.loads(tube["wirewarp_report"])["notes"] == []
    tube.wirewarp_pieces.clear()
    tube.data.flip_normals()
    assert sorted(flatten(tube)) == ["Back", "Front"]
    assert middle_of(tube, "Front")[1] < 0
    (note,) = json.loads(tube["wirewarp_report"])["notes"]
    assert note["text"].startswith("Normals point inward, so pieces show their inside") and note["is_warning"]
    bpy.ops.object.wirewarp_flatten(mirror=True)
    assert json.loads(tube["wirewarp_report"])["notes"] == []  # Mirrored pieces show the outside.
    bowl = grid("Bowl", lambda x, y: (x, y, x * x + y * y))
    assert flatten(bowl)  # An open surface has no inside, so its normals are not reported.
    assert json.loads(bowl["wirewarp_report"])["notes"] == []


def test_the_six_sides_of_a_cube():
    bpy.ops.mesh.primitive_cube_add()
    target = bpy.context.active_object
    target.data.edges.foreach_set("use_seam", [True] * len(target.data.edges))
    assert sorted(flatten(target)) == ["Back", "Bottom", "Front", "Left", "Right", "Top"]
    for name, place in {"Back": (0, 1, 0), "Bottom": (0, 0, -1), "Left": (1, 0, 0)}.items():
        assert middle_of(target, name) == pytest.approx(place)


def test_a_piece_that_winds_around_is_named_after_its_place():
    sleeves = [
        make_object(f"Tube {x}", [(x + math.cos(a), math.sin(a), z) for z in (0, 3) for a in TURN], TUBE_FACES)
        for x in (-4, 4)
    ]
    for sleeve in sleeves:
        sleeve.data.edges.foreach_set("use_seam", [set(edge.vertices) == {0, 8} for edge in sleeve.data.edges])
    assert flatten(sleeves[0]) == ["Tube -4"]
    select_only(*sleeves)
    bpy.ops.object.join()
    assert sorted(flatten(sleeves[0])) == ["Left", "Right"]
    assert middle_of(sleeves[0], "Left")[0] > 3


def test_the_only_piece_has_the_name_of_the_model_until_it_is_cut():
    source = grid("Sleeve", bump)
    assert flatten(source) == ["Sleeve"]
    source.data.vertices[40].co = source.data.vertices[41].co
    flatten_fails("^Error: Sleeve: ")  # not "Sleeve, Sleeve: "
    source.data.vertices[40].co = (0, 0, 0.4)
    mark_seam(source, on_line(0, 0.0))
    assert sorted(flatten(source)) == HALVES
    other = grid("Other", bump)
    flatten(other)
    other.wirewarp_pieces[0].name = "Arm"
    mark_seam(other, on_line(0, 0.5))
    assert "Arm" in flatten(other)


def test_results_follow_the_name_of_the_model_and_names_given_by_the_user_stay():
    source = grid("Sleeve", bump)
    flatten(source)
    source.name = "Cuff"
    assert flatten(source) == ["Cuff"]
    assert {each.name for each in bpy.data.objects} == {"Cuff", "Cuff Flat"}
    bpy.data.objects["Cuff Flat"].name = "Paper"
    source.wirewarp_pieces[0].name = "Arm"
    source.name = "Band"
    assert flatten(source) == ["Arm"]
    assert {each.name for each in bpy.data.objects} == {"Band", "Paper"}
    mark_seam(source, on_line(0, 0.0))
    flatten(source)
    source.wirewarp_pieces[0].name = "Band"
    assert "Band" in flatten(source)
    source.name = "Shirt"
    assert "Band" in flatten(source)


@pytest.mark.skipif("WINEPREFIX" in os.environ, reason="under Wine Blender does not read the library that it wrote")
def test_a_linked_mesh_may_have_the_name_of_the_results(tmp_path):
    source, path = grid("Sleeve", bump), str(tmp_path / "other.blend")
    flatten(source)
    bpy.data.libraries.write(path, {flat_of(source).data})
    flat_of(source).data.name = "Own"
    with bpy.data.libraries.load(path, link=True) as (_, linked):
        linked.meshes = ["Sleeve Flat"]
    flat_of(source).data = linked.meshes[0]
    source.name = "Cuff"
    flatten(source)
    flat = flat_of(source)
    assert flat.data.name == "Cuff Flat" and flat.data.library is None
    assert linked.meshes[0].name == "Sleeve Flat"


@pytest.mark.parametrize(("axis", "halves"), [(0, ("Left", "Right")), (1, ("Back", "Front"))])
def test_pieces_in_one_half_of_a_side_are_numbered(axis, halves):
    """The pieces of a left-right pair have the same number."""
    target = grid("Bump", bump)
    for line in (-0.5, 0.0, 0.5):
        mark_seam(target, on_line(axis, line))
    assert sorted(flatten(target)) == [f"Top {half} {number}" for half in halves for number in (1, 2)]
    if axis == 0:
        assert middle_of(target, "Top Left 1")[0] == pytest.approx(-middle_of(target, "Top Right 1")[0])


@pytest.mark.parametrize("kind", ["group", "material", "attribute"])
def test_two_pieces_of_one_region_are_named_by_the_region_and_their_side(kind):
    target = grid("Bump", bump, seam=on_line(0, -0.5))
    mark_seam(target, on_line(0, 0.5))
    if kind == "group":
        fill_group(target, "Sleeve", lambda co: abs(co.x) > 0.49)
    else:
        of_sleeve = [abs(face.center.x) > 0.5 for face in target.data.polygons]
        if kind == "material":
            for name in ("Body", "Sleeve"):
                target.data.materials.append(bpy.data.materials.new(name))
            target.data.polygons.foreach_set("material_index", [int(each) for each in of_sleeve])
        else:
            target.data.attributes.new("Sleeve", "BOOLEAN", "FACE").data.foreach_set("value", of_sleeve)
    middle = "Body" if kind == "material" else "Top"
    assert sorted(flatten(target)) == sorted([middle, "Left Sleeve", "Right Sleeve"])
    assert middle_of(target, "Left Sleeve")[0] > 0.5


def fill_group(target, name, wanted):
    vertices = [vertex.index for vertex in target.data.vertices if wanted(vertex.co)]
    target.vertex_groups.new(name=name).add(vertices, 1.0, "REPLACE")


def test_a_vertex_group_gives_its_name_to_the_piece_it_covers(source):
    # Vertices with a small weight are not members of a group.
    source.vertex_groups.new(name="Faint").add(range(81), 0.3, "REPLACE")
    fill_group(source, "Half", lambda co: co.x > 0.6)  # To name a piece, a group must contain at least half of it.
    # A material of the whole model does not distinguish pieces.
    source.data.materials.append(bpy.data.materials.new("Felt"))
    assert sorted(flatten(source)) == HALVES
    source.wirewarp_pieces.clear()
    fill_group(source, "All", lambda _: True)
    fill_group(source, "Sleeve", lambda co: co.x > -0.3)  # the left piece and a little of the right piece
    source.vertex_groups.new(name="Empty")
    assert sorted(flatten(source)) == ["Sleeve", "Top Right"]
    assert middle_of(source, "Sleeve")[0] > 0


def test_a_name_given_by_the_user_stays_when_the_model_is_reshaped_and_subdivided(source, addon):
    flatten(source)
    rename(source, "Top Left", "Sleeve")
    for vertex in source.data.vertices:
        vertex.co.z *= 2
    select_edges(source, lambda *_: True)
    bpy.ops.mesh.subdivide()
    assert sorted(flatten(source)) == ["Sleeve", "Top Right"]
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(source.data.polygons) == 256 and middle_of(source, "Sleeve")[0] > 0


def test_the_larger_of_two_parts_keeps_the_name(source):
    flatten(source)
    rename(source, "Top Left", "Sleeve")
    mark_seam(source, on_line(0, 0.75))
    assert sorted(flatten(source)) == ["Sleeve", "Top Left", "Top Right"]
    assert middle_of(source, "Top Left")[0] == pytest.approx(0.875)
    assert 0 < middle_of(source, "Sleeve")[0] < 0.75
    select_edges(source, on_line(0, 0.75))
    bpy.ops.mesh.mark_seam(clear=True)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert sorted(flatten(source)) == ["Sleeve", "Top Right"]


def test_joined_and_copied_pieces_keep_their_names_if_possible(source):
    flatten(source)
    rename(source, "Top Left", "Sleeve")
    select_only(source)
    bpy.ops.object.duplicate()
    copy = bpy.context.active_object
    assert sorted(names_of(copy)) == ["Sleeve", "Top Right"]
    copy.location.x = 5
    select_only(source, copy)
    bpy.ops.object.join()
    names = flatten(source)
    assert len(set(names)) == 4
    assert {"Sleeve", "Top Right"} < set(names)  # Of two pieces with one name, only one keeps it.
    assert len({entry.piece_id for entry in source.wirewarp_pieces}) == 4


def test_one_name_given_to_two_pieces_is_numbered_in_the_next_run(source):
    flatten(source)
    for entry in source.wirewarp_pieces:
        entry.name = "Sleeve"
    assert sorted(flatten(source)) == ["Sleeve", "Sleeve 2"]
    source.wirewarp_pieces[0].name = ""
    assert "" not in flatten(source)


def test_names_in_the_report_and_the_overlay_follow_a_renaming_at_once(source, addon, tmp_path):
    path = tmp_path / "report.json"
    names = flatten(source, report_path=str(path))
    (entry,) = json.loads(path.read_text())["objects"]
    assert [piece["name"] for piece in entry["pieces"]] == names
    assert [piece["piece_id"] for piece in entry["pieces"]] == [entry.piece_id for entry in source.wirewarp_pieces]
    rename(source, "Top Left", "Sleeve")
    report = addon.state.reports.last_report(source)
    assert sorted(piece.name for piece in report.pieces) == ["Sleeve", "Top Right"]
    (row,) = report.tables.seams
    assert sorted(side.label for side in row.sides) == ["Sleeve", "Top Right"]
    drawn = [name.texts[-1] for name in marked_lines(addon, flat_of(source)).names]
    assert {"Sleeve", "Top Right"} <= set(drawn)


def test_with_modifiers_names_stay_without_writing_to_the_mesh_and_on_edited_pieces(source):
    source.modifiers.new("Smooth", "SUBSURF").levels = 1
    assert sorted(flatten(source, use_modifiers=True)) == HALVES
    rename(source, "Top Left", "Sleeve")
    assert sorted(flatten(source, use_modifiers=True)) == ["Sleeve", "Top Right"]
    assert "wirewarp_piece" not in source.data.attributes
    with edited(flat_of(source).data) as edit:
        bmesh.ops.delete(edit, geom=list(edit.faces)[:40], context="FACES")
        edit.faces.ensure_lookup_table()
        edit.faces[0][edit.faces.layers.int["source_face"]] = 10**6
    assert sorted(flatten(source, use_modifiers=True)) == ["Sleeve", "Top Right"]


def test_objects_that_share_a_mesh_keep_their_own_names(source):
    other = new_object("Other", source.data)
    flatten(source)
    flatten(other)
    for target, name in ((source, "Sleeve"), (other, "Cuff")):
        rename(target, "Top Left", name)
    assert sorted(flatten(source)) == ["Sleeve", "Top Right"]
    assert sorted(flatten(other)) == ["Cuff", "Top Right"]


def test_a_forged_negative_id_counts_as_none(source):
    flatten(source)
    ids = source.data.attributes["wirewarp_piece"]
    ids.data.foreach_set("value", [-7] * len(source.data.polygons))
    assert sorted(flatten(source)) == HALVES
    assert all(entry.piece_id > 0 for entry in source.wirewarp_pieces)


def tube_along(path, cuts):
    """Return a tube of eight sides along a path (k,3) at y = 0. Seams are its lower side and the rings in `cuts`."""
    path = np.array(path, dtype=float)
    along = np.gradient(path, axis=0)
    across = np.column_stack([-along[:, 2], 0 * along[:, 1], along[:, 0]]) / np.linalg.norm(along, axis=1)[:, None]
    turns = np.array(TURN)[None, :, None]
    rings = path[:, None] - 0.3 * (np.cos(turns) * across[:, None] + np.sin(turns) * [0, 1, 0])
    faces = [[8 * ring + corner for corner in face] for ring in range(len(path) - 1) for face in TUBE_FACES]
    source = make_object("Suit", rings.reshape(-1, 3).tolist(), faces)
    for edge in source.data.edges:
        a, b = sorted(edge.vertices)
        edge.use_seam = (a // 8 in cuts and b // 8 == a // 8) or (a % 8 == b % 8 == 0)
    return source


def test_sleeves_are_recognized_by_their_seams():
    path = [(x, 0, 0) for x in np.linspace(-3, 3, 13)]
    assert sorted(flatten(tube_along(path, {4, 8}))) == ["Around", "Left Sleeve", "Right Sleeve"]
    assert len(flatten(tube_along(path, {2, 4, 8, 10}))) == 5
    # The outer pieces can be cuffs, so no piece is named a sleeve.
    assert not any("Sleeve" in name for name in names_of(bpy.context.object))


def test_legs_are_recognized_by_their_crotch_seam():
    bend = [(-math.cos(turn), 0, math.sin(turn)) for turn in np.linspace(0, math.pi, 9)]
    legs = [(-1, 0, -2), (-1, 0, -1), *bend, (1, 0, -1), (1, 0, -2)]
    assert sorted(flatten(tube_along(legs, {6}))) == ["Left Leg", "Right Leg"]
    tube_along([(x, y, -z) for x, y, z in legs], {6})  # upside down, like the handle of a bag
    assert not any("Leg" in name for name in flatten(bpy.context.object))


def test_the_name_of_a_material_is_better_than_that_of_a_limb():
    source = tube_along([(x, 0, 0) for x in np.linspace(-3, 3, 13)], {4, 8})
    for name in "Body", "Glove":
        source.data.materials.append(bpy.data.materials.new(name))
    for face in source.data.polygons:
        face.material_index = int(abs(face.center.x) > 1)
    assert sorted(flatten(source)) == ["Body", "Left Glove", "Right Glove"]
