# SPDX-License-Identifier: GPL-3.0-or-later
"""Models with modifiers and shape keys, and messages about ignored ones."""

import bpy
import pytest
from surfaces import bump, flat_of, grid, mark, mark_seam, on_line, select_only

pytestmark = pytest.mark.api


@pytest.mark.parametrize(
    ("kind", "settings", "faces"),
    [
        ("SUBSURF", {"levels": 1}, 64),
        ("ARRAY", {"count": 3, "relative_offset_displace": (1.5, 0, 0)}, 48),
        ("MIRROR", {"use_axis": (False, False, True), "use_mirror_merge": False}, 32),
        ("TRIANGULATE", {}, 32),
    ],
)
def test_modifiers_that_make_other_faces_go_to_the_flat_object_only(addon, kind, settings, faces):
    source = grid("Bump", bump, size=4)
    mark_seam(source, on_line(0, 0.0))
    mark(source, on_line(1, 0.0))
    modifier = source.modifiers.new("Modifier", kind)
    for name, value in settings.items():
        setattr(modifier, name, value)
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    assert len(flat_of(source).data.polygons) == faces
    assert "WireWarp" not in source.data.uv_layers
    assert ignored_after(addon, source) == "Modifiers"
    assert len(flat_of(source).data.polygons) == 16


def notes_after(addon, source, **settings):
    bpy.ops.object.wirewarp_flatten(**settings)
    return [note.text for note in addon.state.reports.last_report(source).notes]


def test_what_is_shown_but_not_flattened_is_said(addon):
    source = grid("Bump", bump)
    source.shape_key_add(name="Basis")
    key = source.shape_key_add(name="Taller")
    key.value = 0  # Blender 5 starts with 1
    source.modifiers.new("Shading", "WEIGHTED_NORMAL")  # moves nothing
    assert notes_after(addon, source) == []
    key.data[40].co.z += 1
    key.value = 1
    assert ignored_after(addon, source) == "Modifiers and shape keys"
    source.modifiers.clear()
    assert ignored_after(addon, source) == "Shape keys"
    source.modifiers.new("Smooth", "SUBSURF").levels = 1
    assert ignored_after(addon, source) == "Modifiers and shape keys"


def ignored_after(addon, source):
    """Return what a run reports as ignored; the pieces are then not ready to cut."""
    bpy.ops.object.wirewarp_flatten()
    level, text = addon.solve.report.run_message([addon.state.reports.last_report(source)])
    assert level == "WARNING" and "Lengths are exact" not in text
    return text.removesuffix(" were ignored, so sizes differ from what you see.")


def test_modifiers_that_change_nothing_are_not_told(addon):
    """An armature at rest and an edge split: the verdict is green."""
    source = grid("Bump", bump)
    bpy.ops.object.armature_add()
    armature = bpy.context.object
    source.vertex_groups.new(name=armature.data.bones[0].name).add(range(81), 1.0, "REPLACE")
    source.modifiers.new("Armature", "ARMATURE").object = armature
    select_only(source)
    assert "Lengths are exact" in message_after(addon, source)
    source.modifiers.new("Split", "EDGE_SPLIT").split_angle = 0
    assert "Lengths are exact" in message_after(addon, source)
    armature.pose.bones[0].location.y = 0.5
    assert ignored_after(addon, source) == "Modifiers"


def message_after(addon, source):
    bpy.ops.object.wirewarp_flatten()
    return addon.solve.report.run_message([addon.state.reports.last_report(source)])[1]


def test_shape_keys_are_flattened_with_the_modifiers():
    source = grid("Bump", bump)
    source.shape_key_add(name="Basis")
    key = source.shape_key_add(name="Wider")
    for point in key.data:
        point.co.x *= 2
    key.value = 1
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    wide = grid("Wide", lambda x, y: (2 * x, *bump(x, y)[1:]))
    bpy.ops.object.wirewarp_flatten()
    areas = [sum(face.area for face in flat_of(target).data.polygons) for target in (source, wide)]
    assert areas[0] == pytest.approx(areas[1], rel=1e-4)


def test_an_old_uv_map_is_said_not_to_belong_to_pieces_with_modifiers(addon):
    source = grid("Bump", bump)
    bpy.ops.object.wirewarp_flatten()
    source.modifiers.new("Smooth", "SUBSURF").levels = 1
    (note,) = notes_after(addon, source, use_modifiers=True)
    assert note == 'The UV map "WireWarp" is from an earlier run without Modifiers. It does not show these pieces.'
