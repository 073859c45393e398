# SPDX-License-Identifier: GPL-3.0-or-later
"""A report can be written as JSON, as rows and as a table, and its wires can be renamed."""

import csv
import io
import json
import math
from dataclasses import replace

import numpy as np
import pytest
from reports import report_of
from samples import SAMPLES
from wirewarp import Wire, flatten
from wirewarp.report import (
    Issue,
    Kind,
    Note,
    Report,
    ReportError,
    Side,
    elements_of,
    from_dict,
    hint_text,
    issue_text,
    make_report,
    merged,
    note_text,
    rename_wires,
    report_csv,
    tables_of,
    to_dict,
    verdict,
)
from wirewarp.report.json_form import SCHEMA
from wirewarp.report.words import LengthText


@pytest.mark.core
@pytest.mark.parametrize("name", sorted(SAMPLES))
def test_a_report_survives_writing_and_reading_as_json(name):
    report = report_of(name)
    written = json.loads(json.dumps(to_dict(report), allow_nan=False))
    assert from_dict(written, Report) == report and written["schema"] == SCHEMA


def test_json_states_every_length_in_the_models_units_and_in_meters():
    written = to_dict(replace(report_of("Fitted top"), meters=0.001))
    piece, seam = written["pieces"][0], written["seams"][0]
    assert seam["length_2d_m"] == pytest.approx([0.001 * length for length in seam["length_2d"]])
    assert seam["difference"] == pytest.approx([length - seam["length_3d"] for length in seam["length_2d"]])
    assert piece["area_3d_m2"] == pytest.approx(1e-6 * piece["area_3d"])
    assert (written["ok"], written["method_name"]) == (True, "Refined")


def test_json_of_a_free_wire_and_of_a_closed_piece():
    shape = SAMPLES["Half cylinder"]
    free = [Wire(wire.vertices, math.inf, wire.name) for wire in shape.wires] or [Wire([0, 1], math.inf)]
    result = flatten(shape.vertices, shape.triangles(), wires=free)
    written = to_dict(make_report(result, shape.vertices, shape.triangles(), wires=free))
    assert {wire["tolerance"] for wire in written["wires"]} == {"inf"}
    cube = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    quads = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    faces = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    report = make_report(flatten(cube, faces), cube, faces)
    assert verdict(report).kind is Kind.CLOSED
    (piece,) = json.loads(json.dumps(to_dict(report), allow_nan=False))["pieces"]
    assert (piece["area_2d"], piece["stretch"], piece["ok"]) == (None, None, False)
    (line,) = csv.DictReader(io.StringIO(report_csv(report, LengthText("m", 1.0))))
    assert float(line["Area on model (m²)"]) == pytest.approx(6)
    figures = [line[title] for title in ("Flat area (m²)", "Stretch (%)", "Stretch across (%)", "Kept")]
    assert figures == ["", "", "", "no"]


def changed(data, path, value):
    *way, last = path
    for key in way:
        data = data[key]
    if value is None:
        del data[last]
    else:
        data[last] = value


@pytest.mark.parametrize(
    ("path", "value", "said"),
    [
        (["schema"], "wirewarp-report-4", "schema"),
        (["pieces"], None, 'has no "pieces" at report'),
        (["pieces", 0, "wires", 0, "tolerance"], "rigid", "'rigid' at report.pieces.wires.tolerance"),
        (["pieces", 0, "index"], "0", "'0' at report.pieces.index"),
        (["seams", 0, "edges"], 3, "3 at report.seams.edges"),
        (["seams", 0, "edges", 0], [1, 2, 3], "[1, 2, 3] at report.seams.edges"),
        (["pieces", 0, "ok"], 1, "1 at report.pieces.ok"),
        (["pieces", 0], [], "[] at report.pieces"),
    ],
)
def test_invalid_reports_are_refused_in_a_sentence(path, value, said):
    written = json.loads(json.dumps(to_dict(report_of("Fitted top"))))
    changed(written, path, value)
    with pytest.raises(ReportError) as caught:
        from_dict(written, Report)
    assert said in str(caught.value)
    for data in (None, [], "report"):
        with pytest.raises(ReportError):
            from_dict(data, Report)


