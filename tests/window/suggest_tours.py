# SPDX-License-Identifier: GPL-3.0-or-later
"""Tours through suggested cuts: the search, the list, and cuts that are marked and undone."""

from collections.abc import Generator
from threading import Event

import bpy
import drive
import wirewarp_addon
from stage import contents, flatten, hold_runs, marked_bump, redo, remember, undo, window_run
from suggesting import bent_ring
from surfaces import bump, grid, mark_seam, on_line, read, select_edges

current = wirewarp_addon.state.suggestions.current_suggestions

MARK = "bpy.ops.object.wirewarp_mend(what='SUGGESTION'"  # command of "Mark and Flatten" and "Clear and Flatten"


def seam_count() -> int:
    return int(read(bpy.data.objects["Bump"].data.edges, "use_seam", bool).sum())


def suggest() -> drive.Tour:
    with drive.in_view():
        bpy.ops.object.wirewarp_suggest_darts("INVOKE_DEFAULT", True, piece=0)
    assert window_run.is_running()
    yield lambda: not window_run.is_running()


def a_suggestion_is_taken_and_undone_with_one_click_each() -> drive.Tour:
    bpy.context.scene.wirewarp.dart_lines = "EDGES"
    source = grid("Bump", bump, size=16)
    remember()
    yield from flatten()
    before = contents(source)
    yield from suggest()
    yield from drive.open_tab(bpy.types.VIEW3D_PT_wirewarp_flatten)
    yield from drive.ticks(10)
    drive.screenshot("suggestions")
    assert contents(source) == before
    found = current(source)
    edges = found.cuts[found.chosen].edges
    yield from drive.click_button(MARK)
    yield lambda: seam_count() == len(edges) and not window_run.is_running()
    assert current(bpy.data.objects["Bump"]) is None
    yield from undo()
    yield lambda: contents(bpy.data.objects["Bump"]) == before
    assert seam_count() == 0
    # The suggestions are valid again, because the model is the same as during the search.
    assert current(bpy.data.objects["Bump"]).cuts == found.cuts
    yield from redo()
    yield lambda: seam_count() == len(edges)


def a_smooth_dart_is_cut_and_undone_with_one_click_each() -> drive.Tour:
    source = grid("Bump", bump, size=12)
    remember()
    yield from flatten()
    before = contents(source)
    yield from suggest()
    yield from drive.open_tab(bpy.types.VIEW3D_PT_wirewarp_flatten)
    yield from drive.ticks(10)
    found = current(source)
    smooth = next(i for i, cut in enumerate(found.cuts) if not cut.edges)
    wirewarp_addon.state.suggestions.choose(source, smooth)
    yield from drive.ticks(10)
    drive.screenshot("smooth_suggestion")
    yield from drive.click_button(MARK)
    yield lambda: len(source.data.vertices) > 13 * 13 and not window_run.is_running()
    drive.screenshot("smooth")
    cut = contents(source)
    yield from undo()
    yield lambda: contents(bpy.data.objects["Bump"]) == before
    yield from redo()
    yield lambda: contents(bpy.data.objects["Bump"]) == cut


def a_smooth_set_is_cut_and_undone_with_one_click_each() -> drive.Tour:
    source = bent_ring()
    remember()
    with drive.in_view():
        bpy.ops.object.wirewarp_suggest_seams("INVOKE_DEFAULT", True)
    yield lambda: not window_run.is_running()
    yield from drive.open_tab(bpy.types.VIEW3D_PT_wirewarp_flatten)
    found = current(source)
    smooth = next(i for i, cut in enumerate(found.cuts) if not cut.edges)
    wirewarp_addon.state.suggestions.choose(source, smooth)
    yield from drive.ticks(10)
    drive.screenshot("smooth_set_suggestion")
    name, before, count = source.name, contents(source), len(source.data.vertices)
    yield from drive.click_button(MARK)
    yield lambda: len(source.data.vertices) > count and not window_run.is_running()
    yield from drive.ticks(10)
    drive.screenshot("smooth_set")
    cut = contents(source)
    yield from undo()
    yield lambda: contents(bpy.data.objects[name]) == before
    yield from redo()
    yield lambda: contents(bpy.data.objects[name]) == cut


def seams_are_simplified_and_undone_with_one_click_each() -> drive.Tour:
    source = grid("Bump", bump, size=8)
    for row in (-0.5, 0.0, 0.5):
        mark_seam(source, on_line(1, row))
    remember()
    yield from flatten()
    before, count = contents(source), seam_count()
    with drive.in_view():
        bpy.ops.object.wirewarp_simplify_seams("INVOKE_DEFAULT", True)
    yield lambda: not window_run.is_running()
    yield from drive.open_tab(bpy.types.VIEW3D_PT_wirewarp_flatten)
    yield from drive.ticks(10)
    drive.screenshot("simplify")
    assert contents(source) == before
    found = current(source)
    cleared = found.cuts[found.chosen].cleared
    yield from drive.click_button(MARK)
    yield lambda: seam_count() == count - len(cleared) and not window_run.is_running()
    yield from undo()
    yield lambda: contents(bpy.data.objects["Bump"]) == before
    yield from redo()
    yield lambda: seam_count() == count - len(cleared)


