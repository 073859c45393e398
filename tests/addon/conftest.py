# SPDX-License-Identifier: GPL-3.0-or-later
"""The tests run inside Blender on the installed add-on or extension."""

import itertools
import subprocess
import sys
from types import ModuleType

import bpy
import numpy as np
import pytest
from everything import COMMANDS, use_everything
from flattening import flatten_fails, flattened
from surfaces import addon_module, bump, grid, join_cube, mark, mark_seam, on_line, read


def pytest_configure(config: pytest.Config) -> None:
    # Longer tracebacks print local variables, and printing a removed Blender object crashes.
    config.option.tbstyle = "short"


@pytest.fixture(scope="session")
def addon() -> ModuleType:
    return addon_module()


@pytest.fixture(autouse=True)
def empty_scene() -> None:
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)


@pytest.fixture
def at_once(addon, monkeypatch):
    """Build changed drawings immediately, however long that takes."""
    monkeypatch.setattr(addon.state.drawings, "IDLE_SHARE", 0.0)
    monkeypatch.setattr(addon.state.drawings, "FELT", float("inf"))


@pytest.fixture
def source():
    """Return a flattened model of two pieces, to the left and right of x = 0."""
    return flattened("Bump", bump, seam=on_line(0, 0.0))


@pytest.fixture
def in_another_blender(tmp_path):
    """Return a function that runs Python code with arguments in another Blender, and returns the finished process."""

    def run(code, *arguments, **how):
        script = tmp_path / "script.py"
        script.write_text(code)
        if bpy.app.binary_path:
            blender = [bpy.app.binary_path, "--background", "--factory-startup", "--python-exit-code", "1", "--python"]
        else:  # Blender as a Python module
            blender = [sys.executable]
        return subprocess.run([*blender, script, "--", *arguments], capture_output=True, text=True, **how)

    return run


@pytest.fixture
def model():
    """Return a flattened model of two good pieces and a closed piece that fails. A wire ends inside a good piece."""
    target = grid("Bump", bump, size=4)
    join_cube(target)
    mark_seam(target, on_line(0, 0.0))
    mark(target, lambda a, b: on_line(1, 0.0)(a, b) and max(a[0], b[0]) < 0.6, kind="ELASTIC", tolerance=0.05)
    flatten_fails("is closed", method="WIREWARP_PLUS_PLUS")
    return target


@pytest.fixture
def everything_answers(model, addon, tmp_path, capfd):
    """Return a function that damages the file with spoil(), then uses every panel, overlay and command.

    in_turn: modes that are given to the objects in turn; None: each object gets both modes
    """

    def shapes():
        present = [bpy.data.objects[name] for name in ("Bump", "Other") if name in bpy.data.objects]
        return [read(each.data.vertices, "co", np.float32, 3) for each in present if each.type == "MESH"]

    def check(spoil, commands=COMMANDS, in_turn=None):
        spoil()
        names = [each.name for each in bpy.context.scene.objects]
        both = itertools.product(names, ("OBJECT", "EDIT"))
        for name, mode in zip(names, itertools.cycle(in_turn), strict=False) if in_turn else both:
            spoil()
            bpy.context.view_layer.update()
            before = shapes()
            use_everything(addon, name, mode, tmp_path, commands)
            for shape, after in zip(before, shapes(), strict=True):
                assert np.array_equal(shape, after, equal_nan=True)
        printed = capfd.readouterr()
        assert "Traceback" not in printed.out + printed.err  # not even from a handler that Blender calls

    return check
