# SPDX-License-Identifier: GPL-3.0-or-later
"""Takes the pictures for the pages of the site, in tours through Blender's window. They show *Fitted Top* or a ring.

tools/pictures.py runs the tours. Each tour is a function that takes the picture with its own name.
"""

import json
import os
from pathlib import Path

import bmesh
import bpy
import drive
import wirewarp_addon
from bpy_extras.view3d_utils import location_3d_to_region_2d, region_2d_to_location_3d
from marking import (
    clear_sleeve_seam,
    clear_wires,
    ease_sleeves,
    leave_edit_mode,
    mark_garment,
    mark_hip_line,
    select_edges,
)
from mathutils import Euler, Vector

SAMPLE = Path(__file__).resolve().parents[2] / "blend_samples" / "fitted_top.blend"
PANEL = "VIEW3D_PT_wirewarp_"
UI_SCALE = 1.3  # makes texts readable at the width of a page
LEFT = 480  # pixels on the left of the view that pictures leave out


def open_sample(*opened: str) -> drive.Tour:
    """Open the sample in a window with only a 3D view, in which only these panels of WireWarp are open."""
    open_panels(*opened)
    bpy.ops.wm.open_mainfile(filepath=str(SAMPLE), load_ui=False)
    yield from show_view_only(opened[0])


def open_panels(*opened: str) -> None:
    """Register all panels of WireWarp again, with only these open.

    Blender reads from the class of a panel whether it is open, but only when the panel is registered.
    """
    bpy.context.preferences.view.ui_scale = UI_SCALE
    bpy.context.preferences.view.smooth_view = 0  # otherwise, Flatten still moves the view when a picture is taken
    panels = [cls for cls in wirewarp_addon.registration.CLASSES if issubclass(cls, bpy.types.Panel)]
    for panel in panels:
        bpy.utils.unregister_class(panel)
    for panel in panels:
        name = panel.__name__.removeprefix(PANEL)
        panel.bl_options = set() if name in opened else {"DEFAULT_CLOSED"}
        bpy.utils.register_class(panel)


def show_view_only(first: str) -> drive.Tour:
    """Enlarge the 3D view, open the tab that contains the panel `first`, and look at the model."""
    yield from drive.ticks(5)
    with drive.in_view():
        bpy.ops.screen.screen_full_area()
    yield from drive.ticks(10)
    space = drive.view_area().spaces.active
    space.show_region_toolbar = False
    space.show_region_tool_header = space.show_region_header = space.show_region_hud = False
    space.overlay.show_text = False
    space.overlay.show_cursor = False
    space.overlay.show_floor = space.overlay.show_axis_x = space.overlay.show_axis_y = False
    space.overlay.show_object_origins = space.overlay.show_relationship_lines = False
    space.show_gizmo = False
    space.show_region_ui = True
    yield lambda: drive.region("UI").width > 1
    yield from drive.open_tab(getattr(bpy.types, PANEL + first))
    yield from look_at_model()


def look_at_model() -> drive.Tour:
    look(Euler((1.25, 0.0, 0.42)))
    yield from fit()


def look(rotation: Euler) -> None:
    view = drive.view_area().spaces.active.region_3d
    view.view_perspective = "PERSP"
    view.view_rotation = rotation.to_quaternion()
    view.update()


def look_at_both(bottom: float = 0.0) -> drive.Tour:
    look(Euler((0.85, 0.0, 0.25)))
    yield from fit(bottom)


def fit(bottom: float = 0.0) -> drive.Tour:
    """Fit all visible objects into the part of the view that the picture shows.

    bottom: share of the view's height that stays free, for a legend.
    """
    yield from drive.ticks(2)
    region, view = drive.region("WINDOW"), drive.view_area().spaces.active.region_3d
    right = drive.region("UI").x - region.x
    corners = visible_corners()
    view.view_location = sum(corners, Vector()) / len(corners)
    view.update()
    for _ in range(4):  # several steps, because perspective makes a single step inexact
        places = [location_3d_to_region_2d(region, view, corner) for corner in corners]
        low, high = (Vector(end(place[k] for place in places) for k in range(2)) for end in (min, max))
        size = Vector((right - LEFT, (1 - bottom) * region.height))
        middle = Vector(((LEFT + right) / 2, (1 + bottom) / 2 * region.height))
        shown, wanted = (
            region_2d_to_location_3d(region, view, place, view.view_location) for place in ((low + high) / 2, middle)
        )
        view.view_location += shown - wanted
        view.view_distance *= 1.1 * max((high - low)[k] / size[k] for k in range(2))
        view.update()
        yield from drive.ticks(2)


def visible_corners() -> list[Vector]:
    """Return the corners of the boxes around all visible objects, in the world."""
    return [
        each.matrix_world @ Vector(corner)
        for each in bpy.context.view_layer.objects
        if each.visible_get() and not each.hide_get()  # visible_get() is still true for objects that were just hidden
        for corner in each.bound_box
    ]


