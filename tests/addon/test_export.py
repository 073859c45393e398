# SPDX-License-Identifier: GPL-3.0-or-later
"""The pattern in every format: true to the model, told beforehand, and never half written."""

import re
from pathlib import Path

import bpy
import numpy as np
import pytest
from drawing import Drawing, steps
from surfaces import bump, edge_lengths, edge_vertices, flat_of, grid, mark_seam, on_line, read, select_only

pytestmark = pytest.mark.api

SEAM = on_line(0, 0.0)


@pytest.fixture
def source():
    """Two pieces; a Blender unit is 100 mm."""
    bpy.context.scene.unit_settings.scale_length = 0.1
    target = grid("Bump", bump)
    mark_seam(target, SEAM)
    bpy.ops.object.wirewarp_flatten()
    return target


def export(tmp_path, name, **settings):
    path = tmp_path / name
    assert bpy.ops.object.wirewarp_export(filepath=str(path), **settings) == {"FINISHED"}
    return path


@pytest.mark.parametrize(("name", "begins"), [("a.pdf", b"%PDF"), ("a.dxf", b"  0\r\nSECTION"), ("a.plt", b"IN;")])
def test_the_name_of_the_file_says_its_format(source, tmp_path, capfd, name, begins):
    assert export(tmp_path, name).read_bytes().startswith(begins)
    assert "Verified to 0.0" in capfd.readouterr().out


def test_a_name_of_another_format_is_refused(source, tmp_path):
    with pytest.raises(RuntimeError, match=r"must end in \.svg"):
        export(tmp_path, "a.pdf", format="SVG")
    assert not (tmp_path / "a.pdf").exists()


def test_sew_lines_are_those_of_the_model_and_the_cut_line_is_outside(source, tmp_path):
    drawing = Drawing(export(tmp_path, "a.svg", allowance=12.0))
    drawn = [steps(line) for piece in drawing.pieces for line in drawing.lines(piece, "Sew")]
    places = read(source.data.vertices, "co", np.float32, 3)
    lines = [on_line(axis, value) for axis in (0, 1) for value in (-1.0, 1.0)] + [SEAM, SEAM]
    on_model = [[line(places[a], places[b]) for a, b in edge_vertices(source.data)] for line in lines]
    expected = np.concatenate([100 * edge_lengths(source)[rows] for rows in on_model])
    assert np.sort(np.concatenate(drawn)) == pytest.approx(np.sort(expected), abs=5e-4)
    for piece in drawing.pieces:
        (cut,) = drawing.lines(piece, "Cut")
        sew = np.concatenate(drawing.lines(piece, "Sew"))
        a, along = cut[:-1], np.diff(cut, axis=0)
        share = np.clip(((sew[:, None] - a) * along).sum(axis=2) / (along**2).sum(axis=1), 0, 1)
        apart = np.linalg.norm(a + share[..., None] * along - sew[:, None], axis=2).min(axis=1)
        assert np.median(apart) == pytest.approx(12.0, abs=0.01) and apart.min() > 11.98


def test_what_is_not_wanted_is_not_drawn(source, tmp_path):
    drawing = Drawing(export(tmp_path, "a.svg", drawn={"NOTCHES"}))
    for piece in drawing.pieces:
        assert drawing.lines(piece, "Cut") and drawing.lines(piece, "Notches")
        assert not any(drawing.lines(piece, layer) for layer in ("Sew", "Grain"))


def test_pieces_lie_in_rows_or_as_in_blender(source, tmp_path):
    def places(name, **settings):
        drawing = Drawing(export(tmp_path, name, **settings))
        centers = [drawing.lines(piece, "Cut")[0].mean(axis=0) for piece in sorted(drawing.pieces)]
        return np.linalg.norm(centers[1] - centers[0])

    flat = flat_of(source).data
    pieces = read(flat.attributes["piece"].data, "value", np.int32)
    for vertex in {vertex for face in np.flatnonzero(pieces == 1) for vertex in flat.polygons[face].vertices}:
        flat.vertices[vertex].co.x += 30
    select_only(flat_of(source))
    assert places("rows.svg") < 400
    assert places("lie.svg", arrangement="AS_LAID_OUT") > 2500


