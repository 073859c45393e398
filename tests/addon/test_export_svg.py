# SPDX-License-Identifier: GPL-3.0-or-later
"""The pattern as SVG: true to the model, and refused where the pieces are not those of the model any more."""

import bmesh
import bpy
import numpy as np
import pytest
from drawing import Drawing, steps
from mathutils import Matrix
from surfaces import bump, edge_lengths, edge_vertices, flat_of, grid, mark, mark_seam, on_line, read, select_only

SEAM, WIRE = on_line(0, 0.0), on_line(1, 0.0)
ROUNDED = 5e-4  # millimeters: the file has four decimals, Blender's coordinates of 1000 mm about as many


def export(source, tmp_path, flatten=None, **settings):
    """Flattens, with the settings given, and exports."""
    if flatten is not None:
        select_only(source)
        bpy.ops.object.wirewarp_flatten(**flatten)
    path = tmp_path / "pattern.svg"
    assert bpy.ops.object.wirewarp_export_svg(filepath=str(path), **settings) == {"FINISHED"}
    return Drawing(path)


def export_fails(match, tmp_path, **settings):
    path = tmp_path / "refused.svg"
    with pytest.raises(RuntimeError, match=match):
        bpy.ops.object.wirewarp_export_svg(filepath=str(path), **settings)
    assert not path.exists()


@pytest.fixture
def source():
    """Two pieces with a rigid wire through both; a Blender unit is 100 mm."""
    units = bpy.context.scene.unit_settings
    units.scale_length, units.length_unit = 0.1, "MILLIMETERS"
    target = grid("Bump", bump)
    mark_seam(target, SEAM)
    mark(target, WIRE)
    return target


def lengths_on(source, line):
    places = read(source.data.vertices, "co", np.float32, 3)
    return 100 * edge_lengths(source)[[line(places[a], places[b]) for a, b in edge_vertices(source.data)]]


@pytest.mark.parametrize("mirror", [False, True])
def test_every_edge_of_every_outline_is_as_long_as_on_the_model(source, tmp_path, mirror):
    drawing = export(source, tmp_path, flatten={"mirror": mirror})
    assert sorted(drawing.pieces) == ["Top Left", "Top Right"]
    drawn = np.concatenate([steps(outline) for outline in drawing.outlines()])
    sides = [on_line(axis, value) for axis in (0, 1) for value in (-1.0, 1.0)]
    expected = np.concatenate([lengths_on(source, line) for line in (*sides, SEAM, SEAM)])
    assert np.sort(drawn) == pytest.approx(np.sort(expected), abs=ROUNDED)


def test_notches_too_close_to_be_cut_are_refused(source, tmp_path):
    bpy.ops.object.wirewarp_flatten()
    export_fails("choose 1 mm or more, or 0 for none", tmp_path, notch_spacing=0.001)


def test_the_next_export_does_not_start_from_the_last_file():
    operator = bpy.ops.object.wirewarp_export_svg.get_rna_type()
    assert operator.properties["filepath"].is_skip_save
    assert not operator.properties["notch_spacing"].is_skip_save


def test_whole_pieces_may_be_moved_and_turned(source, tmp_path):
    before = export(source, tmp_path, flatten={})
    flat = flat_of(source)
    pieces = read(flat.data.attributes["piece"].data, "value", np.int32)
    own = {vertex for face in np.flatnonzero(pieces == 0) for vertex in flat.data.polygons[face].vertices}
    for vertex in own:
        x, y, _ = flat.data.vertices[vertex].co
        flat.data.vertices[vertex].co = (-y + 30, x + 1, 0)
    select_only(flat)
    after = export(source, tmp_path)
    for name in before.pieces:
        ((then,), (now,)) = before.lines(name, "Cut"), after.lines(name, "Cut")
        assert steps(now) == pytest.approx(steps(then), abs=0.01)
    assert np.concatenate(after.outlines()).max() > 3000


def test_from_edit_mode_too(source, tmp_path):
    bpy.ops.object.wirewarp_flatten()
    bpy.ops.object.mode_set(mode="EDIT")
    export(source, tmp_path)
    assert source.mode == "EDIT"


