# SPDX-License-Identifier: GPL-3.0-or-later
"""Pattern files have the lengths of the model, are described before the export, and are never half written.

tests/bindings tests how patterns are drawn.
"""

import re

import bmesh
import bpy
import numpy as np
import pytest
from drawing import Drawing, steps
from everything import export_dialog
from flattening import edge_lengths, edge_vertices, edited, fails, flattened
from mathutils import Matrix
from surfaces import bump, flat_of, grid, new_object, on_line, read, select_only
from two_sided import two_pieces

SEAM = on_line(0, 0.0)
# millimeters; ten times the error of four decimals, or of single precision for coordinates of about 1000 mm
ROUNDED = 5e-4


@pytest.fixture
def source():
    """Return a flattened model of two pieces. A Blender unit is 100 mm."""
    bpy.context.scene.unit_settings.length_unit = "MILLIMETERS"
    target = two_pieces()
    bpy.ops.object.wirewarp_flatten()
    return target


def export(tmp_path, name="a.svg", **settings):
    path = tmp_path / name
    assert bpy.ops.object.wirewarp_export(filepath=str(path), **settings) == {"FINISHED"}
    return path


def export_fails(match, tmp_path, name="refused.svg", **settings):
    path = tmp_path / name
    fails(bpy.ops.object.wirewarp_export, match, filepath=str(path), **settings)
    assert not path.exists()


@pytest.mark.api
@pytest.mark.parametrize(("name", "begins"), [("a.pdf", b"%PDF"), ("a.dxf", b"  0\r\nSECTION"), ("a.plt", b"IN;")])
def test_the_name_of_the_file_says_its_format(source, tmp_path, capfd, name, begins):
    assert export(tmp_path, name).read_bytes().startswith(begins)
    assert " are right to 0.0" in capfd.readouterr().out
    export_fails(r"must end in \.svg", tmp_path, f"b{name[1:]}", format="SVG")


def test_every_edge_of_every_outline_is_as_long_as_on_the_model(source, tmp_path):
    path = tmp_path / "a.svg"
    bpy.ops.object.mode_set(mode="EDIT")
    assert bpy.ops.object.wirewarp_export_svg(filepath=str(path)) == {"FINISHED"}
    assert source.mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    drawing = Drawing(path)
    assert sorted(drawing.pieces) == ["Top Left", "Top Right"]
    drawn = np.concatenate([steps(outline) for outline in drawing.outlines()])
    places = read(source.data.vertices, "co", np.float32, 3)
    lines = [on_line(axis, value) for axis in (0, 1) for value in (-1.0, 1.0)] + [SEAM, SEAM]
    on_model = [[line(places[a], places[b]) for a, b in edge_vertices(source.data)] for line in lines]
    expected = np.concatenate([100 * edge_lengths(source)[rows] for rows in on_model])
    assert np.sort(drawn) == pytest.approx(np.sort(expected), abs=ROUNDED)


def test_a_seam_of_one_edge_inside_a_piece_opens_nothing(tmp_path):
    target = grid("Bump", bump, size=4, seam=lambda a, b: sorted((a[0], b[0])) == [0.0, 0.5] and a[1] == b[1] == 0.0)
    assert sum(edge.use_seam for edge in target.data.edges) == 1
    bpy.ops.object.wirewarp_flatten()
    drawing = Drawing(export(tmp_path, "a.svg"))
    assert drawing.pieces and len(drawing.outlines()) == 1


def test_the_next_export_keeps_the_settings_but_not_the_path():
    properties = bpy.ops.object.wirewarp_export_svg.get_rna_type().properties
    assert properties["filepath"].is_skip_save and not properties["notch_spacing"].is_skip_save


def described(addon, **settings):
    """Return the dialog's description of the files with these settings."""
    parts = addon.export.read.read_pattern(bpy.context.scene, bpy.context.active_object)
    return [sentence for sentence, _ in export_dialog(addon, **settings).beforehand(parts)]


def pages(path):
    return len(re.findall(rb"/Type /Page\b", path.read_bytes()))


