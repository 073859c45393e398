# SPDX-License-Identifier: GPL-3.0-or-later
"""./dev test runs the chosen steps in order or side by side, ends all its processes, and reports failures."""

import importlib.machinery
import importlib.util
import os
import platform
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tools import environment, steps
from tools.environment import NotTestedError, StepError
from tools.steps import Outcome, Step, When, run_in_order, run_side_by_side, show, show_failed_steps

ROOT = Path(__file__).resolve().parents[2]
WHEN = {"extra": When.ALL, "seldom": When.NAMED}


@pytest.fixture(scope="module")
def dev():
    loader = importlib.machinery.SourceFileLoader("dev", str(ROOT / "dev"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("dev", loader))
    loader.exec_module(module)
    return module


@pytest.fixture
def main(dev, monkeypatch):
    """Return a function that runs `./dev test WORDS`. Steps whose names begin with "bad" or "missing" do not pass."""
    monkeypatch.setattr(dev, "missing_python_notice", lambda: None)
    monkeypatch.setattr(dev, "require_apt", lambda *names: None)

    def run(names: list[str], *words: str) -> int:
        every = [Step(name, work_named(name), when=WHEN.get(name, When.ALWAYS)) for name in names]
        monkeypatch.setattr(dev, "test_steps", lambda: every)
        monkeypatch.setattr(sys, "argv", ["dev", "test", *words])
        return dev.main()

    return run


def work_named(name: str):
    def work() -> None:
        if name.startswith("bad"):
            raise StepError("it is bad")
        if name.startswith("missing"):
            raise NotTestedError("there is no such Python")

    return work


def table(output: str) -> list[tuple[str, str]]:
    """Return (step, outcome) of each row, except the last row with the total time."""
    rows = output.partition("===== summary\n")[2].splitlines()
    return [(row[:24].strip(), row[24:35].strip()) for row in rows if row.endswith(" s") and not row.startswith("all ")]


NOT_HERE = "missing is NOT TESTED: there is no such Python"


@pytest.mark.parametrize(
    ("names", "words", "outcomes", "code", "line"),
    [
        ("lint blender-3.4 blender-4.2 window", "li blender-4", "lint passed, blender-4.2 passed", 0, ""),
        ("window windows-3.11 windows-3.13", "window", "window passed", 0, ""),
        ("lint window", "macos", "", 1, "no step starts with macos; there are: lint, window"),
        ("bad good", "bad good", "bad FAILED, good passed", 1, "dev: failed: bad"),
        ("missing", "missing", "missing NOT TESTED", 0, NOT_HERE),  # a step that is not tested is not a failure
        ("good bad", "", "good passed, bad FAILED", 1, "dev: it is bad"),
        ("good missing", "", "good passed, missing NOT TESTED", 0, NOT_HERE),
        ("seldom extra good", "", "good passed", 0, ""),
        ("seldom extra good", "--all", "extra passed, good passed", 0, ""),
        ("seldom extra good", "seldom extra", "seldom passed, extra passed", 0, ""),
    ],
)
def test_the_steps_that_words_choose(main, capfd, tmp_path, monkeypatch, names, words, outcomes, code, line):
    monkeypatch.setattr(steps, "LOGS", tmp_path)
    assert main(names.split(), *words.split()) == code
    output = capfd.readouterr().out
    assert ", ".join(map(" ".join, table(output))) == outcomes
    assert line in output


def test_every_step_has_its_own_name_and_comes_after_a_step_that_is_not_rarer(dev):
    before: dict[str, When] = {}
    for step in dev.test_steps():
        assert step.name not in before
        assert not step.after or before[step.after] <= step.when, step.name
        before[step.name] = step.when


@pytest.fixture
def log(tmp_path, monkeypatch):
    """Return the path of a file to which the test's steps write. The logs of the steps are in the same folder."""
    monkeypatch.setattr(steps, "LOGS", tmp_path)
    return tmp_path / "events"


def writer(log: Path, text: str):
    def write() -> None:
        with log.open("a") as events:
            events.write(text + "\n")

    return write


def test_side_by_side_a_step_waits_for_another(log):
    chosen = [
        Step("first", writer(log, "first")),
        Step("last", writer(log, "last"), after="middle"),
        Step("middle", writer(log, "middle"), after="first"),
    ]
    assert [outcome.name for outcome in run_side_by_side(chosen)] == ["first", "last", "middle"]
    assert log.read_text().split() == ["first", "middle", "last"]


def test_side_by_side_the_output_of_a_step_that_fails_is_shown_and_stays_together(log, capfd):
    def speak(name: str, is_good: bool):
        def work() -> None:
            for _ in range(50):
                subprocess.run(["echo", name], check=True)
                print(name, flush=True)
            if not is_good:
                raise StepError("no")

        return work

    show_failed_steps(run_side_by_side([Step(name, speak(name, is_good=name == "3")) for name in "123"]))
    words = [line for line in capfd.readouterr().out.splitlines() if line in ("1", "2", "3")]
    assert words == ["1"] * 100 + ["2"] * 100


@pytest.mark.parametrize(
    ("end", "shown"),
    [(lambda: os.kill(os.getpid(), signal.SIGKILL), ""), (lambda: 1 / 0, "ZeroDivisionError")],
    ids=["killed", "raises"],
)
def test_side_by_side_a_step_that_does_not_end_normally_has_failed(log, capfd, end, shown):
    outcomes = run_side_by_side([Step("broken", end), Step("good", lambda: None)])
    show_failed_steps(outcomes)
    assert [outcome.word for outcome in outcomes] == ["FAILED", "passed"]
    assert shown in capfd.readouterr().out


def test_a_run_that_is_interrupted_says_so(dev, monkeypatch, capfd):
    def interrupt(_arguments: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setitem(dev.COMMANDS, "docs", interrupt)
    monkeypatch.setattr(sys, "argv", ["dev", "docs"])
    assert dev.main() == 130
    assert "dev: stopped" in capfd.readouterr().out


HANGING = """
import signal
import sys
from pathlib import Path
from tools import children, steps
from tools.environment import run

signal.signal(signal.SIGINT, signal.default_int_handler)  # runs in the background ignore this signal
folder, way, *names = sys.argv[1:]
steps.LOGS = Path(folder)
children.PATIENCE = 0.1

def hang(name):
    # Like Blender on its virtual screen, the process has its own session. It ignores the first signal.
    run(["sh", "-c", f"setsid sh -c 'trap : TERM; echo $$ > {folder}/{name}.pid; while true; do sleep 1; done'; true"])

with children.no_child_left():
    getattr(steps, way)([steps.Step(name, lambda name=name: hang(name)) for name in names])
"""


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT], ids=["terminated", "interrupted"])
@pytest.mark.parametrize(("way", "names"), [("run_in_order", ["one"]), ("run_side_by_side", ["one", "two"])])
def test_a_terminated_run_ends_its_steps(tmp_path, way, names, number):
    script = [sys.executable, "-c", HANGING, tmp_path, way, *names]
    started = subprocess.Popen(script, env=os.environ | {"PYTHONPATH": str(ROOT)}, cwd=ROOT)
    files = [tmp_path / f"{name}.pid" for name in names]
    while not all(file.exists() and file.read_text().endswith("\n") for file in files):
        assert started.poll() is None
        time.sleep(0.05)
    started.send_signal(number)
    assert started.wait() != 0
    assert [file for file in files if Path("/proc", file.read_text().strip()).exists()] == []


