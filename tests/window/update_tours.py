# SPDX-License-Identifier: GPL-3.0-or-later
"""Tours through automatic updates, during which the user starts a tool or changes the mode or the scene."""

from collections.abc import Generator
from threading import Event

import bpy
import drive
from stage import contents, flatten, hold_runs, marked_bump, window_run
from surfaces import flat_of, on_line, select_edges

ONE_PIECE, TWO_PIECES = 81, 90  # number of vertices of the flat pieces, without and with the seam


def begin_held_update() -> Generator[object, None, Event]:
    """Mark a seam in Edit Mode, and wait until the update runs. The update ends after the returned event is set."""
    source = marked_bump()
    yield from flatten()
    bpy.context.scene.wirewarp.auto_update = True
    goes_on = hold_runs()
    select_edges(source, on_line(0, 0.0))
    with drive.in_view():
        bpy.ops.mesh.mark_seam("INVOKE_DEFAULT", True, clear=False)
    yield window_run.is_running
    return goes_on


def let_it_solve(goes_on: Event) -> drive.Tour:
    goes_on.set()
    yield lambda: window_run._current is None or window_run._current.is_done


def flat_vertices() -> int:
    return len(flat_of(bpy.data.objects["Bump"]).data.vertices)


def a_tool_begun_during_an_update_goes_on() -> drive.Tour:
    """The pieces are written after the tool has ended, because leaving Edit Mode during a tool crashes Blender."""
    goes_on = yield from begin_held_update()
    source = bpy.data.objects["Bump"]
    heights = [vertex.co.z for vertex in source.data.vertices]
    yield from drive.press("G")
    yield from let_it_solve(goes_on)
    x, y = drive.middle(drive.region("WINDOW"))
    for step in range(10):
        drive.send("MOUSEMOVE", "NOTHING", (x + 10 * step, y + 5 * step))
        yield from drive.ticks(5)
    assert (window_run.is_running(), source.mode, flat_vertices()) == (True, "EDIT", ONE_PIECE)
    yield from drive.press("ESC", (x + 90, y + 45))
    yield lambda: flat_vertices() == TWO_PIECES
    assert not window_run.is_running()
    assert [vertex.co.z for vertex in bpy.data.objects["Bump"].data.vertices] == heights


def an_update_does_not_end_in_another_mode() -> drive.Tour:
    goes_on = yield from begin_held_update()
    source = bpy.data.objects["Bump"]
    with drive.in_view():
        bpy.ops.object.mode_set(mode="SCULPT")
    before = contents(source)
    yield from let_it_solve(goes_on)
    yield lambda: not window_run.is_running()
    assert (source.mode, contents(source), flat_vertices()) == ("SCULPT", before, ONE_PIECE)
    with drive.in_view():
        bpy.ops.object.mode_set(mode="OBJECT")
    yield lambda: flat_vertices() == TWO_PIECES


def an_update_does_not_end_in_another_scene() -> drive.Tour:
    goes_on = yield from begin_held_update()
    source, window, scene = bpy.data.objects["Bump"], drive.window_manager().windows[0], bpy.context.scene
    with drive.in_view():
        bpy.ops.object.mode_set(mode="OBJECT")
    window.scene = other = bpy.data.scenes.new("Other")
    before = contents(source)
    yield from let_it_solve(goes_on)
    yield lambda: not window_run.is_running()
    assert (list(other.collection.all_objects), contents(source), flat_vertices()) == ([], before, ONE_PIECE)
    window.scene = scene
    yield lambda: flat_vertices() == TWO_PIECES