def hide_others() -> None:
    for each in bpy.context.view_layer.objects:
        each.hide_set(each != bpy.context.view_layer.objects.active)


def flatten() -> drive.Tour:
    with drive.in_view():
        bpy.ops.object.wirewarp_flatten("INVOKE_DEFAULT", True)
    yield lambda: not wirewarp_addon.ui.window_run.is_running()
    yield from drive.ticks(10)


def park_mouse() -> drive.Tour:
    """Move the mouse to a place at which it highlights no button."""
    region = drive.region("WINDOW")
    drive.send("MOUSEMOVE", "NOTHING", (region.x + 40, region.y + 40))
    yield from drive.ticks(10)


def take_picture(name: str) -> drive.Tour:
    """Write NAME.png, and NAME.json with the part to keep: left, top, right, bottom in pixels from the top left."""
    yield from park_mouse()
    drive.screenshot(name)
    area, height = drive.view_area(), bpy.context.window_manager.windows[0].height
    top = height - area.y - area.height
    # The border of the area, which is 1 pixel wide, is left out.
    box = (area.x + LEFT, top + 1, area.x + area.width, top + area.height - 1)
    (Path(os.environ["WIREWARP_PICTURES"]) / f"{name}.json").write_text(json.dumps(box))


def mark() -> drive.Tour:
    """Show the hip line after it was marked as elastic."""
    yield from open_sample("mark", "wires")
    mark_hip_line()
    yield from drive.ticks(10)
    yield from take_picture("mark")


def flat() -> drive.Tour:
    """Show the result of the first tutorial."""
    yield from open_sample("flatten", "report")
    mark_hip_line()
    leave_edit_mode()
    yield from flatten()
    yield from look_at_both()
    yield from take_picture("flat")


def report() -> drive.Tour:
    yield from open_sample("flatten", "report", "report_seams", "report_outlines")
    yield from flatten()
    bpy.context.scene.wirewarp.shown_map = "STRETCH_COLOR"
    yield from look_at_both(bottom=0.3)
    yield from take_picture("report")


def suggest() -> drive.Tour:
    """Show suggested darts for the front, with the first row chosen."""
    yield from open_sample("flatten", "pieces")
    mark_garment()
    yield from flatten()
    ease_sleeves()
    yield from flatten()
    with drive.in_view():
        bpy.ops.object.wirewarp_suggest_darts("INVOKE_DEFAULT", True, piece=0, place="PIECES")
    yield lambda: not wirewarp_addon.ui.window_run.is_running()
    yield from look_at_both(bottom=0.28)
    yield from take_picture("suggest")


def tube() -> drive.Tour:
    """Show a sleeve without its seam, before any wire is marked."""
    yield from open_sample("flatten", "report")
    clear_wires()
    clear_sleeve_seam(bpy.context.object.data)
    yield from flatten()
    hide_others()  # the pieces would block the view from below
    look(Euler((2.0, 0.0, -0.4)))
    yield from fit()
    yield from take_picture("tube")


def contradiction() -> drive.Tour:
    """Show the error of a net of rigid wires: all edges of one breast, and the diagonals of its faces."""
    yield from open_sample("flatten", "report")
    vertices = bpy.context.object.data.vertices
    peak = min((v.co.copy() for v in vertices if v.co.x > 0), key=lambda place: place.y)
    select_edges(lambda a, b: max((a - peak).length, (b - peak).length) < 0.045)
    with drive.in_view():
        bpy.ops.mesh.quads_convert_to_tris()
        bpy.ops.mesh.wirewarp_mark("INVOKE_DEFAULT", kind="RIGID")
    leave_edit_mode()
    yield from flatten()
    hide_others()
    yield from look_at_model()  # again, because Flatten has moved the view
    yield from take_picture("contradiction")


def pieces() -> drive.Tour:
    yield from open_sample("flatten", "pieces", "report", "report_wires")
    mark_hip_line()
    leave_edit_mode()
    yield from flatten()
    bpy.context.scene.wirewarp.shown_map = "STRETCH_COLOR"
    yield from show_pieces_from_above()
    yield from take_picture("pieces")


def show_pieces_from_above() -> drive.Tour:
    """Show only the flat pieces, selected."""
    source = bpy.context.object
    flat_pieces = bpy.data.objects["Fitted top Flat"]
    source.hide_set(True)
    bpy.context.view_layer.objects.active = flat_pieces
    flat_pieces.select_set(True)
    look(Euler((0.0, 0.0, 0.0)))
    yield from fit(bottom=0.37)
    yield from drive.ticks(20)