def test_only_expected_errors_are_outcomes():
    with pytest.raises(ZeroDivisionError):
        run_in_order([Step("broken", lambda: 1 / 0)])


def test_the_table_has_the_time_of_all(capfd):
    show([Outcome("a", "passed", 3.0), Outcome("b", "passed", 4.0)], 5.0)
    assert [row.split()[-2] for row in capfd.readouterr().out.splitlines() if row.endswith(" s")] == ["3", "4", "5"]


def test_without_the_right_to_install_the_command_is_shown(monkeypatch):
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    monkeypatch.setattr(environment, "may_use_sudo", lambda: False)
    with pytest.raises(StepError, match=r"as root.*\n.*apt-get install .* no-such-package$"):
        environment.require_apt("base-files", "no-such-package")


def test_elsewhere_one_sentence_says_what_is_needed(dev, monkeypatch, capfd):
    monkeypatch.setattr(environment, "DEBIAN_VERSION", "3.12")
    monkeypatch.setattr(platform, "freedesktop_os_release", lambda: {"PRETTY_NAME": "Ubuntu 24.04"})
    monkeypatch.setattr(sys, "argv", ["dev", "demo"])
    assert dev.main() == 1
    (sentence,) = [line for line in capfd.readouterr().out.splitlines() if not line.startswith("dev: WARNING")]
    assert sentence.startswith("dev: Ubuntu 24.04 lacks apt with Python 3.11 or 3.13, which Debian 12 and 13 have:")


@pytest.mark.parametrize("words", [["lint", "window"], ["test", "--full"], ["bench", "--short"], ["no-such-command"]])
def test_words_that_a_command_does_not_take_are_refused(dev, words, monkeypatch, capfd):
    monkeypatch.setattr(sys, "argv", ["dev", *words])
    with pytest.raises(SystemExit) as stopped:
        dev.main()
    assert stopped.value.code == 2
    assert "usage: dev" in capfd.readouterr().err
