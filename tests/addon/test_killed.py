# SPDX-License-Identifier: GPL-3.0-or-later
"""After Blender is killed during a run, the saved file opens unchanged, and no files are left beside it."""

import signal

import bpy
import pytest
from flattening import wire_marks
from surfaces import bump, flat_of, grid, mark, on_line

SCRIPT = """
import os, signal, sys
import bpy

path, module, where = sys.argv[-3:]
bpy.ops.preferences.addon_enable(module=module)
bpy.ops.wm.open_mainfile(filepath=path)
addon = sys.modules[module]


def die(*_):
    os.kill(os.getpid(), getattr(signal, "SIGKILL", signal.SIGTERM))  # On Windows, SIGTERM is as abrupt.


if where == "solve":
    addon.solve.steps.time.sleep = die  # between two checks of the solver's progress
else:  # after the flat object, before its report
    addon.flatten.write.show_where_shown = die
bpy.ops.object.wirewarp_flatten(report_path=path + ".json")
"""


@pytest.mark.parametrize("where", ["solve", "write"])
def test_the_file_saved_before_is_whole(addon, in_another_blender, tmp_path, where):
    folder = tmp_path / "files"
    folder.mkdir()
    path = folder / "bump.blend"
    source = grid("Bump", bump)
    mark(source, on_line(1, 0.0), kind="ELASTIC", tolerance=0.05)
    marks = wire_marks(source.data)
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    saved = path.read_bytes()
    done = in_another_blender(SCRIPT, path, addon.__name__, where)
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
