# SPDX-License-Identifier: GPL-3.0-or-later
"""Tours through the overlay, checked by the pixels on the screen."""

import os
import sys
from pathlib import Path

import bpy
import drive
import numpy as np
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent.parent / "addon"))

import wirewarp_addon
from surfaces import bump, flat_of, grid, mark, on_line, select_edges, select_only

STYLES = wirewarp_addon.overlay.lines.STYLES
# kinds of lines that are neither white nor black, the colors of Blender's letters and shadows
COLORFUL = {"outline", "rigid", "elastic", "free"}


def marked() -> bpy.types.Object:
    """Return a model of two pieces with a wire of each kind, in an empty scene."""
    bpy.data.batch_remove(list(bpy.data.objects))
    source = grid("Bump", bump, seam=on_line(0, 0.0), wire=on_line(1, 0.0))
    mark(source, on_line(1, 0.5), kind="ELASTIC", tolerance=0.05)
    mark(source, on_line(1, -0.5), kind="SUPER_ELASTIC")
    return source


def kinds_seen(name: str, editor: str) -> set[str]:
    return {kind for kind, count in pixels_seen(name, editor).items() if count > 20}


def pixels_seen(name: str, editor: str) -> dict[str, int]:
    """Return the number of pixels of each kind of line, except in the editor's right quarter, where the legend is."""
    drive.screenshot(name)
    image = bpy.data.images.load(str(Path(os.environ["WIREWARP_PICTURES"]) / f"{name}.png"))
    pixels = np.empty(len(image.pixels), dtype=np.float32)
    image.pixels.foreach_get(pixels)
    pixels = pixels.reshape(image.size[1], image.size[0], 4)[..., :3]
    bpy.data.images.remove(image)
    area = next(area for area in bpy.context.window_manager.windows[0].screen.areas if area.type == editor)
    region = next(region for region in area.regions if region.type == "WINDOW")
    seen = pixels[region.y : region.y + region.height, region.x : region.x + int(0.75 * region.width)]
    return {kind: int((np.abs(seen - STYLES[kind].color).max(axis=2) < 0.02).sum()) for kind in (*COLORFUL, "page")}


def look_from_above() -> drive.Tour:
    with drive.in_view():
        bpy.ops.view3d.view_axis(type="TOP")
        bpy.ops.view3d.view_all()
    yield from drive.ticks(40)  # until the view, which turns slowly, is from above


def lines_are_on_the_screen() -> drive.Tour:
    """Lines are drawn on the pieces, and on the model in Object Mode and in Edit Mode, until they are switched off."""
    source = marked()
    yield from look_from_above()
    assert kinds_seen("model", "VIEW_3D") == COLORFUL
    bpy.ops.object.wirewarp_flatten()
    source.hide_set(True)
    select_only(flat_of(source))
    yield from look_from_above()
    assert kinds_seen("pieces", "VIEW_3D") == COLORFUL
    source.hide_set(False)
    flat_of(source).hide_set(True)
    select_edges(source)
    yield from look_from_above()
    assert kinds_seen("edit mode", "VIEW_3D") == COLORFUL
    bpy.context.scene.wirewarp.show_lines = False
    yield from drive.ticks(5)
    assert kinds_seen("switched off", "VIEW_3D") == set()


def lines_are_whole_in_a_large_scene() -> drive.Tour:
    """From far away, the depth buffer distinguishes only large differences, but lines must not disappear."""
    source = marked()
    bpy.context.scene.wirewarp.show_names = False
    counts = []
    for scale in (1.0, 100.0):
        source.scale = (scale,) * 3
        bpy.context.view_layer.update()
        with drive.in_view():
            bpy.ops.view3d.view_all()
        yield from drive.ticks(40)
        counts.append(pixels_seen(f"scale {scale:.0f}", "VIEW_3D"))
    for kind in COLORFUL:
        assert counts[1][kind] > 0.9 * counts[0][kind] > 0, counts


