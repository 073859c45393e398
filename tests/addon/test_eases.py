# SPDX-License-Identifier: GPL-3.0-or-later
"""Eases of seams, outlines and wires are marked, flattened, cleared again, and reported with their lengths."""

import csv
import io

import bpy
import numpy as np
import pytest
from everything import draw_panels
from flattening import fails, flatten_fails, report_after
from surfaces import everywhere, flat_of, grid, mark, mark_seam, on_edges, on_line, read, select_edges, select_only
from two_sided import HEM, SEAM, ease, lengths, made, select_side, shares, two_pieces
from view_context import marked_lines


@pytest.fixture
def source():
    return two_pieces()


def test_all_sides_of_a_seam_are_eased_alike_in_percent_or_millimeters(source):
    ease(source, SEAM, sides="ALL", ease_percent=-4.0)
    bpy.ops.object.wirewarp_flatten()
    assert shares(source) == pytest.approx([-0.04, -0.04], abs=1e-5)
    ease(source, SEAM, sides="ALL", ease_unit="LENGTH", ease_length=12.0)
    bpy.ops.object.wirewarp_flatten()
    spatial, left, right = lengths(source, SEAM)
    assert [100 * (left - spatial), 100 * (right - spatial)] == pytest.approx([12.0, 12.0], abs=1e-3)


def test_clearing_removes_every_ease(source):
    ease(source, SEAM, sides="ALL", ease_percent=2.0)
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    ease(source, SEAM, sides="NONE")
    bpy.ops.object.wirewarp_flatten()
    assert shares(source) == pytest.approx([0.0, 0.0], abs=1e-5)
    select_edges(source, SEAM)
    fails(bpy.ops.mesh.wirewarp_ease, "none of the selected edges has an ease", sides="NONE")


def test_clearing_a_wire_removes_its_ease(source):
    ease(source, SEAM, sides="ALL", ease_percent=2.0)
    mark(source, SEAM, kind="ELASTIC", tolerance=0.01)
    assert set(read(source.data.attributes["wirewarp_ease"].data, "value", np.float32)) == {0, np.float32(0.02)}
    select_edges(source, SEAM)
    bpy.ops.mesh.wirewarp_clear()
    mark(source, SEAM)
    assert not read(source.data.attributes["wirewarp_ease"].data, "value", np.float32).any()


def test_marking_a_part_of_an_eased_line_keeps_the_ease(source, capfd):
    def upper_half(a, b):
        return SEAM(a, b) and a[1] + b[1] > 0

    ease(source, SEAM, sides="ALL", ease_percent=2.0)
    mark(source, upper_half, kind="ELASTIC", tolerance=0.01)
    eases = read(source.data.attributes["wirewarp_ease"].data, "value", np.float32)
    assert np.count_nonzero(eases == np.float32(0.02)) == 8
    assert "several eases" not in capfd.readouterr().out
    ease(source, upper_half, sides="ALL", ease_percent=5.0)
    mark(source, SEAM)
    assert "1 wire marked. 1 wire had several eases, which were removed. Mark the ease again." in capfd.readouterr().out
    assert not read(source.data.attributes["wirewarp_ease"].data, "value", np.float32).any()


def test_the_list_of_wires_changes_an_ease_and_keeps_it(source, addon):
    ease(source, SEAM, sides="ALL", ease_percent=2.0)
    ((name, wire),) = addon.state.identities.listed_wires(source)
    bpy.ops.mesh.wirewarp_change_wire(edge=wire.edges[0], name=name, kind="ELASTIC", tolerance=0.01)
    ((_, kept),) = addon.state.identities.listed_wires(source)
    assert (kept.tolerance, kept.ease) == (0.01, 0.02)
    bpy.ops.mesh.wirewarp_change_wire(edge=wire.edges[0], kind="RIGID", ease=-0.05)
    ((_, changed),) = addon.state.identities.listed_wires(source)
    assert (changed.tolerance, changed.ease) == (0, -0.05)


