# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are there whole or not at all."""

import errno

import pytest


def test_a_disk_that_is_full_leaves_the_file_that_was_there(addon, tmp_path):
    path = tmp_path / "pattern.svg"
    path.write_text("of yesterday")
    full = OSError(errno.ENOSPC, "No space left on device")
    with pytest.raises(OSError, match="No space"), addon.blender.files.replaced_file(path) as unfinished:
        unfinished.write_text("ha")
        raise full
    assert [(each, each.read_text()) for each in tmp_path.iterdir()] == [(path, "of yesterday")]


def test_the_file_that_a_link_leads_to_is_replaced(addon, tmp_path):
    path, link = tmp_path / "pattern.svg", tmp_path / "newest.svg"
    path.write_text("of yesterday")
    link.symlink_to(path)
    if not link.is_symlink():
        pytest.skip("Wine makes no links")
    with addon.blender.files.replaced_file(link) as unfinished:
        unfinished.write_text("of today")
    assert link.is_symlink()
    assert path.read_text() == "of today"
    assert {each.name for each in tmp_path.iterdir()} == {"pattern.svg", "newest.svg"}
