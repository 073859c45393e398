# SPDX-License-Identifier: GPL-3.0-or-later
"""The export reads the data of flat pieces for the library. Each choice in its dialog changes the pattern.

tests/bindings tests how patterns are drawn.
"""

import bpy
import numpy as np
import pytest
from everything import export_dialog
from flattening import edge_lengths, edge_vertices
from surfaces import bump, flat_of, grid, mark, on_edges, on_line, read

SEAM, WIRE = on_line(0, 0.0), on_line(1, 0.0)


@pytest.fixture
def source():
    """Return a model of two pieces with wires of each kind through both. A Blender unit is 100 mm."""
    bpy.context.scene.unit_settings.scale_length = 0.1
    target = grid("Bump", bump, seam=SEAM, wire=WIRE)
    mark(target, on_line(1, 0.5), kind="ELASTIC", tolerance=0.02)
    mark(target, on_line(1, -0.5), kind="SUPER_ELASTIC")
    return target


def parts_of(addon, source, **settings):
    bpy.ops.object.wirewarp_flatten(**settings)
    return addon.export.read.read_pattern(bpy.context.scene, source)


def lengths_on(source, line):
    """Return the lengths in millimeters of the edges on a line of the model."""
    places = read(source.data.vertices, "co", np.float32, 3)
    return 100 * edge_lengths(source)[[line(places[a], places[b]) for a, b in edge_vertices(source.data)]]


def steps(piece, vertices):
    return np.linalg.norm(np.diff(piece.vertices[vertices], axis=0), axis=1)


@pytest.mark.parametrize("mirror", [False, True])
def test_pieces_have_names_outlines_and_wires_of_the_model(addon, source, mirror):
    source.data.wirewarp_names[0].name = "Waist"
    parts = parts_of(addon, source, mirror=mirror)
    assert {piece.name for piece in parts.pieces} == {"Top Left", "Top Right"}
    assert (parts.title, parts.seam_names, parts.failed, parts.units) == ("Bump", ["Seam 1"], [], "metric")
    # Elastic and free wires are not measured.
    assert parts.measures == [("Waist", pytest.approx(lengths_on(source, WIRE).sum(), rel=1e-6))]
    model = read(source.data.vertices, "co", np.float32, 3)
    for piece in parts.pieces:
        kinds = {wire.kind: wire for wire in piece.wires}
        assert set(kinds) == {"rigid", "elastic", "super_elastic"} and kinds["rigid"].name == "Waist"
        own = np.sort(steps(piece, kinds["rigid"].vertices))
        assert own == pytest.approx(np.sort(lengths_on(source, WIRE))[: len(own) * 2 : 2], abs=1e-3)
        (seam,) = [chain for chain in piece.chains if chain.seam == 0]
        assert np.abs(model[seam.sources][:, 0]).max() < 1e-6
        outline = piece.vertices[piece.outline]
        assert np.linalg.norm(outline[:, 1] - outline[:, 0], axis=1).sum() == pytest.approx(
            sum(lengths_on(source, on_line(axis, at)).sum() for axis in (0, 1) for at in (-1.0, 1.0)) / 2
            + lengths_on(source, SEAM).sum(),
            abs=0.01,
        )


def test_allowances_of_edges_sides_and_folds_are_in_millimeters(addon, source):
    bpy.ops.object.wirewarp_flatten()
    on_edges(source, bpy.ops.mesh.wirewarp_allowance, on_line(0, 1.0), kind="HEM", hem=30.0)
    on_edges(source, bpy.ops.mesh.wirewarp_allowance, on_line(0, -1.0), kind="FOLD")
    both, sides, folds = addon.export.read.read_pattern(bpy.context.scene, source).allowances
    model = read(source.data.vertices, "co", np.float32, 3)
    assert sides == [] and [width for *_, width in both] == pytest.approx([30.0] * len(both))
    assert all(model[vertex][0] == pytest.approx(1.0) for a, b, _ in both for vertex in (a, b))
    assert folds and all(model[vertex][0] == pytest.approx(-1.0) for pair in folds for vertex in pair)
    made = addon.export.export.made_pattern(
        addon.export.read.read_pattern(bpy.context.scene, source), export_dialog(addon, allowance=10.0).choices()
    )
    widths = {round(line.width) for piece in made.pieces for line in piece.of_role("sew")}
    assert widths == {10, 30} and any(piece.on_fold for piece in made.pieces)


def test_imperial_scenes_and_pieces_turned_by_hand(addon, source):
    bpy.context.scene.unit_settings.system = "IMPERIAL"
    before = parts_of(addon, source)
    assert before.units == "imperial"
    for vertex in flat_of(source).data.vertices:
        x, y, _ = vertex.co
        vertex.co = (-y + 3, x + 1, 0)
    after = addon.export.read.read_pattern(bpy.context.scene, source)
    for then, now in zip(before.pieces, after.pieces, strict=True):
        assert now.vertices == pytest.approx(then.vertices @ [[0, 1], [-1, 0]] + (300, 100), abs=0.01)


def test_each_choice_of_the_dialog_reaches_the_pattern(addon, source):
    parts = parts_of(addon, source)

    def made(**settings):
        return addon.export.export.made_pattern(parts, export_dialog(addon, **settings).choices())

    plain = made()
    assert plain.allowance_text == "10 mm"
    assert made(allowance=7.0).allowance_text == "7 mm"

    def notches(pattern):
        return sum(point.role == "notch" for piece in pattern.pieces for point in piece.points)

    assert notches(made(notch_spacing=20.0)) > notches(made(notch_spacing=0.0)) > 0
    roles = {
        "SEW": "sew", "WIRES": "wire", "GRAIN": "grain", "NOTCHES": "notch", "TEXTS": "card", "LINE_NAMES": "line name"
    }  # fmt: skip
    for kind, role in roles.items():
        (left, right) = made(drawn={kind}).pieces
        found = {each.role for piece in (left, right) for each in (*piece.lines, *piece.points, *piece.texts)}
        assert role in found and not found & (set(roles.values()) - {role})
    darts = [export_dialog(addon, darts=each).choices().made["darts"] for each in ("CLOSE", "CUT", "SLIT")]
    assert darts == ["close", "cut", "slit"]
    rows, lie = made(arrangement="IN_ROWS"), made(arrangement="AS_LAID_OUT")
    assert rows.bounds[0].tolist() == [0, 0] and rows.pieces[1].bounds[0].tolist() != lie.pieces[1].bounds[0].tolist()
    marker = made(arrangement="MARKER", cloth_width=400.0, gap=4.0, grain="BOTH_WAYS", seconds=0).marker
    assert (marker.width, marker.gap) == (400.0, 4.0)
    assert {round(placement.angle) % 180 for placement in marker.placements} == {0}


def test_each_format_gets_its_options(addon):
    options = {
        (suffix, name): value
        for suffix, each in addon.core.pattern.FORMATS.items()
        for name, value in export_dialog(addon, format=suffix[1:].upper()).choices().options.items()
    }
    expected = {
        (".pdf", "proof"): False,
        (".pdf", "paper"): "a4",
        (".pdf", "keep_places"): False,
        (".svg", "preset"): "print",
        (".dxf", "dialect"): "astm",
        (".dxf", "control_square"): False,
    }
    assert {key: options.get(key) for key in expected} == expected

    def pdf(**settings):
        return export_dialog(addon, format="PDF", **settings).choices().options

    assert pdf(paper="ROLL", roll_width=900.0)["paper"] == 900.0
    assert pdf(arrangement="MARKER")["paper"] is None and pdf(arrangement="AS_LAID_OUT")["keep_places"]
