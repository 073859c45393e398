# SPDX-License-Identifier: GPL-3.0-or-later
"""The JSON report and what is kept for the panel."""

import copy
import itertools
import json
from types import SimpleNamespace

import bpy
import pytest
from everything import draw_panels
from surfaces import (
    bump,
    edge_lengths,
    edge_vertices,
    flat_of,
    grid,
    mark,
    mark_seam,
    on_line,
    read,
    select_only,
)

WIRE, SEAM = on_line(1, 0.0), on_line(0, 0.0)


def flatten_with_report(tmp_path, **settings):
    path = tmp_path / "report.json"
    bpy.ops.object.wirewarp_flatten(report_path=str(path), **settings)
    return json.loads(path.read_text(), parse_constant=lambda name: pytest.fail(f"{name} is not JSON"))


@pytest.fixture
def source():
    target = grid("Bump", bump)
    mark_seam(target, SEAM)
    mark(target, WIRE)
    return target


def length_on(target, line):
    places = [vertex.co for vertex in target.data.vertices]
    mask = [line(places[a], places[b]) for a, b in edge_vertices(target.data)]
    return edge_lengths(target)[mask].sum()


def test_the_report_states_every_length_in_blender_units_and_metres(source, tmp_path):
    bpy.context.scene.unit_settings.scale_length = 0.001
    report = flatten_with_report(tmp_path)
    assert report["units"]["meters_per_blender_unit"] == pytest.approx(0.001)
    (entry,) = report["objects"]
    assert (report["ok"], entry["ok"], entry["object"], entry["method"]) == (True, True, "Bump", "refined")
    (seam,) = entry["seams"]
    expected = length_on(source, SEAM)
    assert seam["length_3d"] == pytest.approx(expected, rel=1e-6)
    assert seam["length_3d_m"] == pytest.approx(0.001 * expected, rel=1e-6)
    assert sorted(seam["pieces"]) == [0, 1]
    assert seam["length_2d"] == pytest.approx([seam["length_3d"]] * 2, rel=1e-9)
    assert seam["mismatch"] < 1e-9
    (wire,) = entry["wires"]
    assert wire["name"] == "Wire 1"
    assert wire["length_2d"][0] == pytest.approx(length_on(source, WIRE), rel=1e-6)
    assert [len(piece["wires"]) for piece in entry["pieces"]] == [1, 1]
    # Every piece's outline: its side of the seam and one open stretch.
    assert [sorted(chain["seam"] is None for chain in piece["outline"]) for piece in entry["pieces"]] == [
        [False, True],
        [False, True],
    ]


def test_tolerances_that_the_method_does_not_use_are_said(source, addon, tmp_path):
    mark(source, WIRE, kind="SUPER_ELASTIC")
    (entry,) = flatten_with_report(tmp_path, method="WIREWARPING")["objects"]
    assert entry["method"] == "wirewarping"
    text = "This method keeps every wire rigid, so tolerances were not used."
    assert entry["notes"] == [{"text": text, "is_warning": False, "piece": None}]
    assert entry["wires"][0]["length_2d"][0] == pytest.approx(entry["wires"][0]["length_3d"], rel=1e-9)
    (row,) = addon.state.reports.last_report(source).tables.wires
    assert row.note.endswith("; free, kept rigid")


def test_an_elastic_wire_at_its_limit_is_marked(source, addon, tmp_path):
    mark(source, WIRE, kind="ELASTIC", tolerance=0.001)
    (entry,) = flatten_with_report(tmp_path)["objects"]
    parts = [part for piece in entry["pieces"] for part in piece["wires"]]
    assert [part["at_limit"] for part in (*parts, *entry["wires"])] == [True, True, True]
    assert [part["tolerance"] for part in parts] == [0.001, 0.001]
    assert [abs(part["percent"][0]) for part in parts] == pytest.approx([0.1, 0.1], abs=1e-4)
    (row,) = addon.state.reports.last_report(source).tables.wires
    assert (row.ok, row.at_limit) == (True, True)
    assert row.note.endswith("; at its limit of ±0.1%")