def test_an_ease_of_edges_without_a_wire_is_reported(source, addon):
    values = source.data.attributes.new("wirewarp_ease", "FLOAT", "EDGE")
    for edge in source.data.edges[:3]:
        values.data[edge.index].value = 0.05
    bpy.ops.object.wirewarp_flatten()
    text = "3 edges have an ease but are not wires, so the ease was not used. Select them and press All Sides."
    assert addon.core.Note(text, is_warning=True) in addon.state.reports.last_report(source).notes
    ease(source, everywhere, sides="NONE")
    assert report_after(addon, source).notes == []


@pytest.mark.parametrize("sides", ["ALL", "ONE"])
def test_neither_of_two_objects_is_marked_if_one_is_refused(source, sides):
    small = grid("Small", lambda x, y: (0.05 * x + 3, 0.05 * y, 0), size=1)  # an outline of 40 mm
    large = grid("Large", lambda x, y: (x + 6, y, 0), size=1)  # an outline of 800 mm
    for targets in ((large, small), (small, large)):
        select_only(*targets)
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.context.tool_settings.mesh_select_mode = (False, True, False)
        bpy.ops.mesh.select_all(action="SELECT")
        fails(bpy.ops.mesh.wirewarp_ease, "has no length left", sides=sides, ease_unit="LENGTH", ease_length=-50.0)
        bpy.ops.object.mode_set(mode="OBJECT")
        assert not any(name.startswith("wirewarp") for target in targets for name, _ in target.data.attributes.items())


def test_edges_without_a_side_are_left_out_and_counted(source, capfd):
    select_edges(source, SEAM, on_line(1, 0.0))
    assert bpy.ops.mesh.wirewarp_ease(sides="ONE", ease_percent=5.0) == {"FINISHED"}
    assert "1 line eased: +5%" in (text := capfd.readouterr().out) and "8 selected edges were left out" in text
    bpy.ops.object.mode_set(mode="OBJECT")
    select_edges(source, on_line(1, 0.0))
    fails(bpy.ops.mesh.wirewarp_ease, "select edges of a seam or outline", sides="ONE", ease_percent=5.0)


def test_one_side_is_the_side_of_the_smaller_piece_on_all_seams(addon):
    source = grid("Body and two sleeves", lambda x, y: (x, y, 0))
    seams = {x: on_line(0, x) for x in (-0.5, 0.5)}
    for seam in seams.values():
        mark_seam(source, seam)
    ease(source, lambda a, b: any(seam(a, b) for seam in seams.values()), sides="ONE", ease_percent=5.0)
    # The directions of the edges differ between the two seams, and must not matter.
    eased = np.flatnonzero(addon.state.allowances.SIDE_EASES.read(source.data))
    faces = np.repeat(np.arange(len(source.data.polygons)), [len(face.loop_indices) for face in source.data.polygons])
    middles = [source.data.polygons[face].center.x for face in faces[eased]]
    assert len(eased) == 16 and min(map(abs, middles)) > 0.5 and min(middles) < 0 < max(middles)


def test_millimeters_of_a_side_refer_to_its_uneased_length(source):
    ease(source, SEAM, sides="ALL", ease_percent=-10.0)
    ease(source, SEAM, sides="ONE", ease_unit="LENGTH", ease_length=12.0)
    bpy.ops.object.wirewarp_flatten()
    _, left, right = lengths(source, SEAM)
    assert 100 * abs(left - right) == pytest.approx(12.0, abs=1e-3)
    assert min(shares(source)) == pytest.approx(-0.1, abs=1e-5)


def test_a_line_with_both_sides_cleared_on_flat_pieces_counts_once(source, capfd):
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    bpy.ops.object.wirewarp_flatten()
    select_side(source, 0)
    assert bpy.ops.mesh.wirewarp_ease(sides="NONE") == {"FINISHED"}
    assert "Ease cleared on 1 line\n" in capfd.readouterr().out