def lines_are_in_the_uv_editor() -> drive.Tour:
    source = marked()
    bpy.ops.object.wirewarp_flatten()
    beside = drive.view_area()
    with drive.in_view():
        bpy.ops.screen.area_split(direction="VERTICAL", factor=0.5)
    next(area for area in bpy.context.window_manager.windows[0].screen.areas if area.type == beside.type).ui_type = "UV"
    yield from drive.ticks(5)
    for mode in ("OBJECT", "EDIT"):
        select_only(source)
        bpy.ops.object.mode_set(mode=mode)
        yield from drive.ticks(10)
        assert kinds_seen(f"uv {mode}", "IMAGE_EDITOR") == COLORFUL
    source.data.uv_layers.active = source.data.uv_layers.new(name="Texture")
    yield from drive.ticks(5)
    assert kinds_seen("uv texture", "IMAGE_EDITOR") == set()


def marks_are_undone() -> drive.Tour:
    """Each command that marks edges is one undo step."""
    source = marked()
    bpy.ops.object.wirewarp_flatten()
    source.data.edges.foreach_set("use_seam", [False] * len(source.data.edges))
    edge = wirewarp_addon.state.identities.find_wires(source)[0].edges[0]
    select_edges(source, on_line(1, 0.25), on_line(1, 1.0))
    with drive.in_view():
        bpy.ops.ed.undo_push(message="Selected")
        for step in (
            lambda: bpy.ops.mesh.wirewarp_mark("EXEC_DEFAULT", True, kind="ELASTIC", tolerance=0.1),
            lambda: bpy.ops.mesh.wirewarp_clear("EXEC_DEFAULT", True),
            lambda: bpy.ops.mesh.wirewarp_change_wire("EXEC_DEFAULT", True, edge=edge, kind="SUPER_ELASTIC"),
            lambda: bpy.ops.mesh.wirewarp_ease("EXEC_DEFAULT", True, sides="ALL"),
            lambda: bpy.ops.mesh.wirewarp_ease("EXEC_DEFAULT", True, sides="ONE"),
            lambda: bpy.ops.mesh.wirewarp_ease("EXEC_DEFAULT", True, sides="NONE"),
            lambda: bpy.ops.mesh.wirewarp_allowance("EXEC_DEFAULT", True, kind="HEM"),
            lambda: bpy.ops.mesh.wirewarp_grain_wire("EXEC_DEFAULT", True, edge=edge),
            lambda: bpy.ops.mesh.wirewarp_seams_from_uv_islands("EXEC_DEFAULT", True),
        ):
            before = state()
            assert step() == {"FINISHED"}
            after = state()
            assert after != before
            bpy.ops.ed.undo()
            assert state() == before
            bpy.ops.ed.redo()
            assert state() == after
    yield from drive.ticks(1)


def state() -> tuple:
    """Return the marks, the names of wires, the grain wire and the number of seams."""
    source = bpy.data.objects["Bump"]
    assert source.mode == "EDIT"
    source.update_from_editmode()
    copied = source.data.copy()  # attributes can only be read outside Edit Mode
    names = [entry.name for entry in copied.wirewarp_names]
    read_values = wirewarp_addon.blender.attributes.read_values
    marks = [read_values(copied, mark).tolist() for mark in wirewarp_addon.names.MARKS]
    found = marks, names, copied.wirewarp_grain, sum(edge.use_seam for edge in copied.edges)
    bpy.data.meshes.remove(copied)
    return found


def frame_button() -> drive.Tour:
    """Show Model and Pieces brings model and pieces back into view."""
    source = marked()
    bpy.ops.object.wirewarp_flatten()
    yield from drive.open_tab(bpy.types.VIEW3D_PT_wirewarp_flatten)
    view = drive.view_area().spaces.active.region_3d
    view.view_location, view.view_distance = (100, 100, 100), 1
    yield from drive.click_button("bpy.ops.view3d.wirewarp_frame(")
    yield from drive.ticks(10)
    drive.screenshot("framed")
    for target in (source, flat_of(source)):
        for corner in target.bound_box:
            x, y, _, w = view.perspective_matrix @ (target.matrix_world @ Vector(corner)).to_4d()
            assert abs(x) < w and abs(y) < w
