# SPDX-License-Identifier: GPL-3.0-or-later
"""Tours through the export: its dialog, its run, and its cancellation."""

from collections.abc import Callable, Generator
from contextlib import closing
from pathlib import Path

import bpy
import drive
import numpy as np
import wirewarp_addon
from stage import flatten, marked_bump, window_run
from surfaces import make_object, read, select_only

export = wirewarp_addon.export.export
Stages = Generator[tuple[str, float], None, object]


def open_dialog(path: Path) -> drive.Tour:
    """Open the dialog for this path in the main window, because other windows get no simulated events."""
    bpy.context.preferences.view.filebrowser_display_type = "SCREEN"
    with drive.in_view():
        bpy.ops.object.wirewarp_export("INVOKE_DEFAULT", filepath=str(path))
    yield lambda: browser() is not None and browser().spaces.active.active_operator is not None
    yield from drive.ticks(20)


def browser() -> bpy.types.Area | None:
    screen = bpy.context.window_manager.windows[0].screen
    return next((area for area in screen.areas if area.type == "FILE_BROWSER"), None)


def described(operator: bpy.types.Operator) -> str:
    return " ".join(sentence for sentence, _ in operator._beforehand.sentences)


def region(kind: str) -> bpy.types.Region:
    """Return a region of the dialog. kind: TOOL_PROPS (the settings) or EXECUTE (the button)."""
    return next(each for each in browser().regions if each.type == kind)


def press_export() -> drive.Tour:
    bar = region("EXECUTE")
    yield from drive.press("LEFTMOUSE", (bar.x + bar.width - 60, bar.y + bar.height // 2))


def tick_failed_pieces() -> drive.Tour:
    """Tick Failed Pieces, the lowest of the settings."""
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
    operator.paper = "A0"  # not shown yet, because Blender updates the dialog only after an action of the user
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
    """Return an export that waits forever as soon as its unfinished file exists."""

    def export_and_wait(parts: object, choices: object, path: Path) -> Stages:
        with closing(exporting(parts, choices, path)) as steps:
            while not unfinished(path):
                stage = next(steps)
                yield stage
            while True:
                yield stage

    return export_and_wait


def unfinished(path: Path) -> list[Path]:
    return list(path.parent.glob(".wirewarp-*.part"))


def escape_leaves_the_file_as_it_was() -> drive.Tour:
    """During the export, a second run is refused. Esc ends the export, and another export then works."""
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


def downloaded_garment() -> Path:
    """Save a file with a garment like those in libraries of models: no marks, but a UV map of its pieces."""
    for other in list(bpy.data.objects):
        bpy.data.objects.remove(other)
    bpy.ops.object.wirewarp_open_sample(sample="FITTED_TOP")
    sample = bpy.context.active_object
    bpy.ops.object.wirewarp_flatten(cloth="JERSEY")
    mesh = sample.data
    vertices = [tuple(vertex.co) for vertex in mesh.vertices]
    garment = make_object("Garment", vertices, [tuple(face.vertices) for face in mesh.polygons])
    uv = read(mesh.uv_layers["WireWarp"].data, "uv", np.float32, 2)
    garment.data.uv_layers.new(name="UVMap").data.foreach_set("uv", uv.ravel())
    for other in list(bpy.data.objects):
        if other != garment:
            bpy.data.objects.remove(other)
    for name in list(bpy.context.scene.wirewarp.keys()):
        bpy.context.scene.wirewarp.property_unset(name)
    select_only(garment)
    path = Path(bpy.app.tempdir) / "garment.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return path


def four_clicks_lead_from_an_opened_garment_to_paper() -> drive.Tour:
    """At the start, the garment has no marks and no fabric, and the sidebar shows WireWarp's tab."""
    bpy.context.preferences.view.filebrowser_display_type = "SCREEN"
    yield from drive.open_tab(bpy.types.VIEW3D_PT_wirewarp_flatten)
    bpy.ops.wm.open_mainfile(filepath=str(downloaded_garment()), load_ui=False)
    yield from drive.ticks(25)
    sent, send = [], drive.send

    def recording(*event: object, **modifiers: bool) -> None:
        sent.append(event[:2])
        send(*event, **modifiers)

    drive.replace(drive, "send", recording)
    garment = bpy.data.objects["Garment"]
    assert not any(edge.use_seam for edge in garment.data.edges)
    yield from drive.click_button("bpy.ops.object.wirewarp_mend(what='UV_SEAMS'")
    yield lambda: "Garment Flat" in bpy.data.objects and not window_run.is_running()
    yield from drive.ticks(20)
    yield from drive.click_button("bpy.ops.object.wirewarp_mend(cloth='JERSEY'")
    yield lambda: bpy.context.scene.wirewarp.cloth == "JERSEY" and not window_run.is_running()
    yield from drive.ticks(20)
    report = wirewarp_addon.state.reports.last_report(garment)
    assert len(report.pieces) == 4 and wirewarp_addon.core.verdict(report).is_ready
    drive.screenshot("garment_ready")
    yield from drive.click_button("bpy.ops.object.wirewarp_export(")
    yield lambda: browser() is not None and browser().spaces.active.active_operator is not None
    yield from drive.ticks(20)
    path = Path(browser().spaces.active.active_operator.filepath)
    assert not path.exists()
    yield from press_export()
    yield lambda: browser() is None and not window_run.is_running()
    assert path.read_bytes().startswith(b"%PDF")
    assert sent.count(("LEFTMOUSE", "PRESS")) == 4
    ran = [each.bl_idname for each in drive.window_manager().operators]
    assert ran == ["OBJECT_OT_wirewarp_mend"] * 2  # Blender does not list the export