def no_button_moves_under_the_mouse(command: str) -> drive.Tour:
    """Click the button of this search. Check that it keeps its place, and that the list of results is below it."""
    sidebar = drive.region("UI")
    place = yield from drive.click_button(command)
    yield lambda: not window_run.is_running()
    yield from drive.ticks(20)
    drive.screenshot("list_of_suggestions")
    assert (yield from drive.command_at(place)).startswith(command)
    below = [(place[0], y) for y in range(place[1], sidebar.y, -12)]
    commands = []
    for each in below:
        commands.append((yield from drive.command_at(each)).partition("(")[0])
    assert {"bpy.ops.object.wirewarp_choose_suggestion", "bpy.ops.object.wirewarp_mend"} <= set(commands)


def the_list_appears_below_the_button_that_was_pressed() -> drive.Tour:
    source = grid("Bump", bump, size=12)
    # Jersey stretches far enough, so the button is in the list of pieces. Without a fabric, the button is below
    # Flatten.
    for cloth, place in (("JERSEY", "PIECES"), ("NONE", "FLATTEN")):
        bpy.context.scene.wirewarp.cloth = cloth
        remember()
        yield from flatten()
        if place == "PIECES":
            yield from drive.open_tab(bpy.types.VIEW3D_PT_wirewarp_flatten)
        yield from drive.ticks(10)
        yield from no_button_moves_under_the_mouse(f"bpy.ops.object.wirewarp_suggest_darts(place='{place}'")
        assert current(source).place == place


def buttons_keep_their_places_during_a_run() -> drive.Tour:
    source = marked_bump()
    yield from flatten()
    yield from drive.open_tab(bpy.types.VIEW3D_PT_wirewarp_flatten)
    yield from drive.ticks(10)
    sidebar, export = drive.region("UI"), "bpy.ops.object.wirewarp_export("
    x = sidebar.x + int(0.4 * sidebar.width)
    for y in range(sidebar.y + sidebar.height - 20, sidebar.y, -12):
        if (yield from drive.command_at((x, y))).startswith(export):
            break
    goes_on = hold_runs()
    with drive.in_view():
        bpy.ops.object.wirewarp_flatten("INVOKE_DEFAULT", True)
    yield lambda: window_run.shown_progress(window_run.FLATTEN) is not None
    yield from drive.ticks(10)
    drive.screenshot("sidebar_during_a_run")
    assert (yield from drive.command_at((x, y))).startswith(export)
    goes_on.set()
    yield lambda: not window_run.is_running()
    assert source["wirewarp_report"]


def escape_ends_the_search() -> drive.Tour:
    source = grid("Bump", bump, size=200)  # so large that the search takes many seconds
    remember()
    with drive.in_view():
        bpy.ops.object.wirewarp_suggest_seams("INVOKE_DEFAULT", True)
    yield from drive.press("ESC")
    yield lambda: not window_run.is_running()
    assert current(source) is None


def a_model_that_changes_during_the_search_gets_no_suggestion() -> drive.Tour:
    source = grid("Bump", bump, size=30)
    remember()
    with drive.in_view():
        bpy.ops.object.wirewarp_suggest_darts("INVOKE_DEFAULT", True)
    source.data.vertices[400].co.z += 0.01
    source.data.update()
    yield lambda: not window_run.is_running()
    assert wirewarp_addon.state.suggestions.suggestions_of(source) is None


def a_search_ends_under_a_tool() -> drive.Tour:
    """A search ends while a tool runs. It must not leave Edit Mode, because that would crash Blender."""
    source = grid("Bump", bump)
    select_edges(source, on_line(0, 0.0))
    remember()
    run, goes_on = wirewarp_addon.suggest.operators, Event()
    suggest_cuts = run.suggest_cuts

    def wait_and_suggest(*what: object) -> Generator[float, None, object]:
        while not goes_on.is_set():
            yield 0.4
        return (yield from suggest_cuts(*what))

    drive.replace(run, "suggest_cuts", wait_and_suggest)
    with drive.in_view():
        bpy.ops.object.wirewarp_suggest_darts("INVOKE_DEFAULT", True)
    yield from drive.press("G")
    goes_on.set()
    yield lambda: not window_run.is_running()
    yield from drive.ticks(10)
    assert source.mode == "EDIT" and current(source)
    assert drive.window_manager().operators[-1].name != "Move"  # not listed, because it still runs
    yield from drive.press("ESC")
    assert source.mode == "EDIT" and current(source)


def a_fault_of_the_core_ends_the_search() -> drive.Tour:
    source = grid("Bump", bump)
    run, operators, sentences = wirewarp_addon.suggest.operators, wirewarp_addon.suggest.operators, []
    suggest_cuts, fault_sentence = run.suggest_cuts, operators.fault_sentence

    def fail(*_: object) -> Generator[float, None, object]:
        yield 0.4
        raise MemoryError("no room for 8 GB")

    def tell(*what: object) -> str:
        sentences.append(fault_sentence(*what))
        return sentences[-1]

    drive.replace(run, "suggest_cuts", fail)
    drive.replace(operators, "fault_sentence", tell)
    with drive.in_view():
        bpy.ops.object.wirewarp_suggest_darts("INVOKE_DEFAULT", True)
    yield lambda: not window_run.is_running()
    (sentence,) = sentences
    assert sentence.startswith("The search failed and suggests nothing: no room for 8 GB.")
    assert current(source) is None
    run.suggest_cuts = suggest_cuts
    with drive.in_view():
        bpy.ops.object.wirewarp_suggest_darts("INVOKE_DEFAULT", True)
    yield lambda: not window_run.is_running()
    assert current(source)
