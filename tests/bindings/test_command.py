# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m wirewarp flattens files with the same results as flatten(), and reports each fault in one sentence."""

import errno
import itertools
import json
import os
import subprocess
import sys
from pathlib import Path

import ezdxf
import numpy as np
import pypdfium2
import pytest
from commands import FOLDED, contents
from commands import flatten as run
from patterns import longest_run
from PIL import Image
from samples import SAMPLES, flattened
from wirewarp.command import staged
from wirewarp.command.arguments import parsed
from wirewarp.command.flatten import flatten_model
from wirewarp.pattern import Marker

trimesh = pytest.importorskip("trimesh")
LOST_VERTEX = """ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z
element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n3 0 0 9\n"""


def write_sample(name, path):
    """Write a sample as OBJ, and its seams and wires as JSON beside it. Return the options that name these files."""
    shape = SAMPLES[name]
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in np.asarray(shape.vertices, dtype=float).tolist()]
    lines += ["f " + " ".join(str(corner + 1) for corner in face) for face in shape.faces]
    path.write_text("\n".join(lines) + "\n")
    (path.parent / "seams.json").write_text(json.dumps(np.asarray(shape.seams).tolist()))
    wires = [{"vertices": list(wire.vertices), "tolerance": wire.tolerance, "name": wire.name} for wire in shape.wires]
    for wire in wires:
        wire["tolerance"] = "inf" if wire["tolerance"] == float("inf") else wire["tolerance"]
    (path.parent / "wires.json").write_text(json.dumps(wires))
    return "--seams", path.parent / "seams.json", "--wires", path.parent / "wires.json"


def lengths(result):
    """Return the flat lengths of all outlines and wires. result: a result or report as a dict."""
    chains = [chain for piece in result["pieces"] for chain in (*piece["boundaries"], *piece["wires"])]
    return sorted(chain["length_2d"] for chain in chains)


@pytest.mark.parametrize("name", ["Hat", "Carnival mask"])
def test_the_result_is_the_same_as_through_python(tmp_path, name):
    lines = write_sample(name, tmp_path / "model.obj")
    ((line,), _) = run(tmp_path / "model.obj", "--out", tmp_path / "out", *lines)
    assert line["verdict"] == "needs stretch fabric"
    report = json.loads((tmp_path / "out" / "model.json").read_text())
    expected = flattened(name).to_dict()
    assert lengths(report) == pytest.approx(lengths(expected), rel=1e-12)
    energies = ([piece["metrics"]["arap_energy"] for piece in each["pieces"]] for each in (report, expected))
    assert next(energies) == pytest.approx(next(energies), rel=1e-6)


def test_uv_islands_become_pieces_and_the_files_are_read_again(model, tmp_path):
    ((line,), _) = run(model, "--out", tmp_path / "out", "--seams", "uv", "--page", "letter", "--allowance", "3/8in")
    assert line["pieces"] == 2 and line["problems"] == []
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert names == {"Folded.json", "Folded.pdf", "Folded.svg"} == set(line["files"])
    page = pypdfium2.PdfDocument((tmp_path / "out" / "Folded.pdf").read_bytes())[0]
    assert np.array(page.get_size()) / 72 == pytest.approx([8.5, 11])
    assert "9.525 mm" in page.get_textpage().get_text_range()


def test_pairs_and_halves_are_drawn_once(tmp_path):
    lines = write_sample("Fitted top", tmp_path / "top.obj")
    run(tmp_path / "top.obj", "--out", tmp_path, "--format", "dxf", "--pairs", "--on-fold", *lines)
    blocks = {block.name: block for block in ezdxf.readfile(tmp_path / "top.dxf").blocks if block.name[0] != "*"}
    assert set(blocks) == {"PIECE_1", "PIECE_2", "PIECE_3"}
    folds = [len(block.query('LINE[layer=="6"]')) for block in blocks.values()]
    assert folds == [1, 1, 0]
    texts = [{text.dxf.text for text in block.query("TEXT")} for block in blocks.values()]
    assert "Quantity: 1,1" in texts[2] and "Cut 1 on the fold" in texts[0]


def test_sharp_edges_are_seams(tmp_path):
    trimesh.creation.box((0.1, 0.1, 0.1)).export(tmp_path / "box.stl")
    ((line,), _) = run(tmp_path / "box.stl", "--out", tmp_path, "--seams", "sharp", "--format", "dxf")
    assert (line["verdict"], line["pieces"]) == ("ready to cut", 6)