def told(addon, **settings):
    """What the dialog says beforehand with these settings, all others as they are at first."""
    module, properties = addon.export, bpy.ops.object.wirewarp_export.get_rna_type().properties
    defaults = {each.identifier: each.default for each in properties if hasattr(each, "default")}
    defaults["drawn"] = module.operators.ALL_DRAWN
    bases = vars(module.steps.PatternExport) | vars(module.operators.OBJECT_OT_wirewarp_export)
    dialog = type("Dialog", (), {**bases, **defaults, **settings})
    parts = addon.export.read.read_pattern(bpy.context.scene, bpy.context.active_object)
    return [sentence for sentence, _ in dialog().beforehand(parts)]


def test_sheets_and_sizes_are_told_before_anything_is_written(source, tmp_path, addon):
    sheets, largest = told(addon, format="PDF", paper="A4", allowance=10.0)
    count = 1 + int(re.fullmatch(r"2 pieces on (\d+) sheets and a first page with the map of A4\.", sheets)[1])
    assert len(re.findall(rb"/Type /Page\b", export(tmp_path, "a.pdf", paper="A4").read_bytes())) == count
    assert re.fullmatch(r"Largest piece: Top (?:Left|Right), \d+ × \d+ mm\.", largest)


def test_a_proof_sheet_is_told_and_comes_last(source, tmp_path, addon):
    sheets, _ = told(addon, format="PDF", paper="A4", proof_sheet=True)
    assert sheets.endswith(" sheets, a first page with the map and 1 proof sheet of A4.")
    without, proved = (
        export(tmp_path, f"{name}.pdf", paper="A4", proof_sheet=name == "proved") for name in ("without", "proved")
    )
    pages = [len(re.findall(rb"/Type /Page\b", path.read_bytes())) for path in (without, proved)]
    assert pages[1] == pages[0] + 1


@pytest.mark.parametrize(
    ("system", "roll"),
    [("METRIC", "[0-9.]+ m?m of a roll of 914.4 mm"), ("IMPERIAL", "[0-9/ ]+ in of a roll of 36 in")],
)
def test_the_length_on_a_roll_is_in_the_units_of_the_scene(source, addon, system, roll):
    bpy.context.scene.unit_settings.system = system
    (sentence,) = told(addon, format="PDF", paper="ROLL_36")
    assert re.fullmatch(rf"2 pieces on {roll}, 1 page\.", sentence)


def test_a_piece_too_large_for_the_roll_is_told_and_leaves_the_file_as_it_was(source, tmp_path, addon):
    path = export(tmp_path, "a.pdf", paper="ROLL_36")
    before = path.read_bytes()
    (sentence,) = told(addon, format="PDF", paper="ROLL", roll_width=200.0)
    assert "too large for a roll of 200 mm" in sentence
    with pytest.raises(RuntimeError, match="too large for a roll of 200 mm"):
        export(tmp_path, "a.pdf", paper="ROLL", roll_width=200.0)
    assert path.read_bytes() == before
    assert [each.name for each in Path(tmp_path).iterdir()] == ["a.pdf"]


def test_a_report_file_that_cannot_be_is_refused_before_the_pattern_is_written(source, tmp_path):
    with pytest.raises(RuntimeError, match=r'Cannot write ".*none/warnings\.json": there is no folder'):
        export(tmp_path, "a.svg", report_path=str(tmp_path / "none" / "warnings.json"))
    assert list(tmp_path.iterdir()) == []


def test_a_report_file_that_fails_at_the_end_is_told_beside_the_pattern(source, tmp_path, addon, monkeypatch, capfd):
    def full(path):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(addon.export.steps, "replaced_file", full)
    export(tmp_path, "a.svg", report_path=str(tmp_path / "warnings.json"))  # has finished
    said = capfd.readouterr().out
    assert 'warnings.json": No space left on device.' in said and '"a.svg": 2 pieces' in said
