# SPDX-License-Identifier: GPL-3.0-or-later
"""The JSON report and the stored report have correct data, and the panel shows them."""

import csv
import io
import itertools
import json
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from everything import draw_panels, sidebar
from flattening import edge_lengths, edge_vertices, fails, flatten_fails, flattened, notify, raise_vertex, report_after
from surfaces import bump, flat_of, grid, mark, on_line
from view_context import marked_lines

WIRE, SEAM = on_line(1, 0.0), on_line(0, 0.0)


def flatten_with_report(tmp_path, **settings):
    path = tmp_path / "report.json"
    bpy.ops.object.wirewarp_flatten(report_path=str(path), **settings)
    return json.loads(path.read_text(), parse_constant=lambda name: pytest.fail(f"{name} is not JSON"))


@pytest.fixture
def source():
    return grid("Bump", bump, seam=SEAM, wire=WIRE)


def length_on(target, line):
    places = [vertex.co for vertex in target.data.vertices]
    mask = [line(places[a], places[b]) for a, b in edge_vertices(target.data)]
    return edge_lengths(target)[mask].sum()


def test_the_report_states_lengths_in_blender_units_and_meters(source, tmp_path):
    bpy.context.scene.unit_settings.scale_length = 0.001
    report = flatten_with_report(tmp_path)
    assert report["units"]["meters_per_blender_unit"] == pytest.approx(0.001)
    (entry,) = report["objects"]
    assert (report["ok"], entry["ok"], entry["object"], entry["method"]) == (True, True, "Bump", "refined")
    (seam,), (wire,) = entry["seams"], entry["wires"]
    expected = length_on(source, SEAM)
    assert (seam["length_3d"], seam["length_3d_m"]) == pytest.approx((expected, 0.001 * expected), rel=1e-6)
    assert sorted(seam["pieces"]) == [0, 1] and seam["mismatch"] < 1e-9
    assert wire["name"] == "Wire 1"
    assert wire["length_2d"][0] == pytest.approx(length_on(source, WIRE), rel=1e-6)
    for piece in entry["pieces"]:
        assert len(piece["wires"]) == 1
        assert sorted(chain["seam"] is None for chain in piece["outline"]) == [False, True]


@pytest.mark.parametrize(
    ("kind", "tolerance", "method", "note"),
    [
        ("RIGID", 0, "REFINED", ""),
        ("SUPER_ELASTIC", 0.03, "REFINED", "; free"),
        ("SUPER_ELASTIC", 0.03, "WIREWARPING", "; free, kept rigid"),
        ("ELASTIC", 0.5, "REFINED", "; within ±50%"),
        ("ELASTIC", 0.001, "REFINED", "; at its limit of ±0.1%"),
    ],
)
def test_the_row_of_a_wire_shows_the_use_of_its_tolerance(source, addon, kind, tolerance, method, note):
    mark(source, WIRE, kind=kind, tolerance=tolerance)
    report = report_after(addon, source, method=method)
    (row,) = report.tables.wires
    assert row.note == f"Top Right, Top Left{note}"
    is_at_limit = "limit" in note
    assert (report.ok, row.ok, row.at_limit) == (True, True, is_at_limit)
    assert [hint.code for hint in report.hints].count("wire_at_limit") == is_at_limit
    assert [part.at_limit for piece in report.pieces for part in piece.wires] == [is_at_limit] * 2


def test_a_sentence_is_broken_where_it_fills_the_sidebar(addon):
    text = "Front keeps its lengths, but the fabric must stretch up to 65%. Add a dart or seam there."
    styles = bpy.context.preferences.ui_styles
    for scale in (1.0, 2.0):
        preferences = SimpleNamespace(system=SimpleNamespace(ui_scale=scale), ui_styles=styles)
        counts = []
        for width in range(150, 800, 5):
            context = SimpleNamespace(region=SimpleNamespace(width=width * scale), preferences=preferences)
            lines = addon.ui.layout.broken(context, text)
            assert " ".join(lines) == text
            counts.append(len(lines))
        assert counts == sorted(counts, reverse=True) and (counts[0] > 5, counts[-1]) == (True, 1)


def test_a_canceled_piece_with_exact_lengths_reports_it(addon, monkeypatch):
    target = grid("Bump", bump)
    arrays = addon.state.read_model.object_to_arrays(target, addon.state.marked_mesh.marked_mesh(target), None)
    identities = [addon.solve.identity.PieceIdentity(1, "Top")]
    choices = addon.state.settings.choices_of(bpy.context.scene.wirewarp, 1.0)

    library = addon.core.library()

    def report_of_run(steps):
        left = iter(range(steps, 0, -1))

        def start(*what, **options):
            """Return a finished job, which was canceled after `steps` reports of the stage "shape"."""
            stops = lambda stage, _: stage != "shape" or next(left, 0) > 0  # noqa: E731
            result = library.flatten(*what, progress=stops, **options)
            return SimpleNamespace(is_done=lambda: True, cancel=lambda: None, result=lambda: result)

        monkeypatch.setattr(addon.solve.flatten, "start", start)
        result = addon.solve.steps.in_one_go(addon.solve.flatten.flatten_arrays(arrays, choices))
        facts = addon.solve.report.Facts(object="Top", mesh="Top", with_modifiers=False, shaped_by=[], counts={})
        return addon.solve.report.object_report(result, arrays, facts, identities, [], 1.0)

    first, last = report_of_run(0), report_of_run(1_000_000)
    assert not first.ok and "Canceled before the piece was flat" in first.issues[0].sentence
    assert (last.ok, last.notes) == (True, [])
    stopped = next(report for report in map(report_of_run, itertools.count()) if report.ok)
    assert stopped.pieces[0].termination == "cancelled"
    text = "Top: Canceled: the lengths are exact, but the shape could be less distorted."
    assert [(addon.core.note_text(stopped, note), note.is_warning) for note in stopped.notes] == [(text, True)]


