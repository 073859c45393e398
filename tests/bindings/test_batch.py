# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m wirewarp batch flattens each model of folders and lists once, in a process of its own."""

import json
import os
import signal
import subprocess
import sys
import time
from multiprocessing import active_children
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import psutil
import pytest
from commands import FOLDED, contents
from commands import batch as run
from processes import wait_until_gone
from wirewarp import flatten
from wirewarp.command import run as command_run
from wirewarp.command.apart import CONTEXT, Limits, Stopped, each_apart
from wirewarp.command.arguments import parsed
from wirewarp.command.figures import figures_of
from wirewarp.command.staged import staged_folder
from wirewarp.report import Issue, Note, Report, failure_report, make_report, to_dict
from works_apart import hang_or_wait, square_or_crash, take_memory_and_hang

posix = pytest.mark.skipif(os.name != "posix", reason="uses shell scripts and limits of POSIX")
NEVER = Limits(3600.0, 10**12)
# A test that runs in the background ignores SIGINT. Without this line, its child processes would ignore it, too.
HEARS_CTRL_C = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)"
COMMAND = "; import runpy; runpy.run_module('wirewarp', run_name='__main__')"


def run_apart(*words, **how):
    """Run the command in a process of its own. Return its output and its errors. how: options of subprocess.run."""
    command = [sys.executable, "-m", "wirewarp", "batch", *map(str, words)]
    done = subprocess.run(command, stderr=subprocess.PIPE, text=True, **{"stdout": subprocess.PIPE} | how)
    assert done.returncode == 2, done.stderr
    return done.stdout, done.stderr


@pytest.fixture
def models(tmp_path):
    """Return a folder with two models of one name, a file that is not a model, and two hidden models."""
    folder = tmp_path / "models"
    for path in ("a.obj", "deep/er/a.obj", "notes.txt", ".hidden/b.obj", ".c.obj"):
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(FOLDED)
    return folder


def files(folder):
    return sorted(contents(folder))


def test_models_of_folders_keep_their_places_and_are_done_once(models, tmp_path):
    words = (models, "--out", tmp_path / "out", "--format", "svg", "--jobs", 2)
    lines, errors = run(*words)
    assert [line["model"] for line in lines] == [str(models / "a.obj"), str(models / "deep/er/a.obj")]
    assert files(tmp_path / "out") == ["a.json", "a.svg", "deep/er/a.json", "deep/er/a.svg"] and errors == ""
    assert lines[0]["figures"]["area_m2"] == pytest.approx(0.05 * 0.1 + 0.05 * 0.1 * 1.18, rel=0.01)
    (models / "deep/er/a.obj").write_text(FOLDED.replace(".04", ".03"))
    assert ["skipped" in line for line in run(*words)[0]] == [True, False]


def test_the_next_run_removes_leftovers_of_a_killed_run(models, tmp_path):
    words = (models, "--out", tmp_path / "out", "--format", "svg")
    run(*words)
    done = contents(tmp_path / "out")
    request = parsed(["batch", *map(str, words)]).requests[0]
    left = staged_folder(request)  # the test enters this context but never leaves it, like a killed run
    (left.__enter__() / "a.svg").write_text("half")
    assert all("skipped" in line for line in run(*words)[0])
    assert contents(tmp_path / "out") == done


def test_models_of_a_list_have_options_of_their_own(models, tmp_path):
    (models / "cuts.json").write_text("[[1, 4]]")
    entries = [{"model": "a.obj", "seams": "cuts.json", "picture": True}, {"model": "deep/er/a.obj", "format": "dxf"}]
    (models / "list.jsonl").write_text("\n".join(map(json.dumps, entries)) + "\n\n")
    lines, _ = run(models / "list.jsonl", "--out", tmp_path / "out", "--format", "svg", "--jobs", 1)
    assert [line["pieces"] for line in lines] == [2, 1]
    assert files(tmp_path / "out") == ["a-strain.png", "a.json", "a.svg", "deep/er/a.dxf", "deep/er/a.json"]


