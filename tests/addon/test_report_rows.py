# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of the panel, and the one for spreadsheets."""

import csv
import io
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from surfaces import bump, grid, mark, mark_seam, on_line

WIRE, SEAM = on_line(1, 0.0), on_line(0, 0.0)


@pytest.fixture
def report(addon):
    """A dome in two pieces with a free wire across."""
    target = grid("Bump", bump)
    mark_seam(target, SEAM)
    mark(target, WIRE, kind="SUPER_ELASTIC")
    bpy.ops.object.wirewarp_flatten()
    return addon.flat.reports.last_report(target)


def lengths(percent, length=1.0):
    flat = None if percent is None else length * (1 + percent / 100)
    difference = None if percent is None else flat - length
    return {"length_3d": length, "length_2d": [flat], "difference": [difference], "percent": [percent]}


def test_rows_are_worst_first(addon):
    def seam(index, percent, ok=True):
        named = {"name": f"Seam {index + 1}", "seam_id": index}
        return {"index": index, "pieces": [0], "ok": ok, **named, **lengths(percent)}

    seams = [seam(0, 0.1), seam(1, -0.5), seam(2, None, ok=False), seam(3, 1e-12), seam(4, 2e-12)]
    rows = addon.report.rows.seam_rows({"pieces": [{"name": "Front"}], "seams": seams})
    assert [row.name for row in rows] == [f"Seam {k}" for k in (3, 2, 1, 4, 5)]
    assert [row.index for row in rows] == [2, 1, 0, 3, 4]  # what its button selects
    assert addon.report.rows.largest_difference(rows) == pytest.approx(0.005)
    assert addon.report.rows.largest_difference(rows[:1]) is None  # no layout


def test_every_kind_of_element_has_its_rows(addon, report):
    tables = addon.report.rows.tables_of(report)
    (seam,) = tables.seams
    assert (seam.name, seam.note) == ("Seam 1", "Top Right – Top Left")
    assert [side.label for side in seam.sides] == ["Top Right", "Top Left"]
    (wire,) = tables.wires
    assert (wire.name, wire.note) == ("Wire 1", "Top Right, Top Left; free")
    assert sorted(row.name for row in tables.outlines) == ["Top Left, open edge", "Top Right, open edge"]
    pieces = tables.pieces
    assert sorted(row.name for row in pieces) == ["Top Left", "Top Right"]
    assert all(row.stretch > 0 and row.area_3d > row.area_2d > 0 for row in pieces)


def test_rows_are_made_once_a_report(addon, report):
    tables = addon.report.rows.tables_of(report)
    assert addon.report.rows.tables_of(report) is tables
    report["pieces"][0]["name"] = "Front"  # as the user renames it
    renamed = addon.report.rows.tables_of(report)
    assert renamed.seams[0].note == "Front – Top Left"
    assert addon.report.rows.tables_of(dict(report)) is not renamed


def test_the_report_is_parsed_once(addon, report):
    assert addon.flat.reports.last_report(bpy.data.objects["Bump"]) is report


def test_sides_that_read_the_same_are_put_together(addon):
    side = SimpleNamespace
    same, other = ("1.00", "0.00", "0.000"), ("1.01", "+0.01", "+1.000")
    merged = addon.report.rows.merged
    two = [side(label="Front"), side(label="Back")]
    assert merged(two, [same, same]) == [("Both sides", same)]
    assert merged(two, [same, other]) == [("Front", same), ("Back", other)]
    assert merged([*two, side(label="Piping")], [same] * 3) == [("All 3 sides", same)]
    assert merged([side(label="Flat")], [same]) == [("Flat", same)]


def table_of(addon, report):
    text = addon.report.csv_table.report_csv(report, addon.blender.units.length_text(bpy.context.scene))
    return list(csv.DictReader(io.StringIO(text)))


def test_a_name_is_no_formula(addon, report):
    pieces = [piece | {"name": "=1+1"} for piece in report["pieces"]]
    assert [line["Name"] for line in table_of(addon, report | {"pieces": pieces})][-1] == "'=1+1"


