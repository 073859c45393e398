# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m wirewarp with a cloth, its stretch, a thickness, and eases."""

import json

import pytest
from test_command import FOLDED, run


@pytest.fixture
def model(tmp_path):
    path = tmp_path / "Folded.obj"
    path.write_text(FOLDED)
    return path


def test_a_stretched_cloth_and_a_thick_one(model, tmp_path):
    def areas(*words):
        _, _ = run(model, "--out", tmp_path / "out", "--seams", "uv", *words)
        report = json.loads((tmp_path / "out" / "Folded.json").read_text())
        return [piece["metrics"]["area_2d"] for piece in report["pieces"]]

    whole = areas()
    assert areas("--stretch", "25%") == pytest.approx([area / 1.25**2 for area in whole])
    assert areas("--cloth", "swim", "--stretch", "25%,0%")[0] == pytest.approx(whole[0] / 1.25)
    assert areas("--thickness", "2mm", "--surface", "middle") == pytest.approx(whole)
    assert areas("--stretch=-20%") == pytest.approx([area / 0.8**2 for area in whole])
    _, said = run(model, "--out", tmp_path / "out", "--stretch", "0.2", code=2)
    assert "is not a stretch: give 10%" in said


def test_eases_and_a_cloth_change_what_is_made(model, tmp_path):
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
    assert all(piece["metrics"]["cloth_energy"] >= 0 for piece in pieces)  # which is NaN without a cloth
    assert len({line["made_of"] for line in (plain, eased, woven)}) == 3