def test_an_ease_of_one_side_at_a_mirror_is_unknown_until_it_is_marked_again(addon):
    """The side of an ease is a face. The modifier copies this face to the other side of the mirror plane."""
    half = grid("Half", lambda x, y: (x + 1, y, 0), seam=SEAM)
    half.modifiers.new("Mirror", "MIRROR")
    ease(half, SEAM, sides="ONE", ease_percent=5.0)
    flatten_fails("8 edges .*copied.*Apply the modifiers and mark the ease again, or mark", use_modifiers=True)
    (issue,) = addon.state.reports.last_report(half).issues
    assert (issue.code, len(issue.edges)) == ("side_unknown", 8)
    ease(half, SEAM, sides="NONE")
    ease(half, SEAM, sides="ALL", ease_percent=5.0)
    assert bpy.ops.object.wirewarp_flatten(use_modifiers=True) == {"FINISHED"}
    ease(half, SEAM, sides="ALL", ease_percent=0.0)
    ease(half, SEAM, sides="ONE", ease_percent=5.0)
    bpy.ops.object.modifier_apply(modifier="Mirror")
    flatten_fails('The side of the ease is unknown on 8 edges of "Half", because faces')
    (issue,) = addon.state.reports.last_report(half).issues
    assert len(issue.edges) == 8
    ease(half, SEAM, sides="ONE", ease_percent=5.0)
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert sorted(shares(half)) == pytest.approx([0.0, 0.05], abs=1e-5)


def test_an_ease_without_a_side_names_its_edges(source, addon):
    ease(source, SEAM, sides="ONE", ease_percent=5.0)
    on_edges(source, bpy.ops.mesh.mark_seam, lambda a, b: SEAM(a, b) and a.y + b.y > 1, clear=True)
    flatten_fails("An ease names")
    (issue,) = addon.state.reports.last_report(source).issues
    assert (issue.code, len(issue.edges)) == ("ease_without_side", 2)


def arrow(addon, target):
    """Return the tail and the tip of the arrow of an ease, and the texts of all names."""
    lines = marked_lines(addon, target)
    tail, tip, *_ = lines.places["ease"]
    return tail, tip, [name.texts for name in lines.names]


def test_one_side_or_the_other_is_eased_and_an_arrow_points_into_it(source, addon):
    eased = {}
    for sides in ("ONE", "OTHER"):
        ease(source, SEAM, sides=sides, ease_percent=5.0)
        bpy.ops.object.wirewarp_flatten()
        left, right = eased[sides] = shares(source)
        tail, tip, texts = arrow(addon, source)
        assert tail[0] == pytest.approx(0.0, abs=1e-6) and (tip[0] > 0) == (right > left)
        assert ("+5%",) in texts
        *_, texts = arrow(addon, flat_of(source))
        assert ("+5%",) in texts
    assert sorted(eased["ONE"]) == pytest.approx([0.0, 0.05], abs=1e-5)
    assert eased["OTHER"] == pytest.approx(eased["ONE"][::-1], abs=1e-5)
    ease(source, SEAM, sides="NONE")
    assert "ease" not in marked_lines(addon, source).places


@pytest.mark.parametrize(
    ("side", "sides", "said"),
    [
        (0, "ONE", "Both sides of a seam are selected"),
        (-1, "ALL", "only the selected side can be eased"),
        (-1, "OTHER", "only the selected side can be eased"),
    ],
)
def test_on_flat_pieces_only_one_side_that_is_selected_is_eased(source, side, sides, said):
    bpy.ops.object.wirewarp_flatten()
    select_side(source, side)
    fails(bpy.ops.mesh.wirewarp_ease, said, sides=sides, ease_percent=5.0)
    assert "wirewarp_side_ratio" not in source.data.attributes


