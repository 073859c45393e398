# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs in a thread, and what is made again by itself. The window's part of both: tests/window."""

import threading

import bmesh
import bpy
import numpy as np
import pytest
from surfaces import bump, flat_of, flatten, grid, half_cylinder, mark, mark_seam, on_line, read, select_only


def read_models(addon, *sources):
    return addon.run.read.read_models(bpy.context, list(sources), bpy.context.scene.wirewarp)


def solver(addon, models):
    choices = addon.properties.choices_of(bpy.context.scene.wirewarp, 1.0)
    return lambda progress: addon.run.models.solve_models(addon.core.library(), models, choices, 1.0, progress)


def test_a_thread_gives_what_the_solver_gives_and_tells_how_far_it_is(addon):
    models = read_models(addon, grid("First", bump), grid("Second", half_cylinder))
    fractions = []

    def solve(progress):
        def report(stage, fraction):
            fractions.append(fraction)
            return progress(stage, fraction)

        return solver(addon, models)(report)

    thread = addon.run.thread.WorkThread(solve)
    outcomes = thread.result()
    assert thread.is_done()
    assert [outcome.report["object"] for outcome in outcomes] == ["First", "Second"]
    assert all(outcome.report["ok"] for outcome in outcomes)
    assert fractions == sorted(fractions)
    assert thread.fraction == fractions[-1] <= 1
    assert any(fraction < 0.5 for fraction in fractions)


def test_a_thread_that_was_cancelled_in_time_has_no_result(addon):
    models = read_models(addon, grid("Bump", bump))
    begun, goes_on = threading.Event(), threading.Event()

    def solve(progress):
        begun.set()
        goes_on.wait()
        return solver(addon, models)(progress)

    thread = addon.run.thread.WorkThread(solve)
    begun.wait()
    thread.cancel()
    goes_on.set()
    with pytest.raises(addon.run.thread.CancelledError):
        thread.result()
    done = addon.run.thread.WorkThread(lambda _progress: [])
    done.join()
    done.cancel()
    assert done.result() == []  # as a file that was written


def test_what_the_solver_raises_is_raised_where_the_result_is_asked_for(addon):
    def solve(_progress):
        raise MemoryError("no room")

    thread = addon.run.thread.WorkThread(solve)
    with pytest.raises(MemoryError, match="no room"):
        thread.result()


def test_a_cancelled_model_ends_the_whole_run(addon):
    """The core would hand back the best shape it has; the others would be solved."""
    models = read_models(addon, grid("First", bump), grid("Second", bump))
    seen = []
    with pytest.raises(addon.run.thread.CancelledError):
        solver(addon, models)(lambda stage, fraction: bool(seen.append(fraction)) or stage != "shape")
    assert max(seen) < 0.5


@pytest.fixture
def source():
    target = grid("Bump", bump)
    mark(target, on_line(1, 0.0))
    bpy.ops.object.wirewarp_flatten()
    select_only(target)
    return target


def taken(addon):
    bpy.context.view_layer.update()
    return [target.name for target in addon.run.auto_update.take_changed(bpy.context)]


def move_a_vertex(source):
    source.data.vertices[40].co.z += 0.01
    source.data.update()


def test_only_what_changed_and_has_pieces_is_made_again(addon, source):
    grid("Never Flattened", bump)
    assert taken(addon) == []
    move_a_vertex(source)
    assert taken(addon) == ["Bump"]
    assert taken(addon) == []  # tried once
    mark_seam(source, on_line(0, 0.0))
    assert taken(addon) == ["Bump"]


def test_changes_are_seen_in_edit_mode(addon, source):
    bpy.ops.object.mode_set(mode="EDIT")
    assert taken(addon) == []
    edit = bmesh.from_edit_mesh(source.data)
    edit.edges.ensure_lookup_table()
    edit.edges[20].seam = True
    bmesh.update_edit_mesh(source.data)
    assert taken(addon) == ["Bump"]


def test_nothing_is_made_again_after_undo_until_something_changes(addon, source):
    bpy.context.scene.wirewarp.auto_update = True
    move_a_vertex(source)
    addon.run.auto_update.note_undo()
    assert taken(addon) == []
    assert taken(addon) == []
    move_a_vertex(source)
    assert taken(addon) == ["Bump"]


def test_switching_off_and_on_after_undo_does_not_hide_the_next_change(addon, source):
    scene = bpy.context.scene
    scene.wirewarp.auto_update = True
    addon.run.auto_update.note_undo()
    scene.wirewarp.auto_update = False
    addon.run.auto_update.forget_change(scene.name_full)  # as with the next movement of the mouse
    scene.wirewarp.auto_update = True
    move_a_vertex(source)
    assert taken(addon) == ["Bump"]


def test_there_is_no_second_run_beside_another(addon, source, monkeypatch):
    assert bpy.ops.object.wirewarp_update.poll()
    monkeypatch.setattr(addon.run.window_run, "is_running", lambda: True)
    assert not bpy.ops.object.wirewarp_update.poll()


def test_an_update_takes_the_undo_group_of_the_last_operator(addon):
    """No operator is unregistered for it, which would take Adjust Last Operation away; in the end all go."""
    updating = addon.operators.update.updating_in
    idnames = [updating(group).idname_py() for group in ("Move", "Mark Seam", "Move", "Update Flat Pieces")]
    assert len(set(idnames)) == 3 and idnames[0] == idnames[2] and idnames[3] == "object.wirewarp_update"
    joining = addon.operators.update._joining
    assert {group: cls.bl_undo_group for group, cls in joining.items()} == {group: group for group in joining}
    assert all(cls.is_registered and cls.bl_options == {"INTERNAL", "UNDO_GROUPED"} for cls in joining.values())
    addon.unregister()
    assert not any(hasattr(bpy.types, f"OBJECT_OT_wirewarp_update_{number}") for number in (1, 2))
    addon.register()


def test_what_goes_wrong_while_the_pieces_are_made_leaves_the_file_as_it_was(addon, source, monkeypatch):
    flatten(source)
    flat, meshes = flat_of(source), {mesh.name for mesh in bpy.data.meshes}
    before = read(flat.data.vertices, "co", np.float32, 3), source["wirewarp_report"], flat.data.name

    def fail(*_):
        raise MemoryError("no room")

    monkeypatch.setattr(addon.flat.object, "write_maps", fail)
    source.data.vertices[0].co.z += 1
    with pytest.raises(RuntimeError, match="no room"):
        bpy.ops.object.wirewarp_flatten()
    assert {mesh.name for mesh in bpy.data.meshes} == meshes
    assert np.array_equal(read(flat.data.vertices, "co", np.float32, 3), before[0])
    assert (source["wirewarp_report"], flat.data.name) == before[1:]


def test_another_grain_wire_is_due_once(addon, source):
    assert taken(addon) == []
    bpy.ops.mesh.wirewarp_grain_wire(edge=addon.model.wires.find_wires(source)[0].edges[0])
    assert taken(addon) == ["Bump"]
    bpy.ops.object.wirewarp_flatten()
    assert taken(addon) == []


def test_a_model_that_cannot_be_read_is_tried_once_whatever_its_grain_wire(addon, source):
    bpy.ops.mesh.wirewarp_grain_wire(edge=addon.model.wires.find_wires(source)[0].edges[0])
    bpy.ops.object.wirewarp_flatten()
    source.scale.x = 0.0
    assert taken(addon) == ["Bump"]
    with pytest.raises(RuntimeError, match="scaled to zero"):
        bpy.ops.object.wirewarp_flatten()
    assert taken(addon) == []
