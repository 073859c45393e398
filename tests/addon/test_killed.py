# SPDX-License-Identifier: GPL-3.0-or-later
"""After Blender is killed during a run, the saved file opens unchanged, and no files are left beside it."""

import signal
import subprocess
import sys

import bpy
import pytest
from surfaces import bump, flat_of, grid, mark, on_line, wire_marks

SCRIPT = """
import os, signal, sys
import bpy

path, module, where = sys.argv[-3:]
bpy.ops.preferences.addon_enable(module=module)
bpy.ops.wm.open_mainfile(filepath=path)
addon = sys.modules[module]


def die(*_):
    os.kill(os.getpid(), getattr(signal, "SIGKILL", signal.SIGTERM))  # on Windows, SIGTERM is as abrupt


if where == "solve":
    addon.solve.steps.time.sleep = die  # between two checks of the solver's progress
else:  # after the flat object was written, before its report
    addon.flatten.write.show_where_shown = die
bpy.ops.object.wirewarp_flatten(report_path=path + ".json")
"""


@pytest.mark.parametrize("where", ["solve", "write"])
def test_the_file_saved_before_is_whole(addon, tmp_path, where):
    script = tmp_path / "flatten.py"
    script.write_text(SCRIPT)
    folder = tmp_path / "files"
    folder.mkdir()
    path = folder / "bump.blend"
    source = grid("Bump", bump)
    mark(source, on_line(1, 0.0), kind="ELASTIC", tolerance=0.05)
    marks = wire_marks(source.data)
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    saved = path.read_bytes()
    if bpy.app.binary_path:
        blender = [bpy.app.binary_path, "--background", "--factory-startup", "--python", script, "--"]
    else:  # Blender as a Python module
        blender = [sys.executable, script, "--"]
    done = subprocess.run([*blender, path, addon.__name__, where], capture_output=True, text=True)
    killed = -signal.SIGKILL if hasattr(signal, "SIGKILL") else signal.SIGTERM
    assert done.returncode == killed, done.stdout + done.stderr
    assert [file.name for file in folder.iterdir()] == ["bump.blend"]
    assert path.read_bytes() == saved
    bpy.ops.wm.open_mainfile(filepath=str(path))
    source = bpy.data.objects["Bump"]
    assert (wire_marks(source.data), list(source.data.uv_layers)) == (marks, [])
    assert [each.name for each in bpy.data.objects] == ["Bump"]
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert len(flat_of(source).data.polygons) == 64