@pytest.mark.parametrize("suffix", ["obj", "ply", "stl", "glb"])
def test_every_kind_of_model_is_read(model, tmp_path, suffix):
    path = tmp_path / f"other.{suffix}"
    trimesh.load_mesh(model, process=False).export(path)
    ((line,), _) = run(path, "--out", tmp_path, "--format", "svg")
    report = json.loads((tmp_path / "other.json").read_text())
    assert line["pieces"] == 1
    outline = [0.05, 0.05, 0.1, 0.05, np.hypot(0.05, 0.04), np.hypot(0.1, 0.04)]
    assert lengths(report) == pytest.approx([sum(outline)], rel=1e-6)  # files have single precision


def test_a_marker_is_one_more_file_of_each_kind_and_is_kept(model, tmp_path):
    words = (model, "--out", tmp_path / "out", "--seams", "uv", "--format", "pdf,plt")
    marker = ("--marker", "20cm", "--gap", "2mm", "--grain", "both-ways", "--times", 3, "--seconds", 0)
    ((line,), _) = run(*words, *marker)
    assert line["files"] == ["Folded.json", "Folded.pdf", "Folded.plt", "Folded-marker.pdf", "Folded-marker.plt"]
    assert line["marker"].startswith("6 pieces on ") and " of fabric 200 mm wide" in line["marker"]
    kept = Marker.from_dict(json.loads((tmp_path / "out" / "Folded.json").read_text())["marker"])
    assert (kept.width, kept.gap, len(kept.placements)) == (200.0, 2.0, 6)
    page = pypdfium2.PdfDocument((tmp_path / "out" / "Folded-marker.pdf").read_bytes())[0]
    assert page.get_size()[0] / 72 * 25.4 == pytest.approx(200 + 20)
    ((line,), _) = run(*words, "--marker", "10x12in", "--seconds", 0, "--imperial")
    assert line["marker"].startswith("2 pieces on 1 sheet of 10 in x 12 in, ")
    ((line,), _) = run(*words)
    assert "marker" not in line and not (tmp_path / "out" / "Folded-marker.pdf").exists()


def test_the_picture_shows_the_pieces_in_scale(model, tmp_path):
    ((line,), _) = run(model, "--out", tmp_path / "out", "--seams", "uv", "--format", "svg", "--picture")
    assert line["files"] == ["Folded.json", "Folded-strain.png", "Folded.svg"]
    pixels = np.array(Image.open(tmp_path / "out" / "Folded-strain.png")).astype(int)
    assert max(pixels.shape) == pytest.approx(2000, abs=100)
    is_black = pixels.sum(axis=2) < 60
    # The margins are 60 pixels wide, and the outlines fill the width between them.
    columns = np.flatnonzero(is_black[:-100].any(axis=0))
    assert (columns[0], columns[-1]) == pytest.approx((60, pixels.shape[1] - 60), abs=4)
    # The bar of the legend is 100 mm long. The report contains the size of the layout.
    report = json.loads((tmp_path / "out" / "Folded.json").read_text())
    across = np.ptp([x for piece in report["pieces"] for x, _ in piece["vertices"]])
    bar = max(longest_run(row) for row in is_black[-60 - 12 - 10 : -60 - 12 + 10])
    assert bar == pytest.approx(0.1 / across * (columns[-1] - columns[0]), rel=0.02)


def test_a_missing_pillow_is_reported(model, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "wirewarp.command.picture", None)
    (request,) = parsed(["flatten", str(model), "--out", str(tmp_path / "out"), "--picture"]).requests
    (problem,) = flatten_model(request)["problems"]
    assert problem == "Pictures are drawn by pillow, which is missing: pip install wirewarp[command]"


def test_finished_models_are_skipped_until_something_changes(model, tmp_path):
    words = (model, "--out", tmp_path / "out", "--seams", "uv", "--resume")
    assert "skipped" not in run(*words)[0][0]
    before = (tmp_path / "out" / "Folded.pdf").stat().st_mtime_ns
    again = run(*words)[0][0]
    assert again["skipped"] and again["verdict"] == "ready to cut"
    assert (tmp_path / "out" / "Folded.pdf").stat().st_mtime_ns == before
    assert "skipped" not in run(*words, "--allowance", "5mm")[0][0]
    assert "skipped" not in run(*words)[0][0]  # the report now has an allowance of 5 mm
    (tmp_path / "out" / "Folded.svg").unlink()
    assert "skipped" not in run(*words)[0][0]
    model.write_text(FOLDED.replace(".04", ".03"))
    assert "skipped" not in run(*words)[0][0]


def test_a_model_of_several_files_has_changed_when_one_file_has(tmp_path):
    def write(height):
        mesh = trimesh.Trimesh([(0, 0, 0), (0.1, 0, 0), (0, 0.1, height)], [(0, 1, 2)])
        for name, content in trimesh.exchange.gltf.export_gltf(trimesh.Scene(mesh)).items():
            (tmp_path / name).write_bytes(content)
        (tmp_path / "model.gltf").replace(path)

    path = tmp_path / "sheet.gltf"
    write(0.01)
    words, text = (path, "--out", tmp_path / "out", "--format", "svg", "--resume"), path.read_text()
    assert "skipped" not in run(*words)[0][0]
    write(0.02)
    path.write_text(text)  # only the other files of the model have changed
    assert "skipped" not in run(*words)[0][0]
    assert run(*words)[0][0]["skipped"]


