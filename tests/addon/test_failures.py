# SPDX-License-Identifier: GPL-3.0-or-later
"""What cannot be done, each with its sentence; what is written then and what is not."""

import json
import re
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from everything import draw_panels
from surfaces import bump, edge_vertices, flat_of, grid, make_object, mark, on_line, read, select_only, uv_of

CUBE = (
    [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)],
    [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)],
)


def cube(name="Cube"):
    return make_object(name, *CUBE)


def bump_and_cube():
    """One object of two components: one can be flattened, the other is closed."""
    source = grid("Both", bump)
    other = cube()
    select_only(source, other)
    bpy.ops.object.join()
    return source


def flatten_fails(match, **settings):
    with pytest.raises(RuntimeError, match=match):
        bpy.ops.object.wirewarp_flatten(**settings)


def nothing_written(source):
    return (
        not source.data.uv_layers
        and "wirewarp_uv_scale" not in source.data
        and "wirewarp_report" not in source
        and f"{source.name} Flat" not in bpy.data.objects
    )


def test_one_bad_piece_spares_the_others(tmp_path):
    source = bump_and_cube()
    flatten_fails("Both, Left: .*seam", report_path=str(tmp_path / "r.json"))
    faces = read(flat_of(source).data.attributes["piece"].data, "value", np.int32)
    assert (len(faces), set(faces)) == (64, {0})
    starts = read(source.data.polygons, "loop_start", np.int32)
    assert np.all(uv_of(source.data)[starts[64] :] == 0)
    assert uv_of(source.data).max() == 1
    (entry,) = json.loads((tmp_path / "r.json").read_text())["objects"]
    assert [piece["ok"] for piece in entry["pieces"]] == [True, False]
    assert [(issue["code"], issue["piece"]) for issue in entry["issues"]] == [("closed_chart", 1)]
    assert (entry["ok"], entry["flat_object"]) == (False, "Both Flat")


def test_no_good_piece_leaves_the_file_alone_but_for_the_report(tmp_path):
    source = cube()
    flatten_fails("Error: Cube: ", report_path=str(tmp_path / "report.json"))
    assert nothing_written(source)
    report = json.loads((tmp_path / "report.json").read_text())
    assert not report["ok"]
    assert report["objects"][0]["issues"][0]["code"] == "closed_chart"


def test_a_failed_run_leaves_the_last_good_result():
    source = grid("Bump", bump)
    bpy.ops.object.wirewarp_flatten()
    before = uv_of(source.data)
    source.data.vertices[40].co = (float("nan"), 0, 0)
    flatten_fails("Bump: ")
    assert np.array_equal(uv_of(source.data), before)
    assert len(flat_of(source).data.polygons) == 64


def test_a_failed_object_spares_the_others():
    good, bad = grid("Good", bump), cube("Bad")
    select_only(good, bad)
    flatten_fails("Error: Bad: ")
    assert len(flat_of(good).data.polygons) == 64
    assert nothing_written(bad)


def test_the_active_model_counts_as_selected_if_nothing_is():
    source, other = grid("Bump", bump), grid("Other", bump)
    bpy.ops.object.select_all(action="DESELECT")
    bpy.context.view_layer.objects.active = source
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert flat_of(source) and nothing_written(other)


def test_nothing_selected():
    grid("Bump", bump)
    bpy.ops.object.select_all(action="DESELECT")
    bpy.context.view_layer.objects.active = None
    flatten_fails(r"Nothing to flatten: select a mesh object\.$")
    grid("Bump", bump).hide_set(True)
    flatten_fails('Nothing to flatten: "Bump.001" is hidden')


def test_what_is_no_mesh_is_converted_first():
    bpy.ops.curve.primitive_bezier_circle_add()
    flatten_fails('Circle" is not a mesh. Use Object > Convert > Mesh first')


