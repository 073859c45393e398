# SPDX-License-Identifier: GPL-3.0-or-later
"""The pattern as SVG: true sizes in millimeters, read back from the file."""

import re

import bmesh
import bpy
import numpy as np
import pytest
from drawing import LABEL, SVG, Drawing, points_of, steps
from mathutils import Matrix
from surfaces import bump, edge_lengths, edge_vertices, flat_of, grid, mark, mark_seam, on_line, read, select_only

GROUPMODE = "{http://www.inkscape.org/namespaces/inkscape}groupmode"
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


def test_a_rigid_wire_is_as_long_as_on_the_model_and_has_its_own_layer(source, tmp_path):
    source.data.wirewarp_names[0].name = "Waist"
    drawing = export(source, tmp_path, flatten={})
    drawn = [line for piece in drawing.pieces for line in drawing.lines(piece, "Rigid Wires")]
    assert np.sort(np.concatenate([steps(line) for line in drawn])) == pytest.approx(
        np.sort(lengths_on(source, WIRE)), abs=ROUNDED
    )
    (path,) = drawing.layer("Top Left", "Rigid Wires").findall(f"{SVG}path")
    assert path.find(f"{SVG}title").text == "Waist"


def test_kinds_of_wires_are_told_by_layer_color_and_dashes(source, tmp_path):
    mark(source, on_line(1, 0.5), kind="ELASTIC", tolerance=0.02)
    mark(source, on_line(1, -0.5), kind="SUPER_ELASTIC")
    drawing = export(source, tmp_path, flatten={})
    layers = list(drawing.pieces["Top Left"].findall(f"{SVG}g"))
    assert all(layer.get(GROUPMODE) == "layer" for layer in layers)
    by_label = {layer.get(LABEL): layer for layer in layers}
    labels = ["Cut", "Rigid Wires", "Elastic Wires", "Free Wires", "Notches"]
    assert set(by_label) == {*labels, "Grain", "Text", "Line Names"}
    assert list(by_label)[-1] == "Cut"  # what is inside is cut first
    lines = [by_label[label].find(f"{SVG}path") for label in labels]
    assert len({line.get("stroke") for line in lines}) == 5
    assert ["stroke-dasharray" in line.attrib for line in lines] == [False, False, True, True, False]


def test_every_line_says_itself_how_it_looks(source, tmp_path):
    """Programs of cutters read no style sheet, and fill with black what does not say otherwise."""
    root = export(source, tmp_path, flatten={}).root
    lines = list(root.iter(f"{SVG}path"))
    assert lines
    assert all(line.get("fill") == "none" and re.fullmatch("#[0-9a-f]{6}", line.get("stroke")) for line in lines)
    assert all(float(line.get("stroke-width")) > 0 for line in lines)
    assert root.find(f"{SVG}style") is None


def seam_in(source, drawing, piece):
    """The seam of one piece in the drawing, from y = -1 on the model."""
    flat = flat_of(source).data
    places = 100 * read(flat.vertices, "co", np.float32, 3)[:, :2] * (1, -1)
    outlines = np.concatenate(drawing.outlines())
    places += outlines.min(axis=0) - places.min(axis=0)
    sources = read(flat.attributes["source_vertex"].data, "value", np.int32)
    model = read(source.data.vertices, "co", np.float32, 3)[sources]
    (own,) = drawing.lines(piece, "Cut")
    ours = [np.linalg.norm(own - place, axis=1).min() < 0.01 for place in places]
    on_seam = np.flatnonzero(ours & (np.abs(model[:, 0]) < 1e-6))
    return places[on_seam[np.argsort(model[on_seam, 1])]]