def test_each_command_has_its_own_default_number_of_jobs(models):
    jobs = [parsed([command, str(models / "a.obj"), "--out", "out"]).jobs for command in ("flatten", "batch")]
    assert jobs == [1, os.cpu_count()]


def test_the_parts_of_a_render_farm_process_every_model_once(models, tmp_path):
    parts = [parsed(["batch", str(models), "--out", "out", "--part", f"{part}/3"]).requests for part in (1, 2, 3)]
    whole = parsed(["batch", str(models), "--out", "out"]).requests
    assert [len(part) for part in parts] == [1, 1, 0] and [*parts[0], *parts[1]] == whole
    for part in ("0/3", "4/3", "3", "1/0"):
        errors = run(models, "--out", tmp_path / "out", "--part", part, code=2)[1]
        assert f"'{part}' is not a part: give 1/20 to 20/20" in errors.splitlines()[-1]


def test_finished_models_are_recognized_in_any_folder_and_with_any_blender(models, tmp_path, monkeypatch):
    (models / "cuts.json").write_text("[[1, 4]]")
    monkeypatch.chdir(tmp_path)
    words = ("--out", tmp_path / "out", "--format", "svg", "--seams")
    run("models", *words, "models/cuts.json")
    moved = models.rename(tmp_path / "moved")
    lines, _ = run(moved, *words, moved / "cuts.json", "--blender", "other")
    assert [line["skipped"] for line in lines] == [True, True]
    (moved / "cuts.json").write_text("[[4, 1]]")
    assert "skipped" not in run(moved, *words, moved / "cuts.json")[0][0]


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (None, 'there is no model in "'),
        ("", 'there is no model in "'),
        ("a.obj", "line 1, is not JSON like"),
        ('["a.obj"]', "line 1, is not JSON like"),
        ('{"seams": "uv"}', "line 1, is not JSON like"),
        ('{"model": ["a.obj"]}', "line 1: a model must be text, and its options texts"),
        ('{"model": "a.obj", "colour": "red"}', "line 1: unrecognized arguments: --colour=red"),
        ('{"model": "a.obj", "unit": "ft"}', "line 1: argument --unit: invalid choice: 'ft'"),
    ],
)
def test_impossible_arguments_are_refused_in_one_sentence_before_anything_starts(tmp_path, content, said):
    given = tmp_path / ("empty" if content is None else "list.jsonl")
    given.mkdir() if content is None else given.write_text(content)
    _, errors = run(given, "--out", tmp_path / "out", code=2)
    assert said in errors.splitlines()[-1] and not (tmp_path / "out").exists()


def test_two_models_with_one_name_are_refused_and_others_processed(models, tmp_path):
    (models / "a.ply").write_text("another a")
    lines, errors = run(models, "--out", tmp_path / "out", "--format", "svg", code=2)
    assert [line["verdict"] for line in lines] == ["refused", "refused", "ready to cut"] and errors == ""
    for line in lines[:2]:
        assert f'"{models / "a.obj"}" and "{models / "a.ply"}" would both write' in line["problems"][0]
    assert files(tmp_path / "out") == ["deep/er/a.json", "deep/er/a.svg"]


def test_other_models_are_processed_if_one_crashes():
    numbers = [*range(12, 16)]
    results = dict(each_apart(square_or_crash, numbers, 2, NEVER, command_run.MODULES))
    assert [results[0], results[3]] == [12**2, 15**2]
    assert [results[1].code, results[2].code] == ["crashed", "crashed"]
    if os.name == "posix":
        assert results[1].sentence == "The model's process was ended by SIGSEGV."
    assert results[2].sentence == "The model's process ended with code 1."


