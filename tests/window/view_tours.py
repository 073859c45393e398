# SPDX-License-Identifier: GPL-3.0-or-later
"""Tours outside the sidebar: local view, search, and the view of the first pieces."""

import bpy
import drive
import wirewarp_addon
from mathutils import Vector
from stage import flatten
from surfaces import bump, flat_of, grid, on_line, select_only


def pieces_are_seen_in_local_view() -> drive.Tour:
    """If the model is in local view, a run adds its pieces to this view."""
    source = grid("Bump", bump, wire=on_line(1, 0.0))
    yield from flatten()
    select_only(source)
    with drive.in_view():
        bpy.ops.view3d.localview(frame_selected=False)
    view = drive.view_area().spaces.active

    def seen() -> list[str]:
        return [each.name for each in bpy.context.scene.objects if each.visible_get(viewport=view)]

    yield lambda: seen() == ["Bump"]
    yield from flatten()
    yield from drive.ticks(10)
    drive.screenshot("local_view")
    assert sorted(seen()) == ["Bump", "Bump Flat"]


def search_finds_commands_by_the_add_on_s_name() -> drive.Tour:
    source = grid("Bump", bump)
    select_only(source)
    yield from drive.press("F3")
    yield from drive.type_text("wirewarp")
    yield from drive.ticks(20)
    drive.screenshot("search")
    yield from drive.type_text(" flat")
    yield from drive.ticks(20)
    yield from drive.press("RET")
    yield lambda: "Bump Flat" in bpy.data.objects


def buttons_keep_their_places_in_edit_mode() -> drive.Tour:
    """Show Worst Place enters Edit Mode and stays under the mouse. For the flat pieces, it is at the same place."""
    with drive.in_view():
        bpy.ops.object.wirewarp_open_sample(sample="FITTED_TOP")
    source = bpy.context.object
    # The sample's jersey stretches far enough, so the button for the worst place would be missing.
    bpy.context.scene.wirewarp.cloth = "NONE"
    yield from flatten()
    yield from drive.open_tab(bpy.types.VIEW3D_PT_wirewarp_flatten)
    button = "bpy.ops.mesh.wirewarp_select_result("
    place = yield from drive.click_button(button)
    yield lambda: source.mode == "EDIT"
    yield from drive.ticks(10)
    drive.screenshot("worst_place")
    assert (yield from drive.command_at(place)).startswith(button)
    yield from drive.click_button("bpy.ops.object.editmode_toggle(")
    yield lambda: source.mode == "OBJECT"
    bpy.context.view_layer.objects.active = flat_of(source)
    yield from drive.ticks(10)
    assert (yield from drive.command_at(place)).startswith(button)


def the_first_pieces_are_brought_into_view() -> drive.Tour:
    """Later runs move the view only if the layout becomes much larger. Without Show New Pieces, no run moves the
    view."""
    source = grid("Bump", bump)
    view = drive.view_area().spaces.active.region_3d
    view.view_location, view.view_distance = (100, 100, 100), 1
    yield from flatten()
    assert all(in_sight(view, each) for each in (source, flat_of(source)))
    yield from drive.ticks(20)
    drive.screenshot("first_pieces")
    view.view_location = elsewhere = Vector((100, 100, 100))
    yield from flatten()
    assert view.view_location == elsewhere
    source.scale = (2, 2, 2)
    yield from flatten()
    assert all(in_sight(view, each) for each in (source, flat_of(source)))
    view.view_location = elsewhere
    drive.replace(wirewarp_addon.properties.preferences(bpy.context), "moves_view", False)
    select_only(grid("Other", bump))
    yield from flatten()
    assert view.view_location == elsewhere


def in_sight(view: bpy.types.RegionView3D, target: bpy.types.Object) -> bool:
    view.update()
    places = [view.perspective_matrix @ (target.matrix_world @ Vector(corner)).to_4d() for corner in target.bound_box]
    return all(abs(x) < w and abs(y) < w for x, y, _, w in places)
