# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks are mesh attributes: they go where the mesh goes."""

import bpy
import pytest
from surfaces import bump, grid, mark, mark_seam, on_line, select_only, wire_marks

pytestmark = pytest.mark.api


@pytest.fixture
def marked():
    target = grid("Bump", bump)
    mark(target, on_line(1, 0.0), kind="ELASTIC", tolerance=0.05)
    mark(target, on_line(0, 0.0), kind="SUPER_ELASTIC")
    mark_seam(target, on_line(0, 0.5))
    return target


def test_save_and_load(marked, tmp_path):
    marked.data.wirewarp_names[0].name = "Bust"
    before = wire_marks(marked.data)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "marked.blend"))
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "marked.blend"))
    loaded = bpy.data.objects["Bump"]
    assert wire_marks(loaded.data) == before
    assert loaded.data.wirewarp_names[0].name == "Bust"


def test_duplicate(marked):
    before = wire_marks(marked.data)
    bpy.ops.object.duplicate()
    assert bpy.context.active_object is not marked
    assert wire_marks(bpy.context.active_object.data) == before


def test_append(marked, tmp_path):
    before = wire_marks(marked.data)
    path = str(tmp_path / "marked.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    with bpy.data.libraries.load(path) as (_, wanted):
        wanted.objects = ["Bump"]
    assert wire_marks(wanted.objects[0].data) == before


def test_join_keeps_both_objects_wires(marked):
    other = grid("Other", bump)
    mark(other, on_line(1, 0.25))
    both = wire_marks(marked.data) | wire_marks(other.data)
    select_only(marked, other)
    bpy.ops.object.join()
    assert wire_marks(marked.data) == both


def test_names_of_joined_wires_are_saved(marked, addon, tmp_path):
    other, foreign = grid("Other", bump), grid("Foreign", bump)
    mark(other, on_line(1, 0.25))
    other.data.wirewarp_names[0].name = "Hip"
    foreign.data.attributes.new("wirewarp_wire", "FLOAT", "POINT")  # not ours: left alone
    select_only(marked, other)
    bpy.ops.object.join()
    path = str(tmp_path / "joined.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.ops.wm.open_mainfile(filepath=path)
    names = [name for name, _ in addon.state.identities.listed_wires(bpy.data.objects["Bump"])]
    assert names == ["Wire 1", "Wire 2", "Hip"]


def test_join_into_an_object_without_marks(marked):
    before = wire_marks(marked.data)
    bare = grid("Bare", bump)
    select_only(bare, marked)
    bpy.ops.object.join()
    assert wire_marks(bare.data) == before
