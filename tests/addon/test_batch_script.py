# SPDX-License-Identifier: GPL-3.0-or-later
"""`python -m wirewarp batch` flattens .blend files with flatten_in_blender.py, which runs in Blender."""

import json
import os
import runpy
import subprocess
import sys
from pathlib import Path
from threading import Event
from types import SimpleNamespace

import bmesh
import bpy
import pytest
from flattening import edited
from surfaces import bump, grid, mark, on_line

SCRIPT = Path(__file__).resolve().parents[2] / "python" / "wirewarp" / "command" / "flatten_in_blender.py"
RUN = """
import runpy, sys
import bpy

module, path, script, _ = sys.argv[-4:]
bpy.ops.preferences.addon_enable(module=module)
bpy.ops.wm.open_mainfile(filepath=path)
runpy.run_path(script)
"""


@pytest.fixture
def run_script(addon, tmp_path, in_another_blender):
    """Return a function that runs the script in another Blender on the open file.

    The function returns the output folder and the exit code. stdin: standard input of the other Blender.
    """

    def run(formats, stdin):
        path, folder = tmp_path / "bag.blend", tmp_path / "out"
        bpy.ops.wm.save_as_mainfile(filepath=str(path))
        saved = path.read_bytes()
        folder.mkdir()
        job = {"folder": str(folder), "stem": "bag", "formats": formats, "answer": ".answer.json"}
        done = in_another_blender(RUN, addon.__name__, path, SCRIPT, json.dumps(job), stdin=stdin)
        print(done.stdout, done.stderr)
        assert path.read_bytes() == saved
        return folder, done.returncode

    return run


def checked_answer(folder):
    answer = json.loads((folder / ".answer.json").read_text())
    (folder / ".answer.json").unlink()
    assert sorted(file.name for file in folder.iterdir()) == sorted(answer.get("files", []))
    return answer


@pytest.fixture
def answer_of(tmp_path, monkeypatch):
    """Return a function that runs the script on the open file in this Blender, and returns its answer."""

    def end(code):
        raise SystemExit(code)

    def run(*formats):
        job = {"folder": str(tmp_path), "stem": "bag", "formats": formats, "answer": ".answer.json"}
        monkeypatch.setattr(sys, "argv", [str(SCRIPT), json.dumps(job)])
        # read() waits, as if the caller had not closed the standard input.
        monkeypatch.setattr(sys, "stdin", SimpleNamespace(read=Event().wait))
        monkeypatch.setattr(os, "_exit", end)
        with pytest.raises(SystemExit) as ended:
            runpy.run_path(str(SCRIPT))
        assert ended.value.code == 0
        return checked_answer(tmp_path)

    return run


def test_blender_ends_with_the_process_that_started_it(run_script):
    mark(grid("Bag", bump), on_line(1, 0.0))
    folder, code = run_script(["svg"], subprocess.DEVNULL)
    assert code == 1 and not (folder / ".answer.json").exists()


def test_marked_models_are_flattened_by_the_settings_in_the_file(run_script):
    sheet = grid("Bag", bump)
    mark(sheet, on_line(1, 0.0), kind="ELASTIC", tolerance=0.05)
    grid("Without marks", bump)
    bpy.context.scene.wirewarp.fairness = 0.3
    bpy.context.scene.wirewarp.allowance = 15.0
    is_alive, until_closed = os.pipe()
    folder, code = run_script(["svg", "pdf"], is_alive)
    os.close(is_alive)
    os.close(until_closed)
    answer = checked_answer(folder)
    (report,) = answer["report"]["objects"]
    assert (code, answer["refusal"], report["object"], report["ok"]) == (0, "", "Bag", True)
    assert report["options"]["fairness"] == pytest.approx(0.3)
    assert answer["files"] == ["bag.svg", "bag.pdf"]


def test_several_models_have_files_of_their_own(answer_of):
    for name in ("Left/right", "Strap"):
        mark(grid(name, bump), on_line(1, 0.0))
    assert answer_of("svg")["files"] == ["bag-Left_right.svg", "bag-Strap.svg"]


def test_models_whose_patterns_would_be_one_file_are_refused(answer_of):
    for name in ("Left/right", "left_right"):
        mark(grid(name, bump), on_line(1, 0.0))
    refusal = answer_of("svg")["refusal"]
    assert refusal == 'The patterns of "Left/right" and "left_right" would be one file: rename one of them.'


def test_warnings_of_the_export_are_in_the_answer(answer_of):
    sheet = grid("Bag", bump, wire=on_line(1, 0.0))
    with edited(sheet.data) as edit:  # a hole of 250 mm, which allowances of 200 mm fill
        bmesh.ops.delete(edit, geom=[edit.faces[9]], context="FACES_ONLY")
    bpy.context.scene.wirewarp.allowance = 200.0
    (warning,) = answer_of("svg", "pdf")["warnings"]
    assert warning.endswith("the allowance fills 1 of 1 holes, which are not cut.")


def test_failed_pieces_are_in_the_report_and_nothing_is_exported(answer_of):
    bpy.ops.mesh.primitive_uv_sphere_add()
    bpy.context.object.data.edges[0].use_seam = True
    answer = answer_of("svg")
    (report,) = answer["report"]["objects"]
    assert (report["ok"], answer["files"]) == (False, []) and report["issues"][0]["sentence"]


def test_a_file_without_marks_is_refused_in_a_sentence(answer_of):
    grid("Bag", bump)
    assert answer_of("svg")["refusal"].startswith("No visible mesh of the file has a seam or a wire")
