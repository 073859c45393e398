# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of every format are written completely or not at all, under any path that the system allows."""

import errno
import json
import sys
from pathlib import Path

import bpy
import pytest
from surfaces import bump, grid

NAMES = ["two  spaces", "Ärmel für Zoë, 衬衫 シャツ, قميص", "a.b.c", "long " + "x" * 120]


@pytest.mark.parametrize("name", NAMES)
def test_patterns_and_reports_go_to_folders_of_any_name(tmp_path, addon, name):
    folder = tmp_path / name
    folder.mkdir()
    grid("Bump", bump)
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / f"{name}.blend"))
    bpy.ops.object.wirewarp_flatten(report_path=str(folder / f"{name}.json"))
    endings = list(addon.core.pattern.FORMATS)
    assert len(endings) <= len(NAMES)  # so that each format is tested
    ending = endings[NAMES.index(name) % len(endings)]
    bpy.ops.object.wirewarp_export(filepath=str(folder / f"{name}{ending}"))
    bpy.ops.object.wirewarp_export(filepath=f"//beside {name}{ending}")
    assert (folder / f"{name}{ending}").stat().st_size == (folder / f"beside {name}{ending}").stat().st_size > 0
    assert json.loads((folder / f"{name}.json").read_text(encoding="utf-8"))
    written = {path.name for path in folder.iterdir()}
    assert written == {f"{name}.blend", f"{name}.json", f"{name}{ending}", f"beside {name}{ending}"}


@pytest.mark.parametrize(("name", "made"), [("<Front/Back>", "_Front_Back_"), ("/etc", "_etc"), ('a:b\\"c', "a_b__c")])
def test_the_name_proposed_for_a_pattern_is_a_possible_file_name(addon, name, made):
    assert addon.blender.files.file_name(name, " Pattern.svg") == f"{made} Pattern.svg"


def test_a_long_name_is_shortened_before_its_ending(addon):
    made = addon.blender.files.file_name("ä" * 300, " Pattern.svg")
    assert made.startswith("ää") and made.endswith("ä Pattern.svg") and len(made.encode()) <= 255


@pytest.mark.parametrize("name", ["NUL", "com1", "Con.001"])
def test_a_name_that_a_system_reserves_is_changed(addon, name):
    made = addon.blender.files.file_name(name, ".pdf")
    assert made.endswith(".pdf") and made.split(".")[0].upper() not in ("NUL", "COM1", "CON")


def test_a_full_disk_keeps_the_old_file(addon, tmp_path):
    path = tmp_path / "pattern.svg"
    path.write_text("of yesterday")
    full = OSError(errno.ENOSPC, "No space left on device")
    with pytest.raises(OSError, match="No space"), addon.core.pattern.files.replaced_file(path) as unfinished:
        unfinished.write_text("ha")
        raise full
    assert [(each, each.read_text()) for each in tmp_path.iterdir()] == [(path, "of yesterday")]


def test_the_target_of_a_link_is_replaced(addon, tmp_path):
    path, link = tmp_path / "pattern.svg", tmp_path / "newest.svg"
    path.write_text("of yesterday")
    link.symlink_to(path)
    if not link.is_symlink():
        pytest.skip("Wine creates no symbolic links")
    with addon.core.pattern.files.replaced_file(link) as unfinished:
        unfinished.write_text("of today")
    assert link.is_symlink()
    assert path.read_text() == "of today"
    assert {each.name for each in tmp_path.iterdir()} == {"pattern.svg", "newest.svg"}


def test_the_libraries_for_pdf_come_with_the_add_on_and_do_not_change_sys_path(addon):
    inside = Path(addon.core.__file__).parent / "_core"
    if inside.is_dir():
        assert {path.name for path in (inside / "libraries").iterdir()} == {"pyclipper", "pydyf", "uharfbuzz"}
    assert not [folder for folder in sys.path if Path(folder).is_relative_to(inside)]