@pytest.mark.parametrize(
    ("name", "domain", "value", "said"),
    [
        ("wirewarp_ease", "EDGE", -1.0, 'Wire "Wire 1" has an invalid ease'),
        ("wirewarp_ease", "EDGE", float("nan"), 'Wire "Wire 1" has an invalid ease'),
        ("wirewarp_side_ease", "CORNER", -1.0, "ease of one side is invalid along 8 edges"),
        ("wirewarp_side_ease", "CORNER", float("inf"), "ease of one side is invalid along 8 edges"),
    ],
)
def test_an_impossible_ease_names_its_wire_or_its_edges(source, addon, name, domain, value, said):
    mark(source, HEM)
    values = source.data.attributes.new(name, "FLOAT", domain).data
    edges = read(source.data.loops, "edge_index", np.int32) if domain == "CORNER" else range(len(values))
    for row, edge in enumerate(edges):
        if HEM(*(source.data.vertices[vertex].co for vertex in source.data.edges[edge].vertices)):
            values[row].value = value
    flatten_fails(said)
    (issue,) = addon.state.reports.last_report(source).issues
    assert len(issue.edges) == 8


def eases_of(addon, report, kind):
    """Return the intended eases of the lines of this kind in the table for spreadsheets, in percent."""
    text = addon.core.report_csv(report, addon.blender.objects.length_text(bpy.context.scene))
    lines = csv.DictReader(io.StringIO(text))
    return [float(line["Asked ease (%)"]) for line in lines if line["Kind"] == kind]


def test_an_eased_outline_has_its_target_length(source, addon):
    ease(source, HEM, sides="ONE", ease_percent=5.0)
    report = report_after(addon, source)
    places = read(source.data.vertices, "co", np.float32, 3).astype(float)
    hem = [v for v in range(9) if HEM(places[v], places[v])]
    half = np.linalg.norm(np.diff(places[hem], axis=0), axis=1).sum() / 2  # length of the hem in each of the two pieces
    for name, _, chain in addon.core.open_edges(report):
        assert chain.length_asked == pytest.approx([chain.length_3d + 0.05 * half], rel=1e-6), name
    outlines = report.tables.outlines
    assert addon.core.largest_difference(outlines) < 1e-6
    asked = 100 * 0.05 * half / outlines[0].sides[0].length_3d
    assert all(row.note == f"ease +{asked:.3g}%" for row in outlines)
    assert eases_of(addon, report, "Open edge") == pytest.approx([asked, asked], rel=1e-5)


@pytest.mark.parametrize(("percent", "longer", "how"), [(5.0, 0.05, "ease"), (-40.0, 0.4, "gather")])
def test_panel_and_paper_say_which_side_is_longer_and_what_to_do(source, addon, percent, longer, how):
    settings = bpy.context.scene.unit_settings
    settings.length_unit, settings.scale_length = "MILLIMETERS", 0.5  # so that the text has room on the pattern
    ease(source, SEAM, sides="ONE", ease_percent=percent)
    (row,) = report_after(addon, source).tables.seams
    units = addon.blender.objects.length_text(bpy.context.scene)
    left, right = shares(source)
    # The wearer's left is at +x. An ease of -40% makes the eased side shorter, so that the other side is named.
    side = "Top Right" if left > right else "Top Left"
    spatial, *_ = lengths(source, SEAM)
    text = f"{side} {units.rough(longer * spatial)} longer, {how} between notches"
    assert addon.report_panel.panel.longer_sides(row.sides, units, 0.5) == [text]
    assert text in draw_panels(addon)
    assert abs(addon.core.largest_difference([row])) < 1e-6  # Intended differences do not count.
    pieces = made(addon, addon.export.read.read_pattern(bpy.context.scene, source)).pieces
    noted = [piece.name for piece in pieces for line in piece.of_role("sew") if f"longer, {how} between" in line.note]
    assert noted == [side]


def test_the_list_of_seams_shows_the_change_of_all_sides(source, addon):
    mark(source, SEAM, kind="ELASTIC", tolerance=0.03)
    (row,) = report_after(addon, source).tables.seams
    left, right = shares(source)
    assert left == pytest.approx(right, abs=1e-5) and 1e-4 < abs(left) <= 0.03 + 1e-6
    assert row.note.endswith(f"; {addon.core.ease_text(left)} on all sides")