def test_a_hanging_model_is_stopped_with_its_child_processes(tmp_path):
    path = tmp_path / "pid"
    running = each_apart(hang_or_wait, [("hang", path), ("wait", path)], 2, NEVER, command_run.MODULES)
    assert next(running) == (1, None)
    assert psutil.pid_exists(int(path.read_text()))
    running.close()
    wait_until_gone(int(path.read_text()))


def test_ctrl_c_halfway_through_a_start_ends_what_was_started(tmp_path, monkeypatch, python_handles_ctrl_c):
    begin = CONTEXT.Process.start

    def begin_interrupted(process):
        begin(process)
        signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(CONTEXT.Process, "start", begin_interrupted)
    with pytest.raises(KeyboardInterrupt):
        next(each_apart(hang_or_wait, [("wait", tmp_path / "never")], 1, NEVER, command_run.MODULES))
    assert active_children() == []


# A module that the server of processes loads first.
LOADS_SLOWLY = """
import os, time
open(os.environ["BEGUN"], "w").close()
while not os.path.exists(os.environ["GO_ON"]):
    time.sleep(0.01)
"""
APART = """
import sys
from wirewarp.command.apart import Limits, each_apart
try:
    next(each_apart(abs, [1], 1, Limits(3600.0, 10**12), ["loads_slowly"]))
except KeyboardInterrupt:
    print("stopped", file=sys.stderr)
"""


@posix
def test_ctrl_c_while_the_server_loads_prints_no_traceback(tmp_path):
    (tmp_path / "loads_slowly.py").write_text(LOADS_SLOWLY)
    begun, go_on = tmp_path / "begun", tmp_path / "go on"
    settings = {**os.environ, "BEGUN": str(begun), "GO_ON": str(go_on), "PYTHONPATH": str(tmp_path)}
    command = [sys.executable, "-c", HEARS_CTRL_C + APART]
    with subprocess.Popen(command, start_new_session=True, stderr=subprocess.PIPE, text=True, env=settings) as process:
        while not begun.exists():
            time.sleep(0.01)
        os.killpg(process.pid, signal.SIGINT)
        go_on.touch()
        assert process.stderr.read() == "stopped\n"


SHORT, SMALL = Limits(0.0, 10**12), Limits(3600.0, 500 * 10**6)


@pytest.mark.parametrize(
    ("work", "task", "limits", "option", "sentence"),
    [
        (hang_or_wait, ("wait", Path("never")), SHORT, "time-limit", "took longer than 0 seconds"),
        (take_memory_and_hang, 600 * 10**6, SMALL, "memory-limit", "needed over 0.5 GB of memory"),
    ],
)
def test_a_model_is_stopped_at_its_limits(work, task, limits, option, sentence):
    ((_, stopped),) = each_apart(work, [task], 1, limits, command_run.MODULES)
    assert stopped.code == option.replace("-", "_")
    assert stopped.sentence == f"The model {sentence}: see --{option}." and stopped.seconds > 0


def test_lines_are_in_order_and_the_worst_decides_the_exit_code(models, tmp_path, monkeypatch, capsys):
    arguments = parsed(["batch", str(models), "--out", str(tmp_path / "out")])
    ended = [(1, {"verdict": "not ready to cut"}), (0, Stopped("crashed", "It crashed.", 1.0))]

    def each_apart_of_two(_work, requests, *_):
        assert len(list(requests)) == 2
        yield from ended

    monkeypatch.setattr(command_run, "each_apart", each_apart_of_two)
    assert command_run.run(arguments) == 3
    first, second = map(json.loads, capsys.readouterr().out.splitlines())
    assert (first["model"], first["codes"]) == (str(models / "a.obj"), ["crashed"])
    assert (second["model"], second["verdict"]) == (str(models / "deep/er/a.obj"), "not ready to cut")


@pytest.mark.skipif(sys.platform != "linux", reason="uses processes and pipes of Linux")
def test_kills_lose_nothing_and_do_nothing_twice(tmp_path):
    from many_models import check_kills

    check_kills(tmp_path, 30, 2)