def test_rows_are_worst_first():
    report = report_of("Fitted top")
    (sample, *_) = report.seams

    def seam(index, percent, ok=True):
        flat = None if percent is None else 1 + percent / 100
        return replace(
            sample, index=index, name=f"Seam {index + 1}", pieces=[0], ok=ok, variation=0.0,
            length_3d=1.0, length_2d=[flat], length_asked=[1.0],
        )  # fmt: skip

    report.seams = [seam(0, 0.1), seam(1, -0.5), seam(2, None, ok=False), seam(3, 1e-12), seam(4, 2e-12)]
    rows = tables_of(report).seams
    assert [row.name for row in rows] == [f"Seam {k}" for k in (3, 2, 1, 4, 5)]
    assert [row.index for row in rows] == [2, 1, 0, 3, 4]


def test_equal_sides_are_combined():
    def sides(*labels):
        return [Side(label, 1.0, 1.0, 0.0, 0.0, 1.0) for label in labels]

    same, other = ("1.00", "0.00", "0.000"), ("1.01", "+0.01", "+1.000")
    assert merged(sides("Front", "Back"), [same, same]) == [("Both sides", same)]
    assert merged(sides("Front", "Back"), [same, other]) == [("Front", same), ("Back", other)]
    assert merged(sides("Front", "Back", "Piping"), [same] * 3) == [("All 3 sides", same)]
    assert merged(sides("Flat"), [same]) == [("Flat", same)]


def test_names_in_the_table_are_not_formulas_and_stay_one_line():
    report = report_of("Fitted top")
    report.pieces[0].name, report.wires[0].name = "=1+1", 'Waist, "high"\nline'
    report.wires[0].length_2d[0] = report.wires[0].length_3d - 1e-12
    lines = list(csv.DictReader(io.StringIO(report_csv(report, LengthText("cm", 100.0)))))
    pieces = [line for line in lines if line["Kind"] == "Piece"]
    wires = [line for line in lines if line["Kind"] == "Wire"]
    assert pieces[0]["Name"] == "'=1+1"
    assert wires[0]["Name"] == 'Waist, "high"\nline'
    assert wires[0]["Difference (cm)"] == "0.000000"  # values that round to zero have no sign


def test_a_renamed_wire_renames_no_piece_and_no_object():
    """In this test, a wire, a piece and an object have the same name."""
    report = report_of("Fitted top")
    for number, wire in enumerate(report.wires, start=1):
        wire.wire_id, wire.name = number, f"Wire {number}"
    report.pieces[0].name = "Wire 1"
    report.notes = [Note('"Wire 1" is hidden.'), Note("Canceled.", True, 0)]
    report.issues = [
        Issue("infeasible", 'Wires "Wire 1" and "Wire 2" contradict.', 0, wires=[0, 1]),
        Issue("unreadable", 'The object "Wire 1" has no face.'),
        Issue("no_proposal", 'No dart helps "Wire 1": loosen wire "Wire 1" or divide it.', wires=[0]),
    ]
    names = {1: "Wire 2", 2: "Hip \\1"}  # keyed by wire_id
    rename_wires(report, names)
    assert report.wires[0].name == "Wire 2" and report.wires[1].name == "Hip \\1"
    assert [note_text(report, note) for note in report.notes] == ['"Wire 1" is hidden.', "Wire 1: Canceled."]
    assert issue_text(report, report.issues[0]) == 'Wire 1: Wires "Wire 2" and "Hip \\1" contradict.'
    assert issue_text(report, report.issues[1]) == 'The object "Wire 1" has no face.'
    assert issue_text(report, report.issues[2]) == 'No dart helps "Wire 1": loosen wire "Wire 2" or divide it.'
    parts = {part.name for piece in report.pieces for part in piece.wires if part.wire == 0}
    assert parts <= {"Wire 2"}


def test_hints_follow_the_names_of_wires():
    report = report_of("Wetsuit upper body")
    hint = next(hint for hint in report.hints if hint.code == "wire_at_limit")
    report.wires[hint.wire].name = "Hip"
    assert hint_text(report, hint) == '"Hip" ±5%'


def test_entries_know_their_elements():
    report = report_of("Fitted top")
    assert elements_of(report, "SEAM", 0).edges == report.seams[0].edges
    assert len(elements_of(report, "WIRE", 0).edges) == len(report.wires[0].vertices) - 1
    assert elements_of(report, "PIECE", 1).whole_piece
    assert elements_of(report, "STRETCH", 0).faces == report.pieces[0].stretch_faces
    assert elements_of(report, "EASE", 0).faces == report.pieces[0].ease_faces
    assert elements_of(report, "HINT", 0).faces == report.hints[0].faces
    assert elements_of(report, "SEAM", 10**6) is None