def test_flat_pieces_without_their_model_in_sight_are_not_flattened_again():
    source = grid("Bump", bump)
    bpy.ops.object.wirewarp_flatten()
    select_only(flat_of(source))
    collection = bpy.data.collections.new("Away")
    bpy.context.scene.collection.children.link(collection)
    for each in source.users_collection:
        each.objects.unlink(source)
    collection.objects.link(source)
    bpy.context.view_layer.layer_collection.children["Away"].exclude = True
    flatten_fails('"Bump", the model of these pieces, is not in this view layer')


def test_flat_pieces_whose_model_was_deleted(addon):
    """Blender keeps the model in the file, as the pieces point to it, but not where a script removes it."""
    source = grid("Bump", bump)
    bpy.ops.object.wirewarp_flatten()
    flat = flat_of(source)
    select_only(source)
    bpy.ops.object.delete()
    select_only(flat)
    sentence = 'These are flat pieces. Their model "Bump" was deleted: bring it back with Ctrl\\+Z'
    flatten_fails(sentence.replace("These", "these"))
    assert re.search(sentence, draw_panels(addon))
    bpy.data.objects.remove(source)
    flatten_fails('"Bump Flat" holds flat pieces, and their model was deleted')
    flat.data.attributes.remove(flat.data.attributes["source_vertex"])
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}


def test_other_modes():
    grid("Bump", bump)
    bpy.ops.object.mode_set(mode="VERTEX_PAINT")
    flatten_fails("Object Mode and in Edit Mode")


def test_a_mesh_without_faces():
    make_object("Points", [(0, 0, 0), (1, 0, 0)], [])
    flatten_fails("Points: The mesh has no faces, so there is nothing to flatten. In Edit Mode, fill its outlines")


def test_zero_scale():
    source = grid("Bump", bump)
    source.scale.z = 0
    flatten_fails('"Bump" is scaled to zero along an axis')
    assert nothing_written(source)


def test_eight_uv_layers():
    source = grid("Bump", bump)
    for number in range(8):
        source.data.uv_layers.new(name=f"Map {number}")
    flatten_fails("already has 8 UV maps")
    source.data.uv_layers["Map 3"].name = "WireWarp"
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert len(source.data.uv_layers) == 8


def test_users_of_one_mesh_that_differ_in_scale():
    source = grid("Bump", bump)
    bpy.ops.object.duplicate(linked=True)
    twin = bpy.context.active_object
    twin.rotation_euler.z = 1
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    twin.scale = (2, 2, 2)
    select_only(twin)
    flatten_fails('"Bump.001" and "Bump" share the mesh "Bump" but differ in scale.*Make Single User')
    assert bpy.ops.object.wirewarp_flatten(use_modifiers=True) == {"FINISHED"}  # writes no UV map
    bpy.ops.object.make_single_user(object=True, obdata=True)
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert twin.data["wirewarp_uv_scale"] == pytest.approx(2 * source.data["wirewarp_uv_scale"], rel=1e-5)


def test_linked_data(tmp_path):
    grid("Bump", bump)
    path = str(tmp_path / "library.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    with bpy.data.libraries.load(path, link=True) as (_, wanted):
        wanted.objects = ["Bump"]
    linked = wanted.objects[0]
    bpy.context.scene.collection.objects.link(linked)
    select_only(linked)
    flatten_fails('"Bump" is linked from another file.*Make Local')
    own = bpy.data.objects.new("Own", linked.data)
    bpy.context.scene.collection.objects.link(own)
    select_only(own)
    flatten_fails('"Own" is linked from another file')
    bpy.ops.object.make_local(type="SELECT_OBDATA")
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}


def test_a_report_file_in_no_folder(tmp_path):
    source = grid("Bump", bump)
    flatten_fails("there is no folder", report_path=str(tmp_path / "none" / "report.json"))
    flatten_fails("Blender file; save that first", report_path="//report.json")
    assert nothing_written(source)


def test_a_report_file_that_cannot_be_written(tmp_path):
    source = grid("Bump", bump)
    flatten_fails(re.escape(f'Cannot write "{tmp_path}": it is a folder'), report_path=str(tmp_path))
    assert nothing_written(source)


