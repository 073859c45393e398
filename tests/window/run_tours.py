# SPDX-License-Identifier: GPL-3.0-or-later
"""Tours through runs that are canceled, fail or are disturbed."""

import json
from pathlib import Path
from threading import Event

import bpy
import drive
import wirewarp_addon
from stage import contents, flatten, hold_runs, marked_bump, redo, remember, undo, window_run
from surfaces import bump, flat_of, grid, tube

solve_models = wirewarp_addon.flatten.models


def collect_messages() -> list[tuple[str, str]]:
    """Return a list to which each later message of an operator is added, as (level, message)."""
    messages = []
    steps = wirewarp_addon.flatten.operators.FlattenSteps
    drive.replace(steps, "message", lambda _operator, level, text: messages.append((level, text)))
    return messages


def begin_held_run() -> Event:
    """Start a run that waits until the returned event is set or the run is canceled. Later runs also wait for it."""
    goes_on = hold_runs()
    with drive.in_view():
        bpy.ops.object.wirewarp_flatten("INVOKE_DEFAULT", True)
    assert window_run.is_running()
    return goes_on


def escape_cancels() -> drive.Tour:
    """Esc ends a long run and leaves the file unchanged. Flatten then works again."""
    large = grid("Large", bump, size=300)
    remember()
    before, messages = contents(large), collect_messages()
    with drive.in_view():
        bpy.ops.object.wirewarp_flatten("INVOKE_DEFAULT", True)
    yield from drive.press("ESC")
    yield lambda: not window_run.is_running()
    assert contents(large) == before
    assert messages == [("WARNING", "Flatten was canceled. Nothing was written.")]
    source = grid("Next", bump)
    yield from flatten()
    assert flat_of(source)


def only_one_run() -> drive.Tour:
    """During a run, the user can move the view, but cannot edit or start a second run."""
    source = marked_bump()
    goes_on = begin_held_run()
    try:
        bpy.ops.object.wirewarp_flatten()
    except RuntimeError as error:
        assert "Flatten is still running" in str(error)
    else:
        raise AssertionError("a second run was begun")
    view = drive.view_area().spaces.active.region_3d
    assert view.view_perspective == "PERSP"
    yield from drive.press("NUMPAD_5")
    yield lambda: view.view_perspective == "ORTHO"
    yield from drive.press("TAB")
    yield from drive.ticks(20)
    assert source.mode == "OBJECT"
    drive.screenshot("only_one_run")
    goes_on.set()
    yield lambda: not window_run.is_running()
    assert "Bump Flat" in bpy.data.objects


def a_changed_model_is_not_written() -> drive.Tour:
    source = marked_bump()
    before, messages = contents(source), collect_messages()
    goes_on = begin_held_run()
    source.data.vertices[40].co.z += 0.01
    source.data.update()
    goes_on.set()
    yield lambda: not window_run.is_running()
    assert contents(source) == before
    sentence = '"Bump" changed during the run, so nothing was written. Flatten again.'
    assert messages == [("ERROR", sentence)]


def a_failed_piece_opens_no_window() -> drive.Tour:
    """A failed piece is a warning, because the window of an error would cover the button Flatten."""
    tube()
    remember()
    messages = collect_messages()
    yield from flatten()
    ((level, sentence),) = messages
    assert level == "WARNING" and "mark a seam" in sentence
    yield from drive.ticks(10)
    drive.screenshot("a_failed_piece")