def test_sheets_and_sizes_are_shown_before_anything_is_written(source, tmp_path, addon):
    sheets, largest = described(addon, format="PDF", paper="A4", allowance=10.0)
    counts = re.fullmatch(r"2 pieces on (\d+) sheets of A4: a map and (\d+) sheets of the pattern\.", sheets)
    count, drawn = map(int, counts.groups())
    assert count == 1 + drawn
    assert pages(export(tmp_path, "a.pdf", paper="A4")) == count
    wide, high = re.fullmatch(r"Largest piece: Top (?:Left|Right), (\d+) × (\d+) mm\.", largest).groups()
    assert 100 < min(int(wide), int(high)) < 150 and 200 < max(int(wide), int(high)) < 260
    sheets, _ = described(addon, format="PDF", paper="A4", proof_sheet=True)
    assert sheets == f"2 pieces on {count + 1} sheets of A4: a map, {drawn} sheets of the pattern and 1 proof sheet."
    assert pages(export(tmp_path, "a.pdf", paper="A4", proof_sheet=True)) == count + 1


@pytest.mark.parametrize(
    ("system", "roll"),
    [("METRIC", "[0-9.]+ m?m of a roll of 914.4 mm"), ("IMPERIAL", "[0-9/ ]+ in of a roll of 36 in")],
)
def test_the_length_on_a_roll_is_in_the_units_of_the_scene(source, addon, system, roll):
    bpy.context.scene.unit_settings.system = system
    (sentence,) = described(addon, format="PDF", paper="36IN")
    assert re.fullmatch(rf"2 pieces on {roll}, 1 page\.", sentence)


def test_a_piece_too_large_for_the_roll_is_reported_and_the_file_stays(source, tmp_path, addon):
    path = export(tmp_path, "a.pdf", paper="36IN")
    before = path.read_bytes()
    (sentence,) = described(addon, format="PDF", paper="ROLL", roll_width=200.0)
    assert "too large for a roll of 200 mm" in sentence
    with pytest.raises(RuntimeError, match="too large for a roll of 200 mm"):
        export(tmp_path, "a.pdf", paper="ROLL", roll_width=200.0)
    assert path.read_bytes() == before and list(tmp_path.iterdir()) == [path]


def test_imperial_scenes_show_sizes_in_inches(source, tmp_path, capfd):
    bpy.context.scene.unit_settings.system = "IMPERIAL"
    root = Drawing(export(tmp_path)).root
    width, height = (float(root.get(side)[:-2]) for side in ("width", "height"))
    said = f"2 pieces on {width:.0f} × {height:.0f} mm ({width / 25.4:.1f} × {height / 25.4:.1f} in)."
    assert said in capfd.readouterr().out


def test_a_report_file_that_fails_at_the_end_keeps_the_pattern(source, tmp_path, addon, monkeypatch, capfd):
    def full(path):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(addon.core.pattern.files, "replaced_file", full)
    # The export succeeds, although its report file cannot be written.
    export(tmp_path, report_path=str(tmp_path / "warnings.json"))
    said = capfd.readouterr().out
    assert 'warnings.json": No space left on device.' in said and "2 pieces on" in said


def test_the_first_of_many_overlapping_pieces_are_named(addon):
    module, square = addon.core.pattern, np.array([(0, 0), (9, 0), (9, 9), (0, 9)], dtype=float)

    def overlap_of(count):
        outlines = [[module.Line("cut", square + k, closed=True)] for k in range(count)]
        pieces = [module.PatternPiece(k, f"P{k}", outline, [], []) for k, outline in enumerate(outlines)]
        return addon.export.steps.crossing_sentence(module.Pattern("Pile", pieces, "none", module.UnitSystem()))

    assert overlap_of(1) == ""
    assert "overlap: P0, P1, P2 and P3. Move" in overlap_of(4)
    assert "overlap: P0, P1, P2, P3 and 2 more. Move" in overlap_of(6)