@posix
def test_a_full_disk_gives_one_sentence_and_keeps_old_files(models, tmp_path):
    import resource

    words = (models / "a.obj", "--out", tmp_path / "out", "--format", "svg")
    run(*words)
    before = contents(tmp_path / "out")
    limit = {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))}
    lines, errors = run_apart(*words, "--allowance", "5mm", **limit)
    line = json.loads(lines)
    assert (line["verdict"], line["codes"], errors) == ("refused", ["file"], "")
    assert "File too large" in line["problems"][0]
    assert contents(tmp_path / "out") == before


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full")
def test_unprintable_lines_give_one_sentence(models, tmp_path):
    with Path("/dev/full").open("w") as full:
        _, errors = run_apart(models, "--out", tmp_path / "out", "--format", "svg", stdout=full)
    assert errors == "The lines cannot be printed: No space left on device\n"


@posix
def test_unreadable_models_are_refused_one_by_one(tmp_path):
    (tmp_path / "models").mkdir()
    (tmp_path / "models" / "lost.obj").symlink_to(tmp_path / "nowhere.obj")
    (tmp_path / "models" / "text.glb").write_text("no mesh")
    lines, errors = run(tmp_path / "models", "--out", tmp_path / "out", code=2)
    assert [line["codes"] for line in lines] == [["input"], ["input"]] and errors == ""
    assert "There is no file" in lines[0]["problems"][0] and "is damaged" in lines[1]["problems"][0]
    assert files(tmp_path) == ["models/text.glb"]


BLENDER = """#!{python}
import json, sys, time
from pathlib import Path
job = json.loads(sys.argv[-1])
folder = Path(job["folder"])
kind = Path(sys.argv[sys.argv.index("--disable-autoexec") + 1]).stem
if kind == "hangs":
    time.sleep(3600)
if kind == "crashes":
    print("Segmentation fault")
    sys.exit(11)
reports = json.loads({reports!r})
objects = reports if kind == "partly" else reports[:1]
answer = {{"refusal": "No mesh." if kind == "empty" else "", "report": {{"objects": objects}}, "files": []}}
answer["warnings"] = ["It is cut small."]
for form in job["formats"]:
    answer["files"].append(job["stem"] + "." + form)
    (folder / answer["files"][-1]).write_text(form)
(folder / job["answer"]).write_text(json.dumps(answer))
"""


def bag():
    square, triangles = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float), [[0, 1, 2], [0, 2, 3]]
    report = make_report(flatten(square, triangles, seams=[[0, 2]]), square, triangles, name="Bag")
    report.notes.append(Note("It is inside out.", is_warning=True))
    return to_dict(report)


def refused_bag():
    return to_dict(failure_report(Issue("no_faces", "It has no faces."), "Empty bag"))


@pytest.fixture
def blender(tmp_path):
    """Return a program that answers like Blender with flatten_in_blender.py, which tests/addon tests."""
    program = tmp_path / "blender"
    program.write_text(BLENDER.format(python=sys.executable, reports=json.dumps([bag(), refused_bag()])))
    program.chmod(0o755)
    return program


@posix
def test_blend_files_are_flattened_in_blender(blender, tmp_path):
    for name in ("bag", "crashes", "empty"):
        (tmp_path / f"{name}.blend").write_bytes(b"BLENDER")
    paths = [tmp_path / f"{name}.blend" for name in ("bag", "crashes", "empty")]
    words = (*paths, "--out", tmp_path / "out", "--format", "svg", "--blender", blender)
    (bag, crashed, empty), _ = run(*words, code=3)
    assert (bag["verdict"], bag["pieces"]) == ("ready to cut", 2)
    assert bag["warnings"] == ["It is inside out.", "It is cut small."]
    figures = {"triangles": 2, "area_m2": 1.0, "energy": 0.0, "stretch": 0.0, "seam_mismatch_m": 0.0}
    assert bag["figures"] == pytest.approx(figures, abs=1e-9)
    assert crashed["codes"] == ["crashed"]
    assert crashed["problems"] == ["Blender ended with code 11: Segmentation fault"]
    assert (empty["verdict"], empty["problems"]) == ("refused", ["No mesh."])
    assert files(tmp_path / "out") == ["bag.json", "bag.svg"] == sorted(bag["files"])
    assert run(paths[0], *words[3:])[0][0]["skipped"]