@pytest.mark.parametrize(
    ("kind", "tolerance", "text"),
    [("ELASTIC", 0.5, "within ±50%"), ("SUPER_ELASTIC", 0.03, "free"), ("RIGID", 0, None)],
)
def test_a_wire_short_of_its_limit_is_not_marked(source, addon, tmp_path, kind, tolerance, text):
    mark(source, WIRE, kind=kind, tolerance=tolerance)
    (entry,) = flatten_with_report(tmp_path)["objects"]
    assert entry["ok"]
    assert not [hint for hint in entry["hints"] if hint["code"] == "wire_at_limit"]
    (row,) = addon.state.reports.last_report(source).tables.wires
    assert (row.ok, row.at_limit) == (True, False)
    assert row.note.split("; ")[1:] == ([text] if text else [])


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
        assert counts == sorted(counts, reverse=True)
        assert (counts[0] > 5, counts[-1]) == (True, 1)


def test_a_cancelled_piece_that_keeps_its_lengths_says_so(addon):
    target = grid("Bump", bump)
    arrays = addon.state.read_model.object_to_arrays(target, addon.state.marked_mesh.marked_mesh(target), None)
    identities = [addon.solve.identity.PieceIdentity(1, "Top")]
    choices = addon.state.settings.choices_of(bpy.context.scene.wirewarp, 1.0)

    library = addon.core.library()

    def report_of_run(steps):
        left = iter(range(steps, 0, -1))

        def start(*what, **options):
            """A job that is done, cancelled when its shape has taken so many steps."""
            stops = lambda stage, _: stage != "shape" or next(left, 0) > 0  # noqa: E731
            result = library.flatten(*what, progress=stops, **options)
            return SimpleNamespace(is_done=lambda: True, cancel=lambda: None, result=lambda: result)

        stopping = SimpleNamespace(**vars(library) | {"start": start})
        result = addon.solve.steps.in_one_go(addon.solve.flatten.flatten_arrays(stopping, arrays, choices))
        facts = addon.solve.report.Facts(object="Top", mesh="Top", with_modifiers=False, shaped_by=[], counts={})
        return addon.solve.report.object_report(result, arrays, facts, identities, [], 1.0)

    first, last = report_of_run(0), report_of_run(1_000_000)
    assert not first.ok
    assert "Canceled before the piece was flat" in first.issues[0].sentence
    assert (last.ok, last.notes) == (True, [])
    stopped = next(report for report in map(report_of_run, itertools.count()) if report.ok)
    assert stopped.pieces[0].termination == "cancelled"
    text = "Top: Canceled: the lengths are exact, but the shape could be less distorted."
    assert [(addon.core.note_text(stopped, note), note.is_warning) for note in stopped.notes] == [(text, True)]


def test_what_is_only_good_to_know_is_no_warning(addon, source):
    """In the message after a run; what may be wrong with the pieces is."""
    bpy.ops.object.wirewarp_flatten()
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    report = addon.state.reports.last_report(source)
    (note,) = report.notes
    assert "from an earlier run without Modifiers" in note.text
    level, text = addon.solve.report.run_message([report])
    assert level == "INFO" and text.endswith(note.text)
    report.notes = [addon.core.Note(note.text, is_warning=True)]
    assert addon.solve.report.run_message([report]) == ("WARNING", text)


def test_the_method_and_the_settings_reach_the_core(source, tmp_path):
    def piece(**settings):
        return flatten_with_report(tmp_path, **settings)["objects"][0]["pieces"][0]

    by_length = piece(method="WIREWARP_PLUS_PLUS", node_weight="LENGTH")
    assert by_length["arap_energy"] != piece(method="WIREWARP_PLUS_PLUS", node_weight="UNIFORM")["arap_energy"]
    assert piece()["arap_energy"] < by_length["arap_energy"]  # what the refined method is for
    options = flatten_with_report(tmp_path, fairness=0.25)["objects"][0]["options"]
    assert (options["method"], options["fairness"]) == ("refined", 0.25)
    rough, smooth = piece(fairness=0.02), piece(fairness=1.0)
    assert rough["arap_energy"] < smooth["arap_energy"]
    assert rough["angle_deviation_rms"] > smooth["angle_deviation_rms"]


def test_the_report_is_saved_with_the_object(source, addon, tmp_path):
    bpy.ops.object.wirewarp_flatten()
    before = addon.state.reports.last_report(source)
    assert before.ok
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "flat.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "flat.blend"))
    assert addon.state.reports.last_report(bpy.data.objects["Bump"]) == before
    assert bpy.data.objects["Bump Flat"].wirewarp_source == bpy.data.objects["Bump"]


