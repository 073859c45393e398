# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m wirewarp uses a fabric, its stretch, a thickness, and eases."""

import json

import numpy as np
import pytest
from commands import flatten as run
from wirewarp.report import percent_text


def test_stretch_and_thickness_change_the_areas_of_pieces(model, tmp_path):
    def areas(*words):
        run(model, "--out", tmp_path / "out", "--seams", "uv", *words)
        report = json.loads((tmp_path / "out" / "Folded.json").read_text())
        return [piece["metrics"]["area_2d"] for piece in report["pieces"]]

    whole = areas()
    assert areas("--stretch", "25%") == pytest.approx([area / 1.25**2 for area in whole])
    assert areas("--cloth", "swim", "--stretch", "25%,0%")[0] == pytest.approx(whole[0] / 1.25)
    assert areas("--thickness", "2mm", "--surface", "middle") == pytest.approx(whole)
    assert areas("--stretch=-20%") == pytest.approx([area / 0.8**2 for area in whole])
    _, said = run(model, "--out", tmp_path / "out", "--stretch", "0.2", code=2)
    assert "is not a stretch: give 10%" in said


def test_eases_and_a_fabric_change_the_pieces(model, tmp_path):
    words = (model, "--out", tmp_path / "out", "--seams", "uv", "--format", "svg", "--resume")
    lines = tmp_path / "lines.json"
    lines.write_text(json.dumps([{"vertices": [1, 4], "ease": -0.1}, {"side": [1, 4], "ease": 0.2}]))
    ((plain,), _) = run(*words)
    ((eased,), _) = run(*words, "--wires", lines)
    (seam,) = json.loads((tmp_path / "out" / "Folded.json").read_text())["seams"]
    assert seam["variation"] == pytest.approx(-0.1) and seam["eases"] == pytest.approx([0.2, 0.0])
    assert seam["length_2d"] == pytest.approx([0.1 * 0.9 * 1.2, 0.1 * 0.9])
    ((woven,), _) = run(*words, "--wires", lines, "--cloth", "woven", "--orientation", "best")
    pieces = json.loads((tmp_path / "out" / "Folded.json").read_text())["pieces"]
    assert all(piece["metrics"]["cloth_energy"] >= 0 for piece in pieces)  # NaN if there were no fabric
    assert len({line["made_of"] for line in (plain, eased, woven)}) == 3


@pytest.mark.parametrize(
    ("bulge", "words", "verdict", "code"),
    [
        (0.0, (), "ready to cut", 0),
        (1.0, (), "needs stretch fabric", 0),
        (1.0, ("--cloth", "swim"), "ready to cut", 0),
        (2.5, ("--cloth", "woven"), "not ready to cut", 1),
        (6.0, (), "not ready to cut", 1),  # no fabric stretches to twice its length
    ],
)
def test_the_verdict_names_the_necessary_stretch(tmp_path, bulge, words, verdict, code):
    """The model is a square of 100 mm with a hill. For every verdict, all lengths are exact and files are written."""
    x, y = np.meshgrid(np.linspace(-1, 1, 13), np.linspace(-1, 1, 13))
    points = np.column_stack([x.ravel(), y.ravel(), 0.4 * bulge * ((1 - x * x) * (1 - y * y)).ravel()]) * 0.05
    corners = [13 * row + column for row in range(12) for column in range(12)]
    lines = [f"v {a} {b} {c}" for a, b, c in points] + [f"f {i + 1} {i + 2} {i + 15} {i + 14}" for i in corners]
    (tmp_path / "hill.obj").write_text("\n".join(lines) + "\n")
    ((line,), _) = run(tmp_path / "hill.obj", "--out", tmp_path / "out", "--format", "svg", *words, code=code)
    assert (line["verdict"], line["problems"]) == (verdict, [])
    assert (tmp_path / "out" / "hill.svg").is_file()
    stretch = line["figures"]["stretch"]
    assert (stretch > 0.03) == (bulge > 0) and len(line["says"]) == 1
    if not words and verdict == "needs stretch fabric":
        assert f"stretches at least {percent_text(stretch)}." in line["says"][0]
