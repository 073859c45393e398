# SPDX-License-Identifier: GPL-3.0-or-later
"""The script of ./dev bench runs on a small mesh. This shows whether it still finds the add-on's functions."""

import json
import os
import runpy
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "bench" / "flatten_in_blender.py"


@pytest.mark.skipif(sys.platform != "linux", reason="./dev bench runs on Linux")
def test_flatten_is_timed_beside_blenders_unwrap(tmp_path, monkeypatch):
    output = tmp_path / "blender.json"
    monkeypatch.setattr(sys, "argv", ["blender", "--", str(output), "200"])
    monkeypatch.setattr(sys, "path", list(sys.path))
    monkeypatch.delitem(sys.modules, "surfaces")  # The script imports another module with this name.
    cores = os.sched_getaffinity(0)
    try:
        runpy.run_path(str(SCRIPT))
    finally:
        os.sched_setaffinity(0, cores)
    (run,) = json.loads(output.read_text(encoding="utf-8"))["runs"]
    assert run["triangles"] == 200
    assert all(run[step] > 0 for step in ("flatten", "unwrap", "read", "solve", "write"))