def test_notes_are_not_warnings(addon, source):
    """The message after a run contains its notes. It is a warning only if one of the notes is a warning."""
    bpy.ops.object.wirewarp_flatten()
    report = report_after(addon, source, use_modifiers=True)
    (note,) = report.notes
    assert "from an earlier run without Modifiers" in note.text
    level, text = addon.solve.report.run_message([report], {})
    assert level == "INFO" and text.endswith(note.text)
    report.notes = [addon.core.Note(note.text, is_warning=True)]
    assert addon.solve.report.run_message([report], {}) == ("WARNING", text)


def test_the_method_and_the_settings_reach_the_core(source, tmp_path):
    def piece(**settings):
        return flatten_with_report(tmp_path, **settings)["objects"][0]["pieces"][0]

    by_length = piece(method="WIREWARP_PLUS_PLUS", node_weight="LENGTH")
    assert by_length["arap_energy"] != piece(method="WIREWARP_PLUS_PLUS", node_weight="UNIFORM")["arap_energy"]
    assert piece()["arap_energy"] < by_length["arap_energy"]
    options = flatten_with_report(tmp_path, fairness=0.25)["objects"][0]["options"]
    assert (options["method"], options["fairness"]) == ("refined", 0.25)
    rough, smooth = piece(fairness=0.02), piece(fairness=1.0)
    assert rough["arap_energy"] < smooth["arap_energy"]
    assert rough["angle_deviation_rms"] > smooth["angle_deviation_rms"]


def test_the_report_is_saved_with_the_object(source, addon, tmp_path):
    before = report_after(addon, source)
    assert before.ok
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "flat.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "flat.blend"))
    assert addon.state.reports.last_report(bpy.data.objects["Bump"]) == before
    assert bpy.data.objects["Bump Flat"].wirewarp_source == bpy.data.objects["Bump"]


@pytest.mark.parametrize(
    ("system", "unit", "scale", "length", "area"),
    [
        ("METRIC", "MILLIMETERS", 1.0, "571.23 mm", "5712.3 cm²"),
        ("METRIC", "CENTIMETERS", 0.1, "5.712 cm", "57.1 cm²"),
        ("METRIC", "METERS", 1.0, "571.23 mm", "5712.3 cm²"),
        ("IMPERIAL", "INCHES", 1.0, "22.489 in", "885.41 in²"),
        ("NONE", None, 1.0, "0.5712", "0.5712"),
    ],
)
def test_lengths_and_areas_are_shown_in_the_scenes_units(addon, system, unit, scale, length, area):
    settings = bpy.context.scene.unit_settings
    settings.system, settings.scale_length = system, scale
    if unit:
        settings.length_unit = unit
    text = addon.blender.objects.length_text(bpy.context.scene)
    assert (text(0.57123), text.area(0.57123)) == (length, area)


def test_the_report_names_the_upright_direction(source, tmp_path):
    def upright(**settings):
        return flatten_with_report(tmp_path, **settings)["objects"][0]["options"]["orientation"]

    assert upright(orientation="WIRE") == "up"  # because there is no grain wire
    assert upright(orientation="BOUNDARY") == "boundary"
    source.data.wirewarp_grain = source.data.wirewarp_names[0].wire_id
    assert upright(orientation="WIRE") == "grain"


def test_the_report_follows_the_names_of_wires(addon):
    source = grid("Bump", bump)
    for line, tolerance in ((0.0, 0.001), (0.5, 0.002)):
        mark(source, on_line(1, line), kind="ELASTIC", tolerance=tolerance)
    bpy.ops.object.wirewarp_flatten()

    def names():
        report = addon.state.reports.last_report(source)
        assert [part.name for part in report.pieces[0].wires] == [wire.name for wire in report.wires]
        hints = [hint for hint in report.hints if hint.code == "wire_at_limit"]
        assert all(len(hint.edges) == 8 for hint in hints)
        return [addon.core.hint_text(report, hint) for hint in hints]

    assert names() == ['"Wire 2" ±0.2%', '"Wire 1" ±0.1%']  # The largest change is first.
    for entry in source.data.wirewarp_names:  # Wire 1 gets the name that Wire 2 had.
        entry.name = {"Wire 1": "Wire 2", "Wire 2": "Hip \\1"}[entry.name]
    assert names() == ['"Hip \\1" ±0.2%', '"Wire 2" ±0.1%']
    words = draw_panels(addon)
    assert "Hip \\1" in words and "Wire 1" not in words
    drawn = [name.texts[-1] for name in marked_lines(addon, flat_of(source)).names]
    assert sorted(drawn) == ["Bump", "Hip \\1 ±0.2%", "Wire 2 ±0.1%"]
    for entry in source.data.wirewarp_names:
        entry.name = "Waist"
    assert [wire.name for wire in addon.state.reports.last_report(source).wires] == ["Waist", "Waist (2)"]


