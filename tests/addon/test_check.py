# SPDX-License-Identifier: GPL-3.0-or-later
"""Check and Repair counts, shows and repairs each kind of fault, and changes nothing else."""

import itertools

import bmesh
import bpy
import numpy as np
import pytest
from flattening import flatten_fails, flattened, wire_marks
from surfaces import bump, flat_of, grid, make_object, on_line, read, select_only

pytestmark = pytest.mark.api

CHECK = bpy.ops.object.wirewarp_check
KINDS = ("MERGE", "DISSOLVE", "DUPLICATES", "INTERIOR", "LOOSE", "NON_MANIFOLD", "NORMALS")
SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
FAULTY = {  # meshes: vertices, faces, loose edges, and the number of faulty elements
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
    return make_object(kind, vertices, faces, edges), count


def repair(kind):
    return CHECK(**{each.lower(): each == kind for each in KINDS})


def counts(addon, target):
    found = addon.blender.faults.find_faults(target.data)
    return {kind: len(own.vertices) + len(own.edges) + len(own.faces) for kind, own in found.items()}


@pytest.mark.parametrize("kind", FAULTY)
def test_each_kind_is_found_and_repaired(addon, kind, capfd):
    target, count = faulty(kind)
    assert counts(addon, target)[kind] == count
    before = counts(addon, target)
    assert repair("LOOSE" if kind != "LOOSE" else "MERGE") == {"FINISHED"}  # the repair of another kind
    assert counts(addon, target) == before
    assert repair(kind) == {"FINISHED"}
    assert kind not in counts(addon, target)
    fault = next(each for each in addon.blender.faults.FAULTS if each.kind == kind)
    assert f"{fault.text(count)} {fault.done}" in capfd.readouterr().out


@pytest.mark.parametrize("kind", FAULTY)
def test_a_fault_is_shown_and_all_repairs_leave_a_model_that_flattens(addon, kind):
    target, _ = faulty(kind)
    assert bpy.ops.object.wirewarp_show_fault(kind=kind) == {"FINISHED"}
    assert target.mode == "EDIT"
    assert any(vertex.select for vertex in bmesh.from_edit_mesh(target.data).verts)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert CHECK() == {"FINISHED"}
    assert counts(addon, target) == {}
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert addon.state.reports.last_report(target).ok


def block(size, missing=()):
    """Return a block of size[k] cells along axis k, with walls between the cells. missing: cells to omit."""
    faces = {}  # corners of each face, keyed by their set, so that a wall between two cells is one face
    for cell in set(itertools.product(*map(range, size))) - set(missing):
        for axis, end in itertools.product(range(3), (0, 1)):
            corners = np.array([cell] * 4)
            corners[:, axis] += end
            corners[:, [other for other in range(3) if other != axis]] += [(0, 0), (1, 0), (1, 1), (0, 1)]
            places = [tuple(corner) for corner in corners.tolist()]
            faces[frozenset(places)] = places
    vertices = sorted(frozenset().union(*faces))
    return make_object("Block", vertices, [[vertices.index(each) for each in places] for places in faces.values()])


# Without these two cells, the block has a cave from its left side to its middle. Its walls face each other.
CAVE = ((0, 1, 1), (1, 1, 1))


@pytest.mark.parametrize(
    ("size", "missing", "inside"),
    [((2, 1, 1), (), 1), ((3, 3, 3), (), 3 * 2 * 9), ((3, 3, 3), CAVE, 3 * 2 * 9 - (6 + 5 - 1))],
)
def test_walls_inside_are_found_but_no_face_that_is_seen_from_outside(addon, size, missing, inside):
    target = block(size, missing)
    shell = len(target.data.polygons) - inside
    assert counts(addon, target)["INTERIOR"] == inside
    assert CHECK() == {"FINISHED"}  # By default, walls inside are not removed.
    assert counts(addon, target)["INTERIOR"] == inside
    repair("INTERIOR")
    assert len(target.data.polygons) == shell


def test_after_a_merge_only_faces_with_the_same_vertices_are_duplicates(addon):
    target, _ = faulty("MERGE")  # two squares
    assert addon.blender.faults.repair_faults(target.data, ["MERGE", "DUPLICATES"]) == {"MERGE": 2}
    assert len(target.data.polygons) == 2


def test_a_repair_keeps_seams_wires_and_maps(addon):
    source = grid("Bump", bump, size=4, seam=on_line(0, 0.0), wire=on_line(1, 0.0))
    source.data.uv_layers.new(name="Own")
    source.data.vertices.add(1)  # loose

    def marked():
        return sum(edge.use_seam for edge in source.data.edges), len(wire_marks(source.data))

    before = marked()
    assert CHECK() == {"FINISHED"} and marked() == before
    assert source.data.uv_layers[0].name == "Own" and len(source.data.vertices) == 25


def test_a_repair_leaves_edit_mode_of_the_pieces_so_that_undo_restores_the_model(addon):
    source = flattened("Bump", bump, size=4)
    source.data.vertices.add(1)
    select_only(flat_of(source))
    bpy.ops.object.mode_set(mode="EDIT")
    assert CHECK() == {"FINISHED"}
    assert bpy.context.mode == "OBJECT" and len(source.data.vertices) == 25


def test_a_good_model_does_not_change(addon):
    source = grid("Bump", bump)
    before = read(source.data.vertices, "co", np.float32, 3)
    assert counts(addon, source) == {}
    assert CHECK() == {"CANCELLED"}
    assert np.array_equal(read(source.data.vertices, "co", np.float32, 3), before)


def test_duplicate_faces_have_check_and_repair_as_the_next_step(addon):
    target, _ = faulty("DUPLICATES")
    flatten_fails("same")
    step = addon.report_panel.next_step.next_step(addon.state.reports.last_report(target), [])
    assert step.operator == "object.wirewarp_check"
    CHECK()
    bpy.ops.object.wirewarp_flatten()
    assert flat_of(target)


@pytest.mark.parametrize(("shift", "apart", "merged"), [(1000.0, 0.005, 0), (1000.0, 0.00012, 2), (0.0, 1e-5, 2)])
def test_the_merge_distance_depends_on_the_size_and_not_on_the_place_of_the_model(addon, shift, apart, merged):
    """Two squares of side 1 are `apart` from each other. Each square has two vertices beside the gap."""
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    left, right = ([(shift + x + dx, y, 0.0) for x, y in corners] for dx in (0.0, 1.0 + apart))
    source = make_object("Squares", left + right, [(0, 1, 2, 3), (4, 5, 6, 7)])
    assert addon.blender.faults.repair_faults(source.data, ["MERGE"]).get("MERGE", 0) == merged