def test_a_refused_model_keeps_its_earlier_files(model, tmp_path):
    words = (model, "--out", tmp_path / "out", "--format", "svg,pdf")
    run(*words)
    before = contents(tmp_path / "out")
    ((line,), _) = run(*words, "--page", "120mm", "--allowance", "5mm", "--resume", code=2)
    assert line["codes"] == ["invalid_option"]
    assert contents(tmp_path / "out") == before
    assert run(*words, "--resume")[0][0]["skipped"]


def failing_at(number):
    """Return a substitute for Path.replace that fails once.

    number: index of the failing move, among the moves into or out of the folder "out"
    """
    replace, count = Path.replace, itertools.count()

    def failing(self, target):
        if "out" in (self.parent.name, Path(target).parent.name) and next(count) == number:
            raise PermissionError(errno.EACCES, "Permission denied", str(target))
        return replace(self, target)

    return failing


@pytest.mark.parametrize("is_killed", [False, True])
@pytest.mark.parametrize("number", range(6))
def test_files_of_two_runs_are_never_mixed(model, tmp_path, monkeypatch, number, is_killed):
    """A run moves three old files out of the folder "out", then three new files into it. One of these moves fails."""
    words = ["flatten", str(model), "--out", str(tmp_path / "out")]
    flatten_model(parsed([*words, "--format", "svg,dxf"]).requests[0])
    before = contents(tmp_path / "out")
    (request,) = parsed([*words, "--format", "svg,plt", "--allowance", "5mm"]).requests
    with monkeypatch.context() as patched:
        patched.setattr(Path, "replace", failing_at(number))
        if is_killed:  # a killed run does not move the old files back
            patched.setattr(staged, "_remove", lambda *_: None)
        line = flatten_model(request)
    assert (line["verdict"], line["codes"]) == ("refused", ["file"]) and "Permission denied" in line["problems"][0]
    if is_killed:
        staged.remove_staged(request)
    assert contents(tmp_path / "out") == before
    assert all(path.is_file() for path in (tmp_path / "out").iterdir())  # no folder of the run is left
    assert flatten_model(request)["verdict"] == "ready to cut"
    assert set(contents(tmp_path / "out")) == {"Folded.json", "Folded.svg", "Folded.plt"}


@pytest.mark.parametrize("name", ["Folded.svg", "Folded.json"])
def test_files_of_other_programs_do_not_change(model, tmp_path, name):
    theirs = tmp_path / "out" / name
    theirs.parent.mkdir()
    theirs.write_text("{}")
    (tmp_path / "out" / "Folded.pdf").write_text("theirs")  # the run writes no PDF, so this file is no conflict
    words = (model, "--out", tmp_path / "out", "--format", "svg")
    ((line,), _) = run(*words, code=2)
    (problem,) = line["problems"]
    assert f'"{theirs}" would be replaced, but no earlier report of "{model}" lists it' in problem
    assert contents(tmp_path / "out") == {name: b"{}", "Folded.pdf": b"theirs"}
    theirs.unlink()
    run(*words)
    assert set(contents(tmp_path / "out")) == {"Folded.json", "Folded.pdf", "Folded.svg"}


def test_a_report_names_no_files_in_other_folders(model, tmp_path):
    (tmp_path / "out").mkdir()
    report = {"line": {"files": ["Folded.json", "../Folded.obj"], "made_of": ""}}
    (tmp_path / "out" / "Folded.json").write_text(json.dumps(report))
    run(model, "--out", tmp_path / "out", "--format", "svg")
    assert model.exists()


def test_any_name_can_be_printed_on_any_console(model, tmp_path):
    named = model.rename(tmp_path / "Ärmel.obj")
    command = [sys.executable, "-m", "wirewarp", "flatten", named, "--out", tmp_path, "--format", "svg"]
    done = subprocess.run(command, capture_output=True, env=os.environ | {"PYTHONIOENCODING": "ascii"})
    assert (done.returncode, done.stderr) == (0, b"") and json.loads(done.stdout)["model"] == str(named)


def test_the_old_pattern_of_a_model_that_is_not_ready_is_removed(tmp_path):
    path, words = tmp_path / "ball.ply", ("--out", tmp_path / "out", "--format", "svg")
    ball = trimesh.creation.icosphere(2, 0.1)
    ball.submesh([np.flatnonzero(ball.triangles_center[:, 2] > 0)], append=True).export(path)
    run(path, *words)
    assert (tmp_path / "out" / "ball.svg").is_file()
    ball.export(path)
    run(path, *words, code=1)
    assert [file.name for file in (tmp_path / "out").iterdir()] == ["ball.json"]


