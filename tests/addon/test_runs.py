# SPDX-License-Identifier: GPL-3.0-or-later
"""A run has steps, and Blender responds between them. Auto updates changed models.

tests/window tests runs and updates in a window.
"""

import weakref
from pathlib import Path
from unittest.mock import MagicMock

import bmesh
import bpy
import numpy as np
import pytest
from everything import draw_panels
from flattening import flatten, flatten_fails, flattened, raise_vertex
from surfaces import bump, flat_of, grid, mark_seam, on_line, read


def read_models(addon, *sources):
    return addon.flatten.read.read_models(bpy.context, list(sources), bpy.context.scene.wirewarp)


def solving(addon, *sources):
    choices = addon.state.settings.choices_of(bpy.context.scene.wirewarp, 1.0)
    return addon.flatten.models.solve_models(read_models(addon, *sources), choices, 1.0)


def test_a_run_reports_its_progress(addon):
    reported = []
    outcomes = addon.solve.steps.in_one_go(solving(addon, grid("First", bump), grid("Second", bump)), reported.append)
    assert [outcome.report.object for outcome in outcomes] == ["First", "Second"]
    assert all(outcome.report.ok for outcome in outcomes)
    assert reported == sorted(reported) and {0.5, 1.0} <= set(reported)


@pytest.fixture
def started(addon, monkeypatch):
    """Return a list that collects weak references to all jobs of the core that start from now on.

    If a reference is dead, the threads of its job have ended.
    """
    jobs, start = [], addon.solve.flatten.start

    def remember(*what, **options):
        job = start(*what, **options)
        jobs.append(weakref.ref(job))
        return job

    monkeypatch.setattr(addon.solve.flatten, "start", remember)
    return jobs


def test_an_abandoned_run_is_canceled_in_the_core_too(addon, started):
    steps = solving(addon, grid("First", bump, size=200), grid("Second", bump))
    assert 0 <= next(steps) < 0.5
    (reference,) = started
    job = reference()
    steps.close()
    assert [piece.error.code for piece in job.result().pieces] == ["cancelled"]
    del job
    addon.solve.flatten.drop_jobs()
    assert reference() is None


@pytest.mark.parametrize("how", ["another file", "the add-on disabled"])
def test_a_run_ends_if_another_file_is_opened_or_the_add_on_disabled(addon, started, how):
    window_run, context = addon.ui.window_run, MagicMock()
    run = window_run.begin(context, window_run.FLATTEN, "Large", solving(addon, grid("Large", bump, size=200)))
    run.go_on()
    assert window_run.is_running() and not run.is_done
    if how == "another file":
        bpy.ops.wm.read_homefile(use_empty=True)
    else:
        addon.unregister()
    assert not window_run.is_running()
    assert [job() for job in started] == [None]
    manager = context.window_manager
    manager.event_timer_remove.assert_called_once_with(manager.event_timer_add.return_value)
    if how != "another file":
        addon.register()


QUITS = """
import sys
import bpy
folder, module = sys.argv[-2:]
sys.path.insert(0, folder)
bpy.ops.preferences.addon_enable(module=module)
from surfaces import bump, grid
addon = sys.modules[module]
choices = addon.state.settings.choices_of(bpy.context.scene.wirewarp, 1.0)
models = addon.flatten.read.read_models(bpy.context, [grid("Large", bump, size=200)], bpy.context.scene.wirewarp)
kept = addon.flatten.models.solve_models(models, choices, 1.0)
next(kept)
print("the end")
"""


def test_blender_ends_during_a_run(addon, in_another_blender):
    done = in_another_blender(QUITS, str(Path(__file__).parent), addon.__name__, timeout=300)
    assert done.returncode == 0 and "the end" in done.stdout, done.stdout + done.stderr


@pytest.fixture
def begun(addon):
    """Return a function that begins a run of these steps in a window, and returns the run after its first step."""

    def begin(steps):
        window_run = addon.ui.window_run
        run = window_run.begin(MagicMock(), window_run.FLATTEN, "Nothing", steps)
        run.go_on()
        return run

    yield begin
    assert not addon.ui.window_run.is_running()


def test_a_finished_run_may_still_be_canceled(addon, begun):
    """A finished update waits for a movement of the mouse before it writes."""
    run = begun(solving(addon))
    assert run.is_done
    addon.ui.window_run.cancel()
    with pytest.raises(addon.ui.window_run.CanceledError):
        run.result()


def test_canceled_extra_work_keeps_the_result(addon, begun):
    def with_extra():
        yield 0.5
        try:
            yield 0.7
        except addon.solve.steps.CanceledError:
            return "the pieces"

    run = begun(addon.solve.steps.reported_as(with_extra(), lambda share: share))
    run.go_on()
    assert not run.was_stopped
    addon.ui.window_run.cancel()
    assert run.was_stopped and run.is_done and run.result() == "the pieces"


def stubborn():
    try:
        yield 0.5
    finally:
        raise OSError("no disk")


def failing():
    yield 0.5
    raise MemoryError("no room")


@pytest.mark.parametrize(("work", "error"), [(stubborn, OSError), (failing, MemoryError)])
def test_exceptions_of_the_work_are_raised_with_the_result(addon, begun, work, error):
    """stubborn() fails when it is canceled, failing() by itself."""
    run = begun(work())
    if work is stubborn:
        addon.ui.window_run.cancel()
    while not run.is_done:
        run.go_on()
    with pytest.raises(error, match="^no "):
        run.result()