@pytest.mark.parametrize(("scale", "by_parent"), [((0.9, 0.9, 0.9), False), ((-1, 1, 1), True)])
def test_pieces_that_are_scaled_as_a_whole_are_refused(source, tmp_path, scale, by_parent):
    scaled = flat_of(source)
    if by_parent:
        scaled = flat_of(source).parent = new_object("Table")
    scaled.scale = scale
    export_fails('"Bump Flat" or its parent is scaled or mirrored.*scale "Bump" and flatten', tmp_path)
    scaled.scale, scaled.rotation_euler = (1, 1, 1), (0.1, 0.2, 0.3)
    export(tmp_path)


def test_one_of_several_selected_models_is_written_with_a_message(source, tmp_path, capfd):
    other = flattened("Other", bump)
    export(tmp_path)
    assert 'Only "Other" was exported' not in capfd.readouterr().out
    select_only(other, source, flat_of(source))
    export(tmp_path)
    said = capfd.readouterr().out
    assert "Print at 100% scale." in said and 'Only "Other" was exported. Export other models separately.' in said


def test_models_without_pieces_or_with_changes_and_impossible_paths_are_refused(source, tmp_path):
    source.data.vertices[40].co.z += 0.1
    export_fails('"Bump" has changed since it was flattened. Flatten it again', tmp_path)
    source.data.vertices[40].co.z -= 0.1
    report_path = str(tmp_path / "none" / "warnings.json")
    export_fails(r'Cannot write ".*none/warnings\.json": there is no folder', tmp_path, report_path=report_path)
    export_fails("choose 1 mm or more, or 0 for none", tmp_path, notch_spacing=0.001)
    export_fails(r'Cannot write ".*none.pattern\.svg": there is no folder ".*none"\.', tmp_path, "none/pattern.svg")
    with pytest.raises(RuntimeError, match='Cannot write "//pattern.svg": "//" is the folder of the Blender file'):
        bpy.ops.object.wirewarp_export(filepath="//pattern.svg")
    flat = flat_of(source).data
    flat.attributes.remove(flat.attributes["flat_length"])  # as in pieces of earlier versions of WireWarp
    export_fails('Flatten "Bump" again', tmp_path)
    bpy.data.objects.remove(flat_of(source))
    export_fails('"Bump" has no flat pieces. Flatten it first', tmp_path)


def rip(edit):
    """Cut a piece along two edges in a row."""
    inner = next(edge for edge in edit.edges if all(len(vertex.link_faces) == 4 for vertex in edge.verts))
    following = next(
        edge
        for edge in inner.verts[0].link_edges
        if not set(edge.link_faces) & set(inner.link_faces) and len(edge.link_faces) == 2
    )
    bmesh.ops.split_edges(edit, edges=[inner, following])


def merge_by_distance(edit):
    """Move a piece so that a vertex of the seam meets its copy on the other piece, and merge both."""
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


def move_a_vertex(edit):
    edit.verts[7].co.x += 0.01


def forge_a_piece(edit):
    edit.faces[0][edit.faces.layers.int["piece"]] = -5


EDITS = {  # for each case, how the flat pieces are edited
    "a vertex moved": move_a_vertex,
    "a face deleted": lambda edit: bmesh.ops.delete(edit, geom=edit.faces[:1], context="FACES"),
    "tilted": lambda edit: bmesh.ops.transform(edit, matrix=Matrix.Rotation(0.5, 4, "X"), verts=edit.verts),
    "a piece forged": forge_a_piece,
    "ripped": rip,
    "merged by distance": merge_by_distance,
    "a piece mirrored": mirror_a_piece,
}


@pytest.mark.api
@pytest.mark.parametrize("change", EDITS)
def test_pieces_edited_by_hand_are_not_trusted(source, tmp_path, change):
    with edited(flat_of(source).data) as edit:
        EDITS[change](edit)
    export_fails('The pieces in "Bump Flat" were edited by hand', tmp_path)


def test_a_seam_that_is_missing_on_the_pieces_is_reported(source, tmp_path):
    sources = flat_of(source).data.attributes["source_vertex"].data
    numbers = read(sources, "value", np.int32)
    # Each of the two pieces has a copy of this vertex of the seam.
    inside = np.flatnonzero(np.bincount(numbers) == 2)[3]
    sources[int(np.flatnonzero(numbers == inside)[0])].value = 0
    export_fails("edited by hand, and a seam of the model is missing on them. Flatten the model again", tmp_path)
