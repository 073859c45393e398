# SPDX-License-Identifier: GPL-3.0-or-later
"""Helps the tours to make models, flatten, undo and check the file. Runs in Blender."""

import sys
from collections.abc import Generator
from pathlib import Path
from threading import Event

import bpy
import drive

sys.path.insert(0, str(Path(__file__).parent.parent / "addon"))

import wirewarp_addon
from surfaces import bump, grid, on_line

window_run = wirewarp_addon.ui.window_run


def contents(source: bpy.types.Object) -> tuple:
    """Return everything in the file that a run may change."""
    blocks = (bpy.data.objects, bpy.data.meshes, bpy.data.collections, bpy.data.materials)
    mesh = source.data
    return (
        [sorted(block.name for block in kind) for kind in blocks],
        [layer.name for layer in mesh.uv_layers],
        source.get("wirewarp_report"),
        mesh.get("wirewarp_uv_scale"),
        sorted(attribute.name for attribute in mesh.attributes),
    )


def remember() -> None:
    """Push an undo step, because Blender makes no undo step for changes by scripts."""
    with drive.in_view():
        bpy.ops.ed.undo_push(message="Made")


def flatten() -> drive.Tour:
    with drive.in_view():
        bpy.ops.object.wirewarp_flatten("INVOKE_DEFAULT", True)
    assert window_run.is_running()
    yield lambda: not window_run.is_running()


def undo() -> drive.Tour:
    yield from drive.press("Z", ctrl=True)


def redo() -> drive.Tour:
    yield from drive.press("Z", ctrl=True, shift=True)


def marked_bump() -> bpy.types.Object:
    """Return a bump with a wire along its middle."""
    source = grid("Bump", bump, wire=on_line(1, 0.0))
    remember()
    return source


def hold_runs() -> Event:
    """Make all later runs wait until the returned event is set or they are canceled."""
    solve_models = wirewarp_addon.flatten.models
    goes_on, flatten_arrays = Event(), solve_models.flatten_arrays

    def wait_and_flatten(*what: object) -> Generator[float, None, object]:
        while not goes_on.is_set():
            yield 0.4
        return (yield from flatten_arrays(*what))

    drive.replace(solve_models, "flatten_arrays", wait_and_flatten)
    return goes_on
