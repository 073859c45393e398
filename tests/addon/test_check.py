# SPDX-License-Identifier: GPL-3.0-or-later
"""Check and Repair: each kind of fault is counted, shown and repaired, and nothing else is changed."""

import bmesh
import bpy
import numpy as np
import pytest
from surfaces import bump, flat_of, grid, read

pytestmark = pytest.mark.api

CHECK = bpy.ops.object.wirewarp_check
SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
FAULTY = {  # vertices, faces, loose edges, and the number of elements at fault
    "MERGE": ([*SQUARE, (1, 0, 0), (2, 0, 0), (2, 1, 0), (1, 1, 0)], [(0, 1, 2, 3), (4, 5, 6, 7)], [], 2),
    "DISSOLVE": ([*SQUARE, (1, 0.5, 0), (2, 0, 0), (2, 1, 0)], [(0, 1, 4, 2, 3), (1, 5, 6, 2), (1, 2, 4)], [], 1),
    "DUPLICATES": (SQUARE, [(0, 1, 2, 3), (0, 3, 2, 1)], [], 1),
    "LOOSE": ([*SQUARE, (5, 0, 0), (6, 0, 0), (7, 0, 0)], [(0, 1, 2, 3)], [(4, 5)], 1 + 3),
    "NON_MANIFOLD": ([*SQUARE, (1, 0, 1), (1, 1, 1), (2, 0, 0), (2, 1, 0)],
                     [(0, 1, 2, 3), (1, 4, 5, 2), (1, 6, 7, 2)], [], 1),
    "NORMALS": ([*SQUARE, (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],  # a box without a lid, one side inside out
                [(0, 3, 2, 1), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 3, 7, 4)], [], 1),
}  # fmt: skip


def faulty(kind):
    vertices, faces, edges, count = FAULTY[kind]
    mesh = bpy.data.meshes.new(kind)
    mesh.from_pydata(vertices, edges, faces)
    target = bpy.data.objects.new(kind, mesh)
    bpy.context.collection.objects.link(target)
    bpy.context.view_layer.objects.active = target
    target.select_set(True)
    return target, count


def counts(addon, target):
    found = addon.blender.faults.find_faults(target.data)
    return {kind: len(own.vertices) + len(own.edges) + len(own.faces) for kind, own in found.items()}


@pytest.mark.parametrize("kind", FAULTY)
def test_each_kind_is_found_and_repaired(addon, kind, capfd):
    target, count = faulty(kind)
    assert counts(addon, target)[kind] == count
    assert CHECK(repairs={kind}) == {"FINISHED"}
    assert kind not in counts(addon, target)
    fault = next(each for each in addon.blender.faults.FAULTS if each.kind == kind)
    assert f"{fault.text(count)} {fault.done}" in capfd.readouterr().out


@pytest.mark.parametrize("kind", FAULTY)
def test_all_repairs_leave_a_model_that_flattens(addon, kind):
    target, _ = faulty(kind)
    assert CHECK() == {"FINISHED"}
    assert counts(addon, target) == {}
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert addon.state.reports.last_report(target).ok


def test_interior_faces_are_found_and_deleted(addon):
    """A wall between two cubes that share it."""
    grid_of = [(x, y, z) for x in range(3) for y in range(2) for z in range(2)]
    at = {place: index for index, place in enumerate(grid_of)}
    edit = bmesh.new()
    vertices = [edit.verts.new(place) for place in grid_of]
    for x in range(2):
        corners = [vertices[at[x + dx, dy, dz]] for dx in (0, 1) for dy in (0, 1) for dz in (0, 1)]
        sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        for side in sides:
            face = [corners[corner] for corner in side]
            if edit.faces.get(face) is None:
                edit.faces.new(face)
    target, _ = faulty("LOOSE")
    edit.to_mesh(target.data)
    edit.free()
    assert counts(addon, target)["INTERIOR"] == 1
    CHECK(repairs={"INTERIOR"})
    assert len(target.data.polygons) == 10


def test_only_the_kinds_that_are_chosen_are_repaired(addon):
    target, _ = faulty("MERGE")
    assert CHECK(repairs={"LOOSE"}) == {"CANCELLED"}
    assert len(target.data.vertices) == 8


def test_a_good_model_is_not_touched(addon):
    source = grid("Bump", bump)
    before = read(source.data.vertices, "co", np.float32, 3)
    assert counts(addon, source) == {}
    assert CHECK() == {"CANCELLED"}
    assert np.array_equal(read(source.data.vertices, "co", np.float32, 3), before)


@pytest.mark.parametrize("kind", FAULTY)
def test_a_fault_is_shown(addon, kind):
    target, _ = faulty(kind)
    assert bpy.ops.object.wirewarp_show_fault(kind=kind) == {"FINISHED"}
    assert target.mode == "EDIT"
    assert any(vertex.select for vertex in bmesh.from_edit_mesh(target.data).verts)


def test_duplicate_faces_have_check_and_repair_as_the_next_step(addon):
    target, _ = faulty("DUPLICATES")
    with pytest.raises(RuntimeError, match="same"):
        bpy.ops.object.wirewarp_flatten()
    step = addon.report_panel.next_step.next_step(addon.state.reports.last_report(target), [])
    assert step.operator == "object.wirewarp_check"
    CHECK()
    bpy.ops.object.wirewarp_flatten()
    assert flat_of(target)