@pytest.fixture
def source():
    return flattened("Bump", bump, wire=on_line(1, 0.0))


def taken(addon):
    bpy.context.view_layer.update()
    return [target.name for target in addon.flatten.auto_update.take_changed(bpy.context)]


def test_only_changed_models_with_pieces_are_updated(addon, source):
    grid("Never Flattened", bump)
    assert taken(addon) == []
    raise_vertex(source)
    assert taken(addon) == ["Bump"]
    assert taken(addon) == []  # Auto tries each change once.
    mark_seam(source, on_line(0, 0.0))
    assert taken(addon) == ["Bump"]
    bpy.ops.object.mode_set(mode="EDIT")
    assert taken(addon) == []
    edit = bmesh.from_edit_mesh(source.data)
    edit.edges.ensure_lookup_table()
    edit.edges[20].seam = True
    bmesh.update_edit_mesh(source.data)
    assert taken(addon) == ["Bump"]


def test_nothing_is_updated_after_undo_until_something_changes(addon, source):
    scene, auto = bpy.context.scene, addon.flatten.auto_update
    scene.wirewarp.auto_update = True
    raise_vertex(source)
    auto.note_undo()
    assert taken(addon) == [] and taken(addon) == []
    raise_vertex(source)
    assert taken(addon) == ["Bump"]
    auto.note_undo()
    scene.wirewarp.auto_update = False
    auto.forget_change(scene)  # as a movement of the mouse does
    scene.wirewarp.auto_update = True
    raise_vertex(source)
    assert taken(addon) == ["Bump"]


def test_a_second_run_is_refused(addon, source, monkeypatch):
    assert bpy.ops.object.wirewarp_update.poll()
    monkeypatch.setattr(addon.ui.window_run, "is_running", lambda: True)
    assert not bpy.ops.object.wirewarp_update.poll()


def test_an_update_takes_the_undo_group_of_the_last_operator(addon):
    """An operator is registered for each undo group. It stays registered until the add-on is disabled,
    because unregistering an operator would remove the panel Adjust Last Operation.
    """
    updating = addon.flatten.auto_update.updating_in
    idnames = [updating(group).idname_py() for group in ("Move", "Mark Seam", "Move", "Update Flat Pieces")]
    assert len(set(idnames)) == 3 and idnames[0] == idnames[2] and idnames[3] == "object.wirewarp_update"
    joining = [getattr(bpy.types, f"OBJECT_OT_wirewarp_update_{number}") for number in (0, 1)]
    assert [cls.bl_undo_group for cls in joining] == ["Move", "Mark Seam"]
    assert all(cls.is_registered and cls.bl_options == {"INTERNAL", "UNDO_GROUPED"} for cls in joining)
    most = addon.flatten.auto_update.MOST
    idnames = {updating(f"Group {number}").idname_py() for number in range(2 * most)}
    # Two operators are for the groups above. When MOST operators are in use, all further groups have one operator in
    # common, whose updates are undo steps of their own.
    assert len(idnames) == most - 2 + 1
    addon.unregister()
    assert not any(hasattr(bpy.types, f"OBJECT_OT_wirewarp_update_{number}") for number in range(most))
    addon.register()


def test_a_model_whose_update_was_canceled_says_what_to_do(addon, source, monkeypatch):
    canceled, coming = "Auto was canceled for this change", "Auto updates the pieces when the tool ends."
    bpy.context.scene.wirewarp.auto_update = True
    raise_vertex(source)
    assert canceled not in draw_panels(addon)
    bpy.ops.object.wirewarp_flatten()
    raise_vertex(source)
    assert coming in draw_panels(addon)
    assert taken(addon) == ["Bump"]  # an update begins with the same call
    with monkeypatch.context() as patched:
        patched.setattr(addon.report_panel.flatten_panel, "is_running", lambda _: True)
        shown = draw_panels(addon)
        assert coming in shown and canceled not in shown and "has changed since" not in shown
    assert canceled in draw_panels(addon)
    raise_vertex(source)
    assert canceled not in draw_panels(addon)
    assert taken(addon) == ["Bump"]
    bpy.ops.object.wirewarp_flatten()
    assert canceled not in draw_panels(addon)


def test_an_exception_while_pieces_are_made_does_not_change_the_file(addon, source, monkeypatch):
    flatten(source)
    flat, meshes = flat_of(source), {mesh.name for mesh in bpy.data.meshes}
    before = read(flat.data.vertices, "co", np.float32, 3), source["wirewarp_report"], flat.data.name

    def fail(*_):
        raise MemoryError("no room")

    monkeypatch.setattr(addon.flatten.flat_object, "write_maps", fail)
    source.data.vertices[0].co.z += 1
    flatten_fails("no room")
    assert {mesh.name for mesh in bpy.data.meshes} == meshes
    assert np.array_equal(read(flat.data.vertices, "co", np.float32, 3), before[0])
    assert (source["wirewarp_report"], flat.data.name) == before[1:]


def test_another_grain_wire_updates_once_and_an_unreadable_model_is_tried_once(addon, source):
    assert taken(addon) == []
    bpy.ops.mesh.wirewarp_grain_wire(edge=addon.state.identities.find_wires(source)[0].edges[0])
    assert taken(addon) == ["Bump"]
    bpy.ops.object.wirewarp_flatten()
    assert taken(addon) == []
    source.scale.x = 0.0
    assert taken(addon) == ["Bump"]
    flatten_fails("scaled to zero")
    assert taken(addon) == []
