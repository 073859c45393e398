# SPDX-License-Identifier: GPL-3.0-or-later
"""Files are written to whatever folder and name the system takes."""

import json

import bpy
import pytest
from surfaces import bump, grid

NAMES = ["two  spaces", "Ärmel für Zoë", "衬衫 シャツ", "قميص", "a.b.c", "long " + "x" * 120]


@pytest.mark.parametrize("name", NAMES)
def test_patterns_and_reports_go_to_folders_of_any_name(tmp_path, addon, name):
    folder = tmp_path / name
    folder.mkdir()
    grid("Bump", bump)
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / f"{name}.blend"))
    bpy.ops.object.wirewarp_flatten(report_path=str(folder / f"{name}.json"))
    endings = addon.core.pattern.FORMATS
    for ending in endings:
        bpy.ops.object.wirewarp_export(filepath=str(folder / f"{name}{ending}"))
        bpy.ops.object.wirewarp_export(filepath=f"//beside {name}{ending}")
        assert (folder / f"{name}{ending}").stat().st_size == (folder / f"beside {name}{ending}").stat().st_size > 0
    assert json.loads((folder / f"{name}.json").read_text(encoding="utf-8"))
    written = {path.name for path in folder.iterdir()}
    assert written == {f"{before}{name}{ending}" for ending in endings for before in ("", "beside ")} | {
        f"{name}.blend",
        f"{name}.json",
    }


@pytest.mark.parametrize("name", ["NUL", "com1", "Con.001", "a/b", "<left>"])
def test_a_name_that_some_system_keeps_for_itself_becomes_another(addon, name):
    ending = ".pdf"
    made = addon.blender.files.file_name(name, ending)
    stem = made.removesuffix(ending)
    assert made.endswith(ending) and stem.split(".")[0].upper() not in ("NUL", "COM1", "CON")
    assert not set(stem) & set('<>:"/\\|?*')