def lengths_along(line, points):
    """From the start of the line to each of the points that lie on it, ascending."""
    before = np.concatenate([[0], np.cumsum(steps(line))])
    found = []
    for point in points:
        share = np.clip(((point - line[:-1]) * np.diff(line, axis=0)).sum(axis=1) / steps(line) ** 2, 0, 1)
        feet = line[:-1] + share[:, None] * np.diff(line, axis=0)
        distance = np.linalg.norm(feet - point, axis=1)
        nearest = int(np.argmin(distance))
        if distance[nearest] < 0.01:
            found.append(before[nearest] + share[nearest] * steps(line)[nearest])
    return sorted(found)


def test_notches_of_both_sides_of_a_seam_are_at_the_same_lengths(source, tmp_path):
    drawing = export(source, tmp_path, flatten={}, notch_spacing=40.0)
    length = lengths_on(source, SEAM).sum()
    sides = []
    for piece in drawing.pieces:
        seam = seam_in(source, drawing, piece)
        assert steps(seam).sum() == pytest.approx(length, abs=10 * ROUNDED)
        sides.append(lengths_along(seam, [notch[0] for notch in drawing.lines(piece, "Notches")]))
    assert sides[0] == pytest.approx(sides[1], abs=10 * ROUNDED)
    every = [40 * k for k in range(1, int(length / 40) + 1)]
    clear = [at for at in every if abs(at - length / 2) > 8 and length - at > 8]  # of the wire and of the seam's end
    expected = sorted([*clear, length / 2])
    counted_from_the_other_end = sorted(length - at for at in expected)
    start = expected if sides[0][0] == pytest.approx(40, abs=0.01) else counted_from_the_other_end
    assert sides[0] == pytest.approx(start, abs=10 * ROUNDED)


def test_notches_lead_into_the_piece_and_stand_at_ends_of_wires(source, tmp_path, addon):
    drawing = export(source, tmp_path, flatten={"mirror": True}, notch_spacing=0.0)
    for piece in drawing.pieces:
        notches = drawing.lines(piece, "Notches")
        (wire,) = drawing.lines(piece, "Rigid Wires")
        (outline,) = drawing.lines(piece, "Cut")
        assert len(notches) == 2
        for notch in notches:
            assert steps(notch) == pytest.approx([5], abs=ROUNDED)
            assert min(np.linalg.norm(end - notch[0]) for end in (wire[0], wire[-1])) < ROUNDED
            assert addon.pattern.polygons.are_inside(
                notch[1:], addon.pattern.polygons.Segments(outline[:-1], outline[1:])
            ).all()


def test_a_wire_that_ends_at_a_seam_has_a_notch_on_the_other_side_too(tmp_path):
    source = grid("Bump", bump)
    mark_seam(source, SEAM)
    mark(source, lambda a, b: WIRE(a, b) and a[0] + b[0] > 0)
    drawing = export(source, tmp_path, flatten={}, notch_spacing=0.0)
    assert [len(drawing.lines(piece, "Notches")) for piece in ("Top Left", "Top Right")] == [2, 1]


def test_both_sides_of_a_dart_get_notches(tmp_path):
    bpy.context.scene.unit_settings.scale_length = 0.1
    source = grid("Bump", bump)
    mark_seam(source, lambda a, b: WIRE(a, b) and a[0] + b[0] > 0)
    drawing = export(source, tmp_path, flatten={}, notch_spacing=30.0)
    assert len(drawing.lines("Bump", "Notches")) == 2 * int(lengths_on(source, WIRE).sum() / 2 / 30)


def test_notches_too_close_to_be_cut_are_refused(source, tmp_path):
    bpy.ops.object.wirewarp_flatten()
    export_fails("choose 1 mm or more, or 0 for none", tmp_path, notch_spacing=0.001)


def test_the_next_export_does_not_start_from_the_last_file():
    operator = bpy.ops.object.wirewarp_export_svg.get_rna_type()
    assert operator.properties["filepath"].is_skip_save
    assert not operator.properties["notch_spacing"].is_skip_save


