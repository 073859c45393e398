# SPDX-License-Identifier: GPL-3.0-or-later
"""Tours through the export: its dialog, its run, and the state after cancellation."""

from collections.abc import Callable, Generator
from contextlib import closing
from pathlib import Path

import bpy
import drive
import wirewarp_addon
from stage import flatten, marked_bump, window_run
from surfaces import select_only

export = wirewarp_addon.export.export
Stages = Generator[tuple[str, float], None, object]


def open_dialog(path: Path) -> drive.Tour:
    """Open the export dialog with this name, in the window of the other editors, because events reach no other
    window.
    """
    bpy.context.preferences.view.filebrowser_display_type = "SCREEN"
    with drive.in_view():
        bpy.ops.object.wirewarp_export("INVOKE_DEFAULT", filepath=str(path))
    yield lambda: browser() is not None and browser().spaces.active.active_operator is not None
    yield from drive.ticks(20)


def browser() -> bpy.types.Area | None:
    screen = bpy.context.window_manager.windows[0].screen
    return next((area for area in screen.areas if area.type == "FILE_BROWSER"), None)


def described(operator: bpy.types.Operator) -> str:
    """Return the dialog's text above the settings."""
    return " ".join(sentence for sentence, _ in operator._beforehand.sentences)


def region(kind: str) -> bpy.types.Region:
    """Return a region of the dialog: TOOL_PROPS (the settings) or EXECUTE (the button)."""
    return next(each for each in browser().regions if each.type == kind)


def press_export() -> drive.Tour:
    bar = region("EXECUTE")
    yield from drive.press("LEFTMOUSE", (bar.x + bar.width - 60, bar.y + bar.height // 2))


def tick_failed_pieces() -> drive.Tour:
    """Tick the lowest of the settings."""
    settings, operator = region("TOOL_PROPS"), browser().spaces.active.active_operator
    for y in range(settings.y + 20, settings.y + settings.height, 10):
        yield from drive.press("LEFTMOUSE", (settings.x + 20, y))
        if operator.failed_pieces:
            return
    raise AssertionError("no button is below all others")


def the_dialog_says_the_size_and_follows_its_settings() -> drive.Tour:
    """Drawing the dialog does not leave Edit Mode."""
    source = marked_bump()
    yield from flatten()
    select_only(source)
    bpy.ops.object.mode_set(mode="EDIT")
    path = Path(bpy.app.tempdir) / "pattern.pdf"
    yield from open_dialog(path)
    operator = browser().spaces.active.active_operator
    assert "sheets of A4: a map and " in described(operator)
    operator.paper = "A0"  # Blender updates the dialog only after the user does something
    assert "sheets of A4: a map and " in described(operator)
    yield from tick_failed_pieces()
    assert operator.failed_pieces and "sheets of A0: a map and " in described(operator)
    assert source.mode == "EDIT"
    drive.screenshot("dialog")
    yield from press_export()
    yield lambda: browser() is None and not window_run.is_running()
    assert path.read_bytes().startswith(b"%PDF")
    assert source.mode == "EDIT"


def halting(exporting: Callable[..., Stages]) -> Callable[..., Stages]:
    """Return this export, but stopped as soon as its unfinished file exists."""

    def export_and_wait(parts: object, choices: object, path: Path) -> Stages:
        with closing(exporting(parts, choices, path)) as steps:
            while not unfinished(path):
                stage = next(steps)
                yield stage
            while True:
                yield stage

    return export_and_wait


def unfinished(path: Path) -> list[Path]:
    """Return the files that are written beside the target until it is complete."""
    return list(path.parent.glob(".wirewarp-*.part"))


def escape_leaves_the_file_as_it_was() -> drive.Tour:
    """The view continues meanwhile, and the next export is complete."""
    source = marked_bump()
    yield from flatten()
    select_only(source)
    folder = Path(bpy.app.tempdir) / "patterns"
    folder.mkdir()
    path = folder / "pattern.pdf"
    path.write_bytes(b"of an earlier export")
    exporting = export._exporting
    drive.replace(export, "_exporting", halting(exporting))
    yield from open_dialog(path)
    yield from press_export()
    yield lambda: browser() is None and window_run.is_running(window_run.EXPORT) and bool(unfinished(path))
    try:
        bpy.ops.object.wirewarp_flatten()
    except RuntimeError as error:
        assert "Export is still running" in str(error)
    else:
        raise AssertionError("a second run was begun")
    yield from drive.press("ESC")
    yield lambda: not window_run.is_running()
    assert path.read_bytes() == b"of an earlier export"
    assert [each.name for each in folder.iterdir()] == ["pattern.pdf"]
    export._exporting = exporting
    yield from open_dialog(path)
    yield from press_export()
    yield lambda: browser() is None and not window_run.is_running()
    assert path.read_bytes().startswith(b"%PDF")
