# SPDX-License-Identifier: GPL-3.0-or-later
"""Reports of eases: target lengths of lines, their errors, and which side of a seam is longer."""

import csv
import io

import bpy
import numpy as np
import pytest
from everything import draw_panels
from surfaces import mark, read
from two_sided import HEM, SEAM, ease, lengths, made, shares, two_pieces


@pytest.fixture
def source():
    return two_pieces()


def eases_of(addon, report, kind):
    """Return the target ease in the table for spreadsheets, in percent."""
    text = addon.core.report_csv(report, addon.blender.objects.length_text(bpy.context.scene))
    lines = csv.DictReader(io.StringIO(text))
    return [float(line["Asked ease (%)"]) for line in lines if line["Kind"] == kind]


def test_an_eased_outline_is_as_long_as_it_was_to_be(source, addon):
    ease(source, HEM, sides="ONE", ease_percent=5.0)
    bpy.ops.object.wirewarp_flatten()
    report = addon.state.reports.last_report(source)
    places = read(source.data.vertices, "co", np.float32, 3).astype(float)
    hem = [v for v in range(9) if HEM(places[v], places[v])]
    half = np.linalg.norm(np.diff(places[hem], axis=0), axis=1).sum() / 2  # in each piece
    for name, _, chain in addon.core.open_edges(report):
        assert chain.length_asked == pytest.approx([chain.length_3d + 0.05 * half], rel=1e-6), name
    outlines = report.tables.outlines
    assert addon.core.largest_difference(outlines) < 1e-6
    asked = 100 * 0.05 * half / outlines[0].sides[0].length_3d
    assert all(row.note == f"ease +{asked:.3g}%" for row in outlines)
    assert eases_of(addon, report, "Open edge") == pytest.approx([asked, asked], rel=1e-5)


def test_the_ease_of_all_sides_is_in_the_table_for_spreadsheets(source, addon):
    ease(source, SEAM, sides="ALL", ease_percent=-10.0)
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    bpy.ops.object.wirewarp_flatten()
    report = addon.state.reports.last_report(source)
    assert sorted(eases_of(addon, report, "Seam")) == pytest.approx([-10, 100 * (0.9 * 1.05 - 1)], abs=1e-4)


@pytest.mark.parametrize(("percent", "longer", "how"), [(5.0, 0.05, "ease"), (-40.0, 0.4, "gather")])
def test_panel_and_paper_say_which_side_is_longer_and_what_to_do(source, addon, percent, longer, how):
    """They name the longer side, whether it is eased or the other one is made shorter."""
    settings = bpy.context.scene.unit_settings
    settings.length_unit, settings.scale_length = "MILLIMETERS", 0.5  # leaves room for the text
    ease(source, SEAM, sides="ONE", ease_percent=percent)
    bpy.ops.object.wirewarp_flatten()
    (row,) = addon.state.reports.last_report(source).tables.seams
    units = addon.blender.objects.length_text(bpy.context.scene)
    left, right = shares(source)
    side = "Top Right" if left > right else "Top Left"  # the wearer's left is at +x
    spatial, *_ = lengths(source, SEAM)
    told = f"{side} {units.rough(longer * spatial)} longer, {how} between notches"
    assert addon.report_panel.panel.longer_sides(row.sides, units, 0.5) == [told]
    assert told in draw_panels(addon)
    assert abs(addon.core.largest_difference([row])) < 1e-6  # no unintended difference
    pieces = made(addon, addon.export.read.read_pattern(bpy.context.scene, source)).pieces
    noted = [piece.name for piece in pieces for line in piece.of_role("sew") if f"longer, {how} between" in line.note]
    assert noted == [side]


def test_the_list_of_seams_says_how_much_all_sides_give(source, addon):
    mark(source, SEAM, kind="ELASTIC", tolerance=0.03)
    bpy.ops.object.wirewarp_flatten()
    (row,) = addon.state.reports.last_report(source).tables.seams
    left, right = shares(source)
    assert left == pytest.approx(right, abs=1e-5) and 1e-4 < abs(left) <= 0.03 + 1e-6  # one length on both sides
    assert row.note.endswith(f"; {addon.words.ease_text(left)} on all sides")