def a_fault_of_the_core_is_reported() -> drive.Tour:
    """Any exception becomes an error message, and the file stays unchanged."""

    def fail(*_: object) -> None:
        raise MemoryError("no room for 8 GB")

    drive.replace(solve_models, "flatten_arrays", fail)
    source = marked_bump()
    before, messages = contents(source), collect_messages()
    path = Path(bpy.app.tempdir) / "report.json"
    with drive.in_view():
        bpy.ops.object.wirewarp_flatten("INVOKE_DEFAULT", True, report_path=str(path))
    yield lambda: not window_run.is_running()
    assert contents(source) == before
    (report,) = json.loads(path.read_text())["objects"]
    assert (report["object"], report["issues"][0]["code"]) == ("Bump", "internal_error")
    (message,) = messages
    assert message[0] == "ERROR"
    assert message[1].startswith("Flatten failed and wrote nothing: no room for 8 GB.")


def another_file_ends_the_run() -> drive.Tour:
    marked_bump()
    goes_on = begin_held_run()
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    assert not window_run.is_running()
    yield from drive.ticks(10)
    goes_on.set()
    source = grid("Next", bump)
    yield from flatten()
    assert flat_of(source)


def unregistering_ends_the_run() -> drive.Tour:
    marked_bump()
    goes_on = begin_held_run()
    wirewarp_addon.unregister()
    yield from drive.ticks(10)
    wirewarp_addon.register()
    goes_on.set()
    source = grid("Next", bump)
    yield from flatten()
    assert flat_of(source)


def quitting_ends_the_run() -> drive.Tour:
    grid("Large", bump, size=300)
    with drive.in_view():
        bpy.ops.object.wirewarp_flatten("INVOKE_DEFAULT", True)
    yield from drive.ticks(2)
    assert window_run.is_running()
    bpy.ops.wm.quit_blender()
    yield lambda: False


def cancel_button() -> drive.Tour:
    """During a run, the button Flatten is a progress bar. The button beside it stops the run."""
    source = marked_bump()
    before, messages = contents(source), collect_messages()
    yield from drive.open_tab(bpy.types.VIEW3D_PT_wirewarp_flatten)
    begin_held_run()
    yield lambda: window_run.shown_progress(window_run.FLATTEN) == 0.4
    yield from drive.ticks(20)
    drive.screenshot("cancel_button")
    yield from drive.click_button("bpy.ops.object.wirewarp_cancel(", share=0.75)
    yield lambda: not window_run.is_running()
    assert contents(source) == before
    assert [level for level, _ in messages] == ["WARNING"]
    yield from drive.ticks(20)
    drive.screenshot("cancelled")


def fixing_is_one_undo_step() -> drive.Tour:
    """Seams and pieces are undone and redone together, in both modes."""
    for mode in ("OBJECT", "EDIT"):
        source = tube(f"Tube {mode}")
        name = source.name
        remember()
        with drive.in_view():
            bpy.ops.object.wirewarp_flatten("INVOKE_DEFAULT", True)
        yield lambda: not window_run.is_running()
        if mode == "EDIT":
            yield from drive.press("LEFTMOUSE", (300, 300))  # closes the window of a message, if there is one
            yield from drive.press("TAB")
            yield lambda: bpy.context.mode == "EDIT_MESH"
        with drive.in_view():
            bpy.ops.object.wirewarp_mend("INVOKE_DEFAULT", True, what="SEAMS")
        yield lambda: not window_run.is_running()
        assert state_of(name) == (True, True)
        yield from undo()
        yield lambda name=name: state_of(name) == (False, False)
        failed = wirewarp_addon.state.reports.last_report(bpy.data.objects[name])
        assert failed.issues and failed.issues[0].proposed_seams  # the panel shows the suggestion again
        yield from redo()
        yield lambda name=name: state_of(name) == (True, True)
        yield from undo()
        yield lambda name=name: state_of(name) == (False, False)
        with drive.in_view():
            bpy.ops.object.mode_set(mode="OBJECT")
    drive.screenshot("mended")


def state_of(name: str) -> tuple[bool, bool]:
    """Return whether the model has seams, and whether it has flat pieces."""
    source = bpy.data.objects[name]
    source.update_from_editmode()
    return any(edge.use_seam for edge in source.data.edges), f"{name} Flat" in bpy.data.objects