def test_a_file_that_differs_when_read_again_is_refused_and_the_batch_continues(model, tmp_path, monkeypatch):
    monkeypatch.setattr("wirewarp.pattern.formats.read_back.WORST", -1.0)
    (request,) = parsed(["flatten", str(model), "--out", str(tmp_path / "out")]).requests
    line = flatten_model(request)
    assert line["verdict"] == "refused" and "Verification failed" in line["problems"][0]
    assert list((tmp_path / "out").iterdir()) == []


@pytest.mark.parametrize(
    ("name", "content", "words", "said"),
    [
        ("a.fbx", "", (), '"a.fbx" cannot be read: names of models end in .obj'),
        ("a.obj", "hello", (), '"a.obj" has no faces'),
        ("a.ply", "hello", (), '"a.ply" is damaged or is not PLY. Export the model again.'),
        ("a.ply", LOST_VERTEX, (), '"a.ply" has faces with vertices that are not in the file'),
        ("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", (), '"a.stl" is cut off'),
        ("a.stl", "\0" * 80 + "\2\0\0\0" + "\0" * 50, (), '"a.stl" is cut off'),
        ("a.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", (), "NaN or infinite coordinates"),
        ("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n", (), '"a.obj" is damaged or is not OBJ'),
        ("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", ("--seams", "uv"), "no UV map"),
        ("a.obj", FOLDED, ("--seams", "none.json"), 'There is no file "none.json"'),
        ("a.obj", FOLDED, ("--seams", "a.obj"), "is not valid JSON"),
        ("a.obj", FOLDED, ("--seams", "lines.json"), "must be a JSON list of lines of vertices"),
        ("a.obj", FOLDED, ("--wires", "lines.json"), "must be a JSON list of wires"),
        ("a.obj", FOLDED, ("--wires", "wire.json"), "Wire 1 of"),
        (
            "a.obj",
            FOLDED,
            ("--wires", "ease.json"),
            "Ease 1 of \"ease.json\" has the unknown key 'tolerance': give ease, side",
        ),
        ("a.obj", FOLDED, ("--orientation", "best"), "grain if there is no cloth"),
        ("a.obj", FOLDED, ("--marker", "1in", "--imperial", "--picture"), "too large for a roll of 1 in"),
        ("a.obj", FOLDED, ("--page", "120mm", "--format", "svg,pdf"), "too large for a roll of 120 mm"),
    ],
)
def test_bad_input_gives_one_sentence(tmp_path, monkeypatch, name, content, words, said):
    monkeypatch.chdir(tmp_path)
    (tmp_path / name).write_text(content)
    (tmp_path / "lines.json").write_text("[1, 2]")
    (tmp_path / "ease.json").write_text('[{"side": [0, 1], "tolerance": 1}]')
    (tmp_path / "wire.json").write_text('[{"vertices": [0, 1], "tolerence": 1}]')
    ((line,), errors) = run(name, "--out", "out", *words, code=2)
    (problem,) = line["problems"]
    assert line["verdict"] == "refused" and said in problem and errors == ""
    assert list((tmp_path / "out").glob("*")) == []


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--allowance", "10"), "'10' is not a length: give 10mm"),
        (("--allowance", "3/00in"), "'3/00in' is not a length: give 10mm"),
        (("--page", "a9"), "paper is 'a9'"),
        (("--format", "png"), "'png' is not a format"),
        (("--cloth", "silk"), "invalid choice: 'silk'"),
        (("--jobs", "0"), "give 1 or more"),
        (("--times", "-1"), "give 1 or more"),
        (("--marker", "wide"), "'wide' is not a length"),
        (("--marker", "60x"), "'60x' is not a length"),
        (("--seconds", "nan"), "'nan' is not a number of seconds"),
        (("--memory-limit", "4"), "'4' is not an amount of memory: give 500MB or 4GB"),
        (("Folded.stl",), "would both write"),
    ],
)
def test_bad_arguments_give_one_sentence(model, tmp_path, words, said):
    assert said in run(model, *words, "--out", tmp_path, code=2)[1].splitlines()[-1]


@pytest.mark.parametrize("option", ["--seams", "--wires"])
def test_the_report_never_overwrites_an_input(model, tmp_path, option):
    lines = tmp_path / "Folded.json"
    lines.write_text("[]")
    (tmp_path / "other").mkdir()
    out = tmp_path / "other" / ".."
    said = run(model, option, lines, "--out", out, code=2)[1]
    assert f'would overwrite "{lines}"' in said and lines.read_text() == "[]"
    assert run(model, option, lines, "--out", tmp_path / "other", "--format", "svg")