def test_a_report_file_in_a_folder_that_takes_none(tmp_path):
    """/proc takes new files from nobody, whatever he may do."""
    source = grid("Bump", bump)
    flatten_fails('Cannot write "/proc/report.json": ', report_path="/proc/report.json")
    assert nothing_written(source)
    path = tmp_path / "report.json"
    bpy.ops.object.wirewarp_flatten(report_path=str(path))
    assert list(tmp_path.iterdir()) == [path]


def test_a_vertex_that_is_nowhere():
    source = grid("Bump", bump)
    source.data.vertices[40].co.z = float("nan")
    flatten_fails("The coordinates of 1 vertex are not numbers, or far too large. Move or delete it")
    assert nothing_written(source)


def bump_with_a_faulty_wire():
    """A wire along the middle whose tolerance is no number, as a file edited by hand may have it."""
    source = grid("Bump", bump)
    mark(source, on_line(1, 0.0))
    source.data.attributes["wirewarp_tolerance"].data.foreach_set("value", [float("nan")] * len(source.data.edges))
    source.data.wirewarp_names[0].name = "Dart Line"
    return source


def test_a_faulty_wire_is_named_as_the_user_named_it():
    source = bump_with_a_faulty_wire()
    flatten_fails('Bump: Wire "Dart Line" has an invalid tolerance. Click it')
    assert nothing_written(source)


def selected(source, elements, attribute="select"):
    return set(np.flatnonzero(read(getattr(source.data, elements), attribute, bool)))


def test_select_issues_selects_what_the_error_speaks_of():
    source = bump_with_a_faulty_wire()
    flatten_fails("tolerance")
    assert bpy.ops.mesh.wirewarp_select_issues() == {"FINISHED"}
    assert bpy.context.mode == "EDIT_MESH"
    bpy.ops.object.mode_set(mode="OBJECT")
    on_wire = {v.index for v in source.data.vertices if abs(v.co.y) < 1e-6}
    assert selected(source, "vertices") == on_wire


def test_select_issues_selects_whole_faces():
    source = bump_and_cube()
    source.data.vertices[0].co = source.data.vertices[1].co
    flatten_fails("Both, Top: 1 face has no area")
    select_only(source)
    bpy.ops.mesh.wirewarp_select_issues()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert 0 in selected(source, "polygons")


def test_select_issues_without_issues():
    source = grid("Bump", bump)
    with pytest.raises(RuntimeError, match="has not been flattened yet"):
        bpy.ops.mesh.wirewarp_select_issues()
    bpy.ops.object.wirewarp_flatten()
    assert bpy.ops.mesh.wirewarp_select_issues() == {"CANCELLED"}
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide()
    with pytest.raises(RuntimeError, match='"Bump" has changed since it was flattened'):
        bpy.ops.mesh.wirewarp_select_issues()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(edge_vertices(source.data)) > 144


def test_blenders_own_command_is_named_where_there_is_one():
    source = grid("Bump", bump)
    source.data.polygons[0].flip()
    flatten_fails("look to opposite sides.* In Edit Mode, use Mesh > Normals > Recalculate Outside")


def test_flipped_and_overlapping_faces_are_counted_and_selected_as_faces(addon):
    """Three triangles turned over and two that overlap, of a grid with two triangles in each face."""
    source = grid("Bump", bump)
    arrays = addon.state.read_model.object_to_arrays(source, addon.state.marked_mesh.marked_mesh(source), None)
    arguments = {"num_overlapping": 2, "has_wires": False}
    flips = {"faces": [10, 11, 12], "has_layout": True, "arguments": arguments}
    error = addon.core.library().FlattenError("flipped_faces", "The library's sentence.", **flips)
    metrics = SimpleNamespace(flipped_faces=[10, 11, 12], overlapping_faces=[20, 21])
    piece = SimpleNamespace(error=error, source_face=np.arange(128), metrics=metrics)
    issue = addon.solve.flatten.issue_of_piece(piece, 0, arrays)
    assert issue.sentence == (
        "The piece is flipped at 2 faces, and overlaps itself at 1 face. Add a seam or a dart there."
    )
    assert issue.faces == [5, 6, 10]