def test_page_square_and_units_are_millimeters(source, tmp_path):
    drawing = export(source, tmp_path, flatten={})
    width, height = (drawing.root.get(side) for side in ("width", "height"))
    assert width.endswith("mm")
    assert drawing.root.get("viewBox") == f"0 0 {width[:-2]} {height[:-2]}"
    (scale,) = [group for group in drawing.root.findall(f"{SVG}g") if group.get(LABEL) == "Scale"]
    square = points_of(scale.find(f"{SVG}path"))
    assert steps(square) == pytest.approx([100] * 4)
    assert next(scale.iter(f"{SVG}tspan")).text == "100 mm"
    everything = np.concatenate([*drawing.outlines(), square])
    assert everything.min(axis=0) == pytest.approx([10, 10], abs=ROUNDED)
    assert everything.max(axis=0) == pytest.approx([float(width[:-2]) - 10, float(height[:-2]) - 10], abs=ROUNDED)
    pieces = np.concatenate(drawing.outlines())
    beside = square.min(axis=0) >= pieces.max(axis=0)
    assert beside.any()


def test_groups_are_named_even_where_names_are_no_ids(source, tmp_path):
    bpy.ops.object.wirewarp_flatten()
    for entry, name in zip(source.wirewarp_pieces, ("1 <Ärmel>", "1 >Ärmel<"), strict=True):
        entry.name = name
    drawing = export(source, tmp_path)
    assert set(drawing.pieces) == {"1 <Ärmel>", "1 >Ärmel<"}
    ids = [element.get("id") for element in drawing.root.iter() if element.get("id")]
    assert len(set(ids)) == len(ids)
    assert all(re.fullmatch(r"[^\W\d][\w.-]*|_[\w.-]*", each) for each in ids)
    assert [group.get(LABEL) for group in drawing.pieces.values()] == list(drawing.pieces)


def test_text_is_inside_its_piece_and_says_name_and_area(source, tmp_path):
    drawing = export(source, tmp_path, flatten={})
    for name in drawing.pieces:
        text = drawing.layer(name, "Text").find(f"{SVG}text")
        lines = [line.text for line in text.findall(f"{SVG}tspan")]
        assert name in lines
        (outline,) = drawing.lines(name, "Cut")
        (x, y), (u, v) = outline[:-1].T, outline[1:].T
        area = abs((x * v - y * u).sum()) / 2
        assert float(lines[-1].removesuffix(" cm²")) == pytest.approx(area / 100, abs=0.06)
        place = [float(number) for number in re.match(r"translate\((\S+) (\S+)\)", text.get("transform")).groups()]
        assert np.all((outline.min(axis=0) < place) & (place < outline.max(axis=0)))


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


def test_failed_pieces_are_written_only_if_asked_for(tmp_path):
    source, other = grid("Both", bump), grid("Spike", lambda x, y: (x + 3, y, 2 * (1 - x * x) * (1 - y * y)))
    mark(other, on_line(0, 3.0), on_line(1, 0.0))
    select_only(source, other)
    bpy.ops.object.join()
    with pytest.raises(RuntimeError, match="turned over"):
        bpy.ops.object.wirewarp_flatten(method="WIREWARPING")
    export_fails("Failed: Top Left. See the report", tmp_path)
    assert set(export(source, tmp_path, failed_pieces=True).pieces) == {"Top Left", "Top Right"}


def test_a_folder_that_is_not_there_is_a_sentence(source, tmp_path):
    bpy.ops.object.wirewarp_flatten()
    with pytest.raises(RuntimeError, match=r'Cannot write ".*none.pattern\.svg": there is no folder ".*none"\.'):
        bpy.ops.object.wirewarp_export_svg(filepath=str(tmp_path / "none" / "pattern.svg"))


def test_the_folder_of_a_file_that_was_never_saved_is_a_sentence(source):
    bpy.ops.object.wirewarp_flatten()
    with pytest.raises(RuntimeError, match='Cannot write "//pattern.svg": "//" is the folder of the Blender file'):
        bpy.ops.object.wirewarp_export_svg(filepath="//pattern.svg")
