# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of earlier versions hold what this one does not write: it is ignored, and goes when the model is flattened."""

import bpy
import numpy as np
import pytest
from everything import draw_panels
from surfaces import bump, flat_of, flatten, grid, mark, mark_seam, on_line, read, select_only

pytestmark = pytest.mark.api


@pytest.fixture
def source():
    """Flattened by an earlier version: texts on the pieces, objects of helper wires, maps, the report of a failure."""
    target = grid("Bump", bump)
    mark_seam(target, on_line(0, 0.0))
    mark(target, on_line(1, 0.0))
    bpy.ops.object.wirewarp_flatten()
    flat = flat_of(target)
    flat["wirewarp_flat"] = 123
    for entry in target.wirewarp_pieces:
        text = new_object(entry.name, bpy.data.curves.new(entry.name, "FONT"), flat)
        text["wirewarp_piece"], text["wirewarp_flat"], text["wirewarp_area"] = entry.piece_id, 123, 2.0
    for owner in (target, flat):
        helpers = new_object(f"{owner.name} Helper Wires", bpy.data.meshes.new("Helper Wires"), owner)
        helpers.data.from_pydata([(0, 0, 0), (1, 0, 0)], [(0, 1)], [])
        helpers.data.attributes.new("helper_wire", "INT", "EDGE")
        helpers["wirewarp_helpers_of"] = owner
        helpers.hide_viewport = helpers.hide_select = True
    target.data.attributes.new("wirewarp_stretch", "FLOAT", "FACE")
    target.data.color_attributes.new("wirewarp_stretch_color", "FLOAT_COLOR", "CORNER")
    target["wirewarp_failure"], target["wirewarp_failure_seal"] = "{}", ""
    bpy.context.scene["wirewarp_settings_of_earlier_versions"] = {"piece_texts": True}
    select_only(target)
    return target


def new_object(name, data, parent):
    made = bpy.data.objects.new(name, data)
    made.parent = parent
    bpy.data.collections["WireWarp"].objects.link(made)
    return made


@pytest.fixture
def reopened(source, tmp_path):
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "old.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "old.blend"))
    found = bpy.data.objects["Bump"]
    select_only(found)
    return found


def test_the_pieces_are_still_ready_to_cut(reopened, addon, tmp_path):
    assert "Ready to cut" in draw_panels(addon)
    path = tmp_path / "pattern.svg"
    assert bpy.ops.object.wirewarp_export_svg(filepath=str(path)) == {"FINISHED"}
    assert path.is_file()


def test_a_run_makes_the_same_pieces_and_takes_the_leftovers_away(reopened):
    before = read(flat_of(reopened).data.vertices, "co", np.float32, 3)
    names = [entry.name for entry in reopened.wirewarp_pieces]
    flatten(reopened)
    flat = flat_of(reopened)
    assert read(flat.data.vertices, "co", np.float32, 3) == pytest.approx(before, abs=1e-5)
    assert [entry.name for entry in reopened.wirewarp_pieces] == names
    assert set(bpy.data.objects) == {reopened, flat}
    assert not bpy.data.curves
    assert [name for name in reopened.data.attributes.keys() if "stretch" in name] == []  # noqa: SIM118
    assert "wirewarp_failure" not in reopened


def test_what_only_has_the_name_of_a_leftover_stays(source):
    """Texts of the user, a child of the model with faces, an attribute of another kind."""
    mine = new_object("Mine", bpy.data.curves.new("Mine", "FONT"), flat_of(source))
    box = new_object("Box", bpy.data.meshes.new("Box"), source)
    box.data.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
    box.data.attributes.new("helper_wire", "INT", "EDGE")
    source.data.attributes.new("wirewarp_aspect_ratio", "INT", "POINT")
    flatten(source)
    assert set(bpy.data.objects) == {source, flat_of(source), mine, box}
    assert "wirewarp_aspect_ratio" in source.data.attributes