def test_the_report_is_parsed_and_its_rows_are_made_once(addon, source):
    report = report_after(addon, source)
    tables = report.tables
    assert addon.state.reports.last_report(source) is report and report.tables is tables
    assert [side.label for side in tables.seams[0].sides] == ["Top Right", "Top Left"]
    report.pieces[0].name = "Front"
    assert report.tables.seams[0].note == "Front – Top Left"


def test_the_table_for_spreadsheets_is_in_the_scenes_units(addon, source, capfd):
    settings = bpy.context.scene.unit_settings
    fails(bpy.ops.object.wirewarp_copy_report, '"Bump" has not been flattened yet')
    settings.system, settings.length_unit, settings.scale_length = "METRIC", "CENTIMETERS", 0.1
    report = report_after(addon, source)
    text = addon.core.report_csv(report, addon.blender.objects.length_text(bpy.context.scene))
    lines = list(csv.DictReader(io.StringIO(text)))
    assert [line["Kind"] for line in lines] == ["Seam", "Seam", "Wire", "Open edge", "Open edge", "Piece", "Piece"]
    assert lines[0]["Name"] == "Seam 1: Top Right – Top Left"
    assert float(lines[0]["Length on model (cm)"]) == pytest.approx(10 * report.seams[0].length_3d, rel=1e-6)
    assert float(lines[-1]["Area on model (cm²)"]) == pytest.approx(100 * report.pieces[1].area_3d, rel=1e-6)
    bpy.ops.object.wirewarp_copy_report()
    assert "7 lines copied\n" in capfd.readouterr().out
    raise_vertex(source)
    bpy.ops.object.wirewarp_copy_report()
    assert '7 lines copied. "Bump" has changed since' in capfd.readouterr().out


def test_the_list_of_pieces_has_the_worst_first(addon):
    source = flattened("Bump", bump, seam=on_line(0, 0.5))
    listed = bpy.types.WIREWARP_UL_pieces
    this = SimpleNamespace(filter_name="", bitflag_filter_item=1 << 30, use_filter_sort_alpha=False)
    shown, places = listed.filter_items(this, bpy.context, source, "wirewarp_pieces")
    strains = [p.needed for p in addon.state.reports.last_report(source).pieces]
    assert shown == [] and sorted(places) == [0, 1] and places.index(0) == np.argmax(strains)
    this.use_filter_sort_alpha = True
    source.wirewarp_pieces[0].name, source.wirewarp_pieces[1].name = "b", "A"
    assert listed.filter_items(this, bpy.context, source, "wirewarp_pieces") == ([], [1, 0])
    this.use_filter_sort_alpha = False
    source.wirewarp_pieces.add()  # The list is not sorted, because this entry is not in the report.
    assert listed.filter_items(this, bpy.context, source, "wirewarp_pieces") == ([], [])


class MarkedRow:
    """A layout that records which names in a list have a mark."""

    def __init__(self):
        self.marks = []

    def __getattr__(self, _name):
        return lambda *_, **__: self

    def prop(self, _owner, name, **how):
        if name == "name":
            self.marks.append("icon_value" in how)


def has_marks(source, addon):
    """Return for each entry of the list of pieces whether it is drawn with a tick or a warning."""
    addon.state.drawings.forget()
    row, listed = MarkedRow(), bpy.types.WIREWARP_UL_pieces
    for index, entry in enumerate(source.wirewarp_pieces):
        listed.draw_item(None, sidebar(), row, source, entry, 0, source, "", index)
    return row.marks


def test_the_list_of_pieces_has_marks_only_while_the_verdict_is_about_them(addon):
    source, settings = grid("Bump", bump, seam=on_line(0, 0.5)), bpy.context.scene.wirewarp
    bpy.ops.object.wirewarp_flatten()
    for settings.cloth, marked in (("NONE", True), ("JERSEY", False), ("NONE", True)):
        assert has_marks(source, addon) == [marked, marked]
    place = source.data.vertices[0].co.copy()
    raise_vertex(source, 1.0, vertex=0)
    assert has_marks(source, addon) == [False, False]
    source.data.vertices[0].co.x = float("nan")
    flatten_fails("not numbers, or far")
    source.data.vertices[0].co = place
    notify(source)
    assert not addon.state.reports.seems_changed(source, addon.state.reports.pieces_report(source))
    assert has_marks(source, addon) == [False, False]  # because the last run failed
