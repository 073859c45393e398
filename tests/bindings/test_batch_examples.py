# SPDX-License-Identifier: GPL-3.0-or-later
"""The files in examples/batch work with HyperQueue and Flamenco."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from commands import FOLDED

EXAMPLES = Path(__file__).resolve().parents[2] / "examples" / "batch"
# Replaces the parts of Flamenco that our job type uses.
FLAMENCO = """
const author = {
    Task: (name, type) => ({ name, type, commands: [], addCommand(command) { this.commands.push(command); } }),
    Command: (name, parameters) => ({ name, ...parameters }),
};
const tasks = [];
const settings = { models: "/a b/models", patterns: "/out", options: "--seams  uv", parts: 2 };
"""
COMPILE = """
compileJob({ settings, addTask: (task) => tasks.push(task) });
console.log(JSON.stringify({ keys: JOB_TYPE.settings.map((setting) => setting.key), tasks }));
"""


def test_tasks_of_hyperqueue_do_all_models(tmp_path):
    pytest.importorskip("hyperqueue")
    for name in "abc":
        (tmp_path / "models" / name).mkdir(parents=True)
        (tmp_path / "models" / name / "model.obj").write_text("nothing" if name == "c" else FOLDED)
    words = ["2", "models", "--out", "out", "--format", "svg"]
    command = [sys.executable, EXAMPLES / "hyperqueue_tasks.py", *words]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 2, done.stderr
    lines = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    assert [line.get("skipped", line["verdict"]) for line in lines] == [True, True, "refused"]
    made = (path.relative_to(tmp_path / "out").as_posix() for path in (tmp_path / "out").rglob("*.*"))
    assert sorted(made) == ["a/model.json", "a/model.svg", "b/model.json", "b/model.svg"]


@pytest.mark.skipif(shutil.which("node") is None, reason="no node to run JavaScript")
def test_the_job_type_of_flamenco_makes_a_task_of_each_part():
    script = FLAMENCO + (EXAMPLES / "wirewarp_batch.js").read_text() + COMPILE
    done = subprocess.run(["node", "-e", script], capture_output=True, text=True, check=True)
    job = json.loads(done.stdout)
    words = ["-m", "wirewarp", "batch", "/a b/models", "--out", "/out", "--part", "2/2", "--seams", "uv"]
    assert job["keys"] == ["models", "patterns", "options", "parts"] and len(job["tasks"]) == 2
    assert job["tasks"][1]["commands"] == [{"name": "exec", "exe": "{python}", "args": words}]