@pytest.mark.parametrize("stored", ["{", "[]", '{"schema": "older"}', 7])
def test_a_stored_report_that_cannot_be_read_is_a_sentence(source, addon, stored):
    source["wirewarp_report"] = stored
    report = addon.state.reports.last_report(source)
    assert not report.ok
    assert "Flatten again" in report.issues[0].sentence
    assert bpy.ops.mesh.wirewarp_select_issues() == {"CANCELLED"}


@pytest.mark.parametrize(
    ("system", "unit", "scale", "length", "area"),
    [
        ("METRIC", "MILLIMETERS", 1.0, "571.23 mm", "5712.3 cm²"),
        ("METRIC", "CENTIMETERS", 0.1, "5.712 cm", "57.1 cm²"),
        ("METRIC", "METERS", 1.0, "571.23 mm", "5712.3 cm²"),
        ("IMPERIAL", "FEET", 1.0, "22.489 in", "885.41 in²"),
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


def test_without_a_report_file_nothing_is_written_to_disk(source, tmp_path):
    bpy.ops.object.wirewarp_flatten()
    assert list(tmp_path.iterdir()) == []
    assert sum(read(source.data.edges, "use_seam", bool)) == 8


def test_joined_wires_have_the_names_they_had_in_the_report_and_in_the_list(source, addon):
    source.data.wirewarp_names[0].name = "Bust"
    other, third = grid("Other", bump), grid("Third", bump)
    for target, name in ((other, "Hip"), (third, "Bust")):
        mark(target, WIRE)
        target.data.wirewarp_names[0].name = name
    select_only(source, other, third)
    bpy.ops.object.join()  # keeps the names of the first mesh only
    bpy.ops.object.wirewarp_flatten()
    wires = [wire.name for wire in addon.state.reports.last_report(source).wires]
    assert wires == [entry.name for entry in source.data.wirewarp_names]
    assert sorted(wires) == ["Bust", "Bust (2)", "Hip"]


def test_the_report_says_what_stood_upright(source, tmp_path):
    """Without a grain wire that is what is up, whatever was asked for."""

    def upright(**settings):
        return flatten_with_report(tmp_path, **settings)["objects"][0]["options"]["orientation"]

    assert upright(orientation="WIRE") == "up"
    assert upright(orientation="BOUNDARY") == "boundary"
    source.data.wirewarp_grain = source.data.wirewarp_names[0].wire_id
    assert upright(orientation="WIRE") == "wire"


def test_the_report_follows_the_names_of_wires(addon):
    """In tables, in advice and on the flat pieces; swapped names too."""
    source = grid("Bump", bump)
    for line, tolerance in ((0.0, 0.001), (0.5, 0.002)):
        mark(source, on_line(1, line), kind="ELASTIC", tolerance=tolerance)
    bpy.ops.object.wirewarp_flatten()
    before = copy.deepcopy(addon.state.reports.last_report(source))
    for entry in source.data.wirewarp_names:
        entry.name = {"Wire 1": "Wire 2", "Wire 2": "Hip \\1"}[entry.name]
    report = addon.state.reports.last_report(source)

    def swapped(text):
        return text.replace("Wire 2", "Hip \\1").replace("Wire 1", "Wire 2")

    assert [wire.name for wire in report.wires] == [swapped(wire.name) for wire in before.wires]
    parts = [part.name for part in report.pieces[0].wires]
    assert parts == [swapped(part.name) for part in before.pieces[0].wires]
    told = [addon.core.hint_text(report, hint) for hint in report.hints]
    assert told == [swapped(addon.core.hint_text(before, hint)) for hint in before.hints]
    assert [hint.code for hint in before.hints].count("wire_at_limit") == 2
    words = draw_panels(addon)
    assert "Hip \\1" in words and "Wire 1" not in words
    select_only(flat_of(source))
    drawn = addon.overlay.objects.marked_lines(flat_of(source), bpy.context.evaluated_depsgraph_get())
    assert sorted(name.texts[-1] for name in drawn.names) == ["Bump", "Hip \\1 ±0.2%", "Wire 2 ±0.1%"]


def test_two_wires_renamed_alike_stay_apart(addon, source):
    mark(source, on_line(0, 0.5))
    bpy.ops.object.wirewarp_flatten()
    for entry in source.data.wirewarp_names:
        entry.name = "Waist"
    names = [wire.name for wire in addon.state.reports.last_report(source).wires]
    assert names == ["Waist", "Waist (2)"]