def test_no_pattern_of_what_has_no_pieces_or_has_changed(source, tmp_path):
    export_fails('"Bump" has no flat pieces: flatten it first', tmp_path)
    bpy.ops.object.wirewarp_flatten()
    source.data.vertices[40].co.z += 0.1
    export_fails('"Bump" has changed since it was flattened. Flatten it again', tmp_path)
    source.data.vertices[40].co.z -= 0.1
    bpy.data.objects.remove(flat_of(source))
    export_fails('"Bump" has no flat pieces', tmp_path)


def move_a_vertex(edit):
    edit.verts.ensure_lookup_table()
    edit.verts[7].co.x += 0.01


def delete_a_face(edit):
    edit.faces.ensure_lookup_table()
    bmesh.ops.delete(edit, geom=edit.faces[:1], context="FACES")


def tilt(edit):
    bmesh.ops.transform(edit, matrix=Matrix.Rotation(0.5, 4, "X"), verts=edit.verts)


def forge_a_piece(edit):
    edit.faces.ensure_lookup_table()
    edit.faces[0][edit.faces.layers.int["piece"]] = -5


def rip(edit):
    """Cuts the piece along a line of edges; nothing moves."""
    inner = next(edge for edge in edit.edges if all(len(vertex.link_faces) == 4 for vertex in edge.verts))
    following = next(
        edge
        for edge in inner.verts[0].link_edges
        if not set(edge.link_faces) & set(inner.link_faces) and len(edge.link_faces) == 2
    )
    bmesh.ops.split_edges(edit, edges=[inner, following])


def merge_by_distance(edit):
    """Two sides of the seam, put over each other, are sewn."""
    piece = edit.faces.layers.int["piece"]
    source_vertex = edit.verts.layers.int["source_vertex"]
    sides = [{v[source_vertex]: v for face in edit.faces if face[piece] == k for v in face.verts} for k in (0, 1)]
    shared = next(number for number in sides[0] if number in sides[1])
    apart = sides[0][shared].co - sides[1][shared].co
    for vertex in sides[1].values():
        vertex.co += apart
    bmesh.ops.remove_doubles(edit, verts=edit.verts, dist=1e-6)


def mirror_a_piece(edit):
    piece = edit.faces.layers.int["piece"]
    for vertex in {vertex for face in edit.faces if face[piece] == 1 for vertex in face.verts}:
        vertex.co.x *= -1


@pytest.mark.parametrize(
    "change", [move_a_vertex, delete_a_face, tilt, forge_a_piece, rip, merge_by_distance, mirror_a_piece]
)
def test_pieces_edited_by_hand_are_not_trusted(source, tmp_path, change):
    bpy.ops.object.wirewarp_flatten()
    edit = bmesh.new()
    edit.from_mesh(flat_of(source).data)
    change(edit)
    edit.to_mesh(flat_of(source).data)
    edit.free()
    export_fails('The pieces in "Bump Flat" were edited by hand', tmp_path)


def test_a_seam_that_is_not_found_on_the_pieces_is_a_sentence(source, tmp_path):
    bpy.ops.object.wirewarp_flatten()
    flat = flat_of(source).data
    sources = flat.attributes["source_vertex"].data
    numbers = read(sources, "value", np.int32)
    inside = np.flatnonzero(np.bincount(numbers) == 2)[3]  # in the middle of the seam: once on either side
    sources[int(np.flatnonzero(numbers == inside)[0])].value = 0
    export_fails("edited by hand, and a seam of the model is missing on them. Flatten the model again", tmp_path)


def test_flat_pieces_of_an_earlier_version_are_flattened_again(source, tmp_path):
    bpy.ops.object.wirewarp_flatten()
    flat = flat_of(source).data
    flat.attributes.remove(flat.attributes["flat_length"])
    export_fails('Flatten "Bump" again', tmp_path)


def test_a_folder_that_is_not_there_is_a_sentence(source, tmp_path):
    bpy.ops.object.wirewarp_flatten()
    with pytest.raises(RuntimeError, match=r'Cannot write ".*none.pattern\.svg": there is no folder ".*none"\.'):
        bpy.ops.object.wirewarp_export_svg(filepath=str(tmp_path / "none" / "pattern.svg"))


def test_the_folder_of_a_file_that_was_never_saved_is_a_sentence(source):
    bpy.ops.object.wirewarp_flatten()
    with pytest.raises(RuntimeError, match='Cannot write "//pattern.svg": "//" is the folder of the Blender file'):
        bpy.ops.object.wirewarp_export_svg(filepath="//pattern.svg")
