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
    return addon.state.reports.last_report(target)


def test_every_kind_of_element_has_its_rows(addon, report):
    tables = report.tables
    (seam,) = tables.seams
    assert (seam.name, seam.note) == ("Seam 1", "Top Right – Top Left")
    assert [side.label for side in seam.sides] == ["Top Right", "Top Left"]
    (wire,) = tables.wires
    assert (wire.name, wire.note) == ("Wire 1", "Top Right, Top Left; free")
    assert sorted(row.name for row in tables.outlines) == ["Top Left, open edge", "Top Right, open edge"]
    pieces = tables.pieces
    assert sorted(row.name for row in pieces) == ["Top Left", "Top Right"]
    assert all(row.needed > 0 and row.area_3d > row.area_2d > 0 for row in pieces)


def test_rows_are_made_once_a_report(addon, report):
    tables = report.tables
    assert report.tables is tables
    report.pieces[0].name = "Front"  # as the user renames it
    renamed = report.tables
    assert renamed.seams[0].note == "Front – Top Left"


def test_the_report_is_parsed_once(addon, report):
    assert addon.state.reports.last_report(bpy.data.objects["Bump"]) is report


def table_of(addon, report):
    text = addon.core.report_csv(report, addon.blender.objects.length_text(bpy.context.scene))
    return list(csv.DictReader(io.StringIO(text)))


def test_the_table_for_spreadsheets_has_every_line_in_the_scenes_units(addon, report):
    settings = bpy.context.scene.unit_settings
    settings.system, settings.length_unit, settings.scale_length = "METRIC", "CENTIMETERS", 0.1
    lines = table_of(addon, report)
    assert [line["Kind"] for line in lines] == ["Seam", "Seam", "Wire", "Open edge", "Open edge", "Piece", "Piece"]
    first, second = lines[:2]
    assert [first["Name"], first["Piece"], second["Piece"]] == ["Seam 1: Top Right – Top Left", "Top Right", "Top Left"]
    assert float(first["Flat length (cm)"]) == pytest.approx(10 * report.seams[0].length_2d[0], rel=1e-6)
    assert float(first["Length on model (cm)"]) == pytest.approx(10 * report.seams[0].length_3d, rel=1e-6)
    assert (first["Tolerance (%)"], first["Kept"]) == ("0", "yes")
    wire = lines[2]
    assert (wire["Name"], wire["Piece"], wire["Tolerance (%)"]) == ("Wire 1", "Top Right, Top Left", "free")
    assert float(wire["Difference (%)"]) == pytest.approx(report.wires[0].percent[0], rel=1e-5)
    piece = lines[-1]
    assert float(piece["Area on model (cm²)"]) == pytest.approx(100 * report.pieces[1].area_3d, rel=1e-6)
    assert float(piece["Largest stretch (%)"]) == pytest.approx(100 * report.pieces[1].stretch_max, rel=1e-6)
    assert piece["Length on model (cm)"] == ""


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
    strains = [p.needed for p in addon.state.reports.last_report(source).pieces]
    assert shown == []
    assert sorted(places) == [0, 1]
    assert places.index(0) == np.argmax(strains)
    this.use_filter_sort_alpha = True
    source.wirewarp_pieces[0].name, source.wirewarp_pieces[1].name = "b", "A"
    assert listed.filter_items(this, bpy.context, source, "wirewarp_pieces") == ([], [1, 0])
    this.use_filter_sort_alpha = False
    source.wirewarp_pieces.add()  # none of the report's
    assert listed.filter_items(this, bpy.context, source, "wirewarp_pieces") == ([], [])