def allowance() -> drive.Tour:
    """Show allowances of 30 mm at the hem, and on the sleeves' side of the armholes."""
    yield from open_sample("flatten", "export", "mark_sides")
    bpy.context.scene.wirewarp.spacing = 70.0
    mark_garment()
    yield from flatten()
    ease_sleeves()
    yield from flatten()
    source = bpy.context.object
    low = min(vertex.co.z for vertex in source.data.vertices)
    select_edges(lambda a, b: max(a.z, b.z) < low + 0.001)
    with drive.in_view():
        bpy.ops.mesh.wirewarp_allowance(kind="HEM")
        bpy.ops.object.mode_set(mode="OBJECT")
    yield from show_pieces_from_above()
    flat_pieces = bpy.context.object
    with drive.in_view():
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.context.tool_settings.mesh_select_mode = (False, True, False)
        bpy.ops.mesh.select_all(action="DESELECT")
    edit = bmesh.from_edit_mesh(flat_pieces.data)
    seam, piece = edit.edges.layers.int["wirewarp_seam"], edit.faces.layers.int["piece"]
    names = [each.name for each in source.wirewarp_pieces]
    sleeves = {index for index, name in enumerate(names) if name in {"Left sleeve", "Right sleeve"}}
    others = {edge[seam] for edge in edit.edges if edge.is_boundary and edge.link_faces[0][piece] not in sleeves}
    for edge in edit.edges:
        is_sleeve = edge.is_boundary and edge.link_faces[0][piece] in sleeves
        edge.select = is_sleeve and edge[seam] != 0 and edge[seam] in others
    edit.select_flush_mode()
    bmesh.update_edit_mesh(flat_pieces.data)
    with drive.in_view():
        bpy.ops.mesh.wirewarp_allowance(kind="WIDTH", width=30.0)
        bpy.ops.object.mode_set(mode="OBJECT")
    yield from drive.ticks(40)
    yield from take_picture("allowance")


def pages() -> drive.Tour:
    """Show the sheets of the first tutorial."""
    yield from open_sample("flatten", "export")
    mark_hip_line()
    leave_edit_mode()
    yield from flatten()
    settings = bpy.context.scene.wirewarp
    settings.pairs = settings.on_fold = settings.show_pages = True
    settings.arrangement, settings.paper = "IN_ROWS", "A4"
    yield from show_pieces_from_above()
    yield from fit(bottom=0.55)  # room for the sheets, which are below the pieces
    yield from drive.ticks(10)
    yield from take_picture("pages")


def ring_seams() -> drive.Tour:
    """Show the suggested seams of the plush tutorial."""
    yield from make_ring()
    yield from suggest_ring_seams()
    yield from take_picture("ring_seams")


def ring() -> drive.Tour:
    """Show the result of the plush tutorial."""
    yield from make_ring()
    yield from suggest_ring_seams()
    with drive.in_view():
        bpy.ops.object.wirewarp_mend("INVOKE_DEFAULT", True, what="SUGGESTION")
    yield lambda: not wirewarp_addon.ui.window_run.is_running()
    bpy.context.scene.wirewarp.pairs = True
    look(Euler((0.55, 0.0, 0.0)))
    yield from fit(bottom=0.15)
    yield from drive.ticks(20)
    yield from take_picture("ring")


def make_ring() -> drive.Tour:
    """Make and flatten the closed model of the plush tutorial, in Blender's startup file."""
    open_panels("flatten", "export")
    with drive.in_view():
        bpy.ops.object.select_all(action="SELECT")
        bpy.ops.object.delete()
        bpy.ops.mesh.primitive_torus_add(major_radius=0.1, minor_radius=0.05)
    settings = bpy.context.scene.wirewarp
    settings.cloth, settings.allowance = "FLEECE", 5.0
    yield from show_view_only("flatten")
    yield from flatten()


def suggest_ring_seams() -> drive.Tour:
    with drive.in_view():
        bpy.ops.object.wirewarp_suggest_seams("INVOKE_DEFAULT", True)
    yield lambda: not wirewarp_addon.ui.window_run.is_running()
    look(Euler((0.95, 0.0, 0.42)))
    yield from fit(bottom=0.1)
    yield from drive.ticks(20)


def export() -> drive.Tour:
    yield from open_sample("flatten", "pieces")
    yield from flatten()
    folder = Path(os.environ["WIREWARP_PICTURES"])
    with drive.in_view():
        bpy.ops.object.wirewarp_export(filepath=str(folder / "pattern.svg"))
        bpy.ops.object.wirewarp_export(filepath=str(folder / "sheets.pdf"), paper="A4", arrangement="IN_ROWS")
        marker = {"arrangement": "MARKER", "cloth_width": 1400.0, "grain": "BOTH_WAYS", "seconds": 10}
        bpy.ops.object.wirewarp_export(filepath=str(folder / "marker.svg"), **marker)