def test_the_table_for_spreadsheets_has_every_line_in_the_scenes_units(addon, report):
    settings = bpy.context.scene.unit_settings
    settings.system, settings.length_unit, settings.scale_length = "METRIC", "CENTIMETERS", 0.1
    lines = table_of(addon, report)
    assert [line["Kind"] for line in lines] == ["Seam", "Seam", "Wire", "Open edge", "Open edge", "Piece", "Piece"]
    first, second = lines[:2]
    assert [first["Name"], first["Piece"], second["Piece"]] == ["Seam 1: Top Right – Top Left", "Top Right", "Top Left"]
    assert float(first["Flat length (cm)"]) == pytest.approx(10 * report["seams"][0]["length_2d"][0], rel=1e-6)
    assert float(first["Length on model (cm)"]) == pytest.approx(10 * report["seams"][0]["length_3d"], rel=1e-6)
    assert (first["Tolerance (%)"], first["Kept"]) == ("0", "yes")
    wire = lines[2]
    assert (wire["Name"], wire["Piece"], wire["Tolerance (%)"]) == ("Wire 1", "Top Right, Top Left", "free")
    assert float(wire["Difference (%)"]) == pytest.approx(report["wires"][0]["percent"][0], rel=1e-5)
    piece = lines[-1]
    assert float(piece["Area on model (cm²)"]) == pytest.approx(100 * report["pieces"][1]["area_3d"], rel=1e-6)
    assert float(piece["Largest stretch (%)"]) == pytest.approx(100 * report["pieces"][1]["stretch_max"], rel=1e-6)
    assert piece["Length on model (cm)"] == ""


def test_what_rounds_to_nothing_has_no_sign_in_the_table(addon, report):
    report["wires"][0] |= {"difference": [-1e-12], "percent": [-1e-10]}
    wire = table_of(addon, report)[2]
    assert [wire["Difference (m)"], wire["Difference (%)"]] == ["0.000000", "0.000000"]


def test_a_wire_of_any_name_stays_one_line_of_the_table(addon, report):
    report["wires"][0]["name"] = 'Waist, "high"\nline'
    assert table_of(addon, report)[2]["Name"] == 'Waist, "high"\nline'


def test_without_a_layout_the_table_has_no_flat_numbers(addon):
    bpy.ops.mesh.primitive_cube_add()
    with pytest.raises(RuntimeError, match="is closed"):
        bpy.ops.object.wirewarp_flatten()
    (piece,) = table_of(addon, addon.flat.reports.last_report(bpy.context.object))
    assert float(piece["Area on model (m²)"]) == pytest.approx(24)
    assert [piece[title] for title in ("Flat area (m²)", "Area difference (%)", "Largest stretch (%)", "Kept")] == [
        "", "", "", "no",
    ]  # fmt: skip


def test_a_table_of_a_changed_model_is_told_from_a_true_one(capfd):
    source = grid("Bump", bump)
    bpy.ops.object.wirewarp_flatten()
    bpy.ops.object.wirewarp_copy_report()
    assert "2 lines copied\n" in capfd.readouterr().out
    source.data.vertices[40].co.z += 1
    source.data.update()
    bpy.ops.object.wirewarp_copy_report()
    assert '2 lines copied. "Bump" has changed since' in capfd.readouterr().out


def test_there_must_be_a_report_to_copy():
    grid("Bump", bump)
    with pytest.raises(RuntimeError, match='"Bump" has not been flattened yet'):
        bpy.ops.object.wirewarp_copy_report()


def test_the_list_of_pieces_has_the_worst_first(addon):
    source = grid("Bump", bump)
    mark_seam(source, on_line(0, 0.5))
    bpy.ops.object.wirewarp_flatten()
    listed = bpy.types.WIREWARP_UL_pieces
    this = SimpleNamespace(filter_name="", bitflag_filter_item=1 << 30, use_filter_sort_alpha=False)
    shown, places = listed.filter_items(this, bpy.context, source, "wirewarp_pieces")
    strains = [max(p["stretch_max"], p["ease_max"]) for p in addon.flat.reports.last_report(source)["pieces"]]
    assert shown == []
    assert sorted(places) == [0, 1]
    assert places.index(0) == np.argmax(strains)
    this.use_filter_sort_alpha = True
    source.wirewarp_pieces[0].name, source.wirewarp_pieces[1].name = "b", "A"
    assert listed.filter_items(this, bpy.context, source, "wirewarp_pieces") == ([], [1, 0])
    this.use_filter_sort_alpha = False
    source.wirewarp_pieces.add()  # none of the report's
    assert listed.filter_items(this, bpy.context, source, "wirewarp_pieces") == ([], [])