@posix
def test_a_model_that_failed_as_a_whole_makes_its_file_not_ready(blender, tmp_path):
    (tmp_path / "partly.blend").write_bytes(b"BLENDER")
    words = (tmp_path / "partly.blend", "--out", tmp_path / "out", "--format", "svg", "--blender", blender)
    ((line,), _) = run(*words, code=1)
    assert (line["verdict"], line["pieces"], line["codes"]) == ("not ready to cut", 2, ["no_faces"])
    assert (line["says"][0], line["problems"]) == ("Do not cut: Empty bag failed", ["Empty bag: It has no faces."])


def test_seams_without_a_length_have_no_figure():
    for mismatches, figure in {(None, 0.1): None, (0.1, None): None, (0.1, 0.2): 0.2, (): 0.0}.items():
        report = Report(seams=[SimpleNamespace(mismatch=mismatch) for mismatch in mismatches])
        assert figures_of([report])["seam_mismatch_m"] == figure


@posix
def test_a_stopped_model_leaves_no_files(blender, tmp_path):
    (tmp_path / "hangs.blend").write_bytes(b"BLENDER")
    words = (tmp_path / "hangs.blend", "--out", tmp_path / "out", "--blender", blender)
    ((line,), _) = run(*words, "--time-limit", 0, code=3)
    assert (line["verdict"], line["codes"]) == ("stopped", ["time_limit"])
    assert list((tmp_path / "out").glob("*")) == []


@pytest.fixture
def hanging(models, blender, tmp_path):
    """Return arguments of a run in which the first model is flattened while the second hangs."""
    (models / "b hangs").mkdir()
    (models / "b hangs" / "hangs.blend").write_bytes(b"BLENDER")
    return [models, "--out", tmp_path / "out", "--format", "svg", "--blender", blender, "--jobs", "2"]


@posix
def test_a_closed_pipe_gives_one_sentence_and_leaves_no_hidden_files(hanging, tmp_path):
    """The pipe is closed, as by `| head`, so the line of the first model cannot be printed."""
    shut, stdout = os.pipe()
    os.close(shut)
    _, errors = run_apart(*hanging, stdout=stdout)
    os.close(stdout)
    assert errors == "The lines cannot be printed: Broken pipe\n"
    assert all(not path.name.startswith(".") for path in (tmp_path / "out").rglob("*"))


@posix
def test_ctrl_c_ends_everything_and_leaves_no_hidden_files(hanging, tmp_path):
    command = [sys.executable, "-c", HEARS_CTRL_C + COMMAND, "batch", *hanging]
    piped = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with subprocess.Popen(command, start_new_session=True, **piped) as process:
        assert json.loads(process.stdout.readline())["verdict"] == "ready to cut"
        os.killpg(process.pid, signal.SIGINT)  # sent to the group of processes, as terminals do
        assert process.stderr.read() == "stopped\n"
    assert process.returncode == 130
    assert all(not path.name.startswith(".") for path in (tmp_path / "out").rglob("*"))


def test_a_missing_blender_is_reported(tmp_path):
    (tmp_path / "a.blend").write_bytes(b"BLENDER")
    ((line,), _) = run(tmp_path, "--out", tmp_path / "out", "--blender", "no-such-blender", code=2)
    assert line["problems"] == ['There is no Blender at "no-such-blender": give --blender PATH.']
