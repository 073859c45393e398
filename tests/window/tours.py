# SPDX-License-Identifier: GPL-3.0-or-later
"""Tours through runs, undo, automatic updates and the report."""

import bmesh
import bpy
import drive
from stage import contents, flatten, marked_bump, redo, remember, undo, window_run
from surfaces import bump, flat_of, grid, on_line, select_edges


def panel_button() -> drive.Tour:
    source = grid("Bump", bump)
    yield from drive.open_tab(bpy.types.VIEW3D_PT_wirewarp_flatten)
    yield from drive.click_button("bpy.ops.object.wirewarp_flatten(")
    yield lambda: "Bump Flat" in bpy.data.objects and not window_run.is_running()
    assert len(flat_of(source).data.polygons) == 64
    yield from drive.ticks(10)
    drive.screenshot("panel_button")


def one_undo_step() -> drive.Tour:
    before = contents(marked_bump())
    yield from flatten()
    after = contents(bpy.data.objects["Bump"])
    assert before != after
    yield from undo()
    yield lambda: contents(bpy.data.objects["Bump"]) == before
    yield from redo()
    yield lambda: contents(bpy.data.objects["Bump"]) == after


def one_undo_step_in_edit_mode() -> drive.Tour:
    source = marked_bump()
    with drive.in_view():
        bpy.ops.object.mode_set("EXEC_DEFAULT", True, mode="EDIT")
        bpy.ops.mesh.select_all("EXEC_DEFAULT", True, action="SELECT")
        before = contents(source)
    yield from flatten()
    assert bpy.context.mode == "EDIT_MESH"
    after = contents(bpy.data.objects["Bump"])
    assert before != after
    yield from undo()
    yield lambda: contents(bpy.data.objects["Bump"]) == before
    assert bpy.context.mode == "EDIT_MESH"
    yield from redo()
    yield lambda: contents(bpy.data.objects["Bump"]) == after
    assert bpy.context.mode == "EDIT_MESH"


def flat_vertices(source: bpy.types.Object) -> int:
    return len(flat_of(source).data.vertices)


def auto_update() -> drive.Tour:
    """A seam marked in Edit Mode updates the pieces, without a move of the mouse. Both changes are one undo step."""
    source = marked_bump()
    yield from flatten()
    bpy.context.scene.wirewarp.auto_update = True
    select_edges(source, on_line(0, 0.0))
    remember()
    for _ in range(10):
        yield from drive.move_mouse_until(lambda: True)
    assert (flat_vertices(source), bpy.context.mode) == (81, "EDIT_MESH")
    with drive.in_view():
        bpy.ops.mesh.mark_seam("INVOKE_DEFAULT", True, clear=False)
    yield lambda: flat_vertices(source) == 90 and not window_run.is_running()
    assert bpy.context.mode == "EDIT_MESH"
    drive.screenshot("auto_update")
    log = drive.operator_log()
    assert "bpy.ops.mesh.mark_seam" in log and "mode" not in log.split("bpy.ops.mesh.mark_seam")[-1]
    yield from undo()
    yield lambda: flat_vertices(bpy.data.objects["Bump"]) == 81
    for _ in range(10):
        yield from drive.move_mouse_until(lambda: True)
    assert flat_vertices(bpy.data.objects["Bump"]) == 81
    assert bpy.context.mode == "EDIT_MESH"
    yield from redo()
    yield lambda: flat_vertices(bpy.data.objects["Bump"]) == 90


def auto_update_waits_for_a_tool() -> drive.Tour:
    """During Move, nothing is updated. The update comes after Move, and both are one undo step."""
    source = marked_bump()
    yield from flatten()
    bpy.context.scene.wirewarp.auto_update = True
    select_edges(source, on_line(0, 0.0))
    remember()
    report = source["wirewarp_report"]
    yield from drive.press("G")
    for step in range(5):
        x, y = drive.middle(drive.region("WINDOW"))
        drive.send("MOUSEMOVE", "NOTHING", (x + 10 * step, y + 5 * step))
        yield from drive.ticks(10)
    yield from drive.ticks(50)  # the mouse rests, but Move still runs
    assert not window_run.is_running()
    assert (source.mode, source["wirewarp_report"]) == ("EDIT", report)
    yield from drive.press("RET", (x + 40, y + 20))
    yield lambda: source["wirewarp_report"] != report and not window_run.is_running()
    assert drive.window_manager().operators[-1].name == "Move"  # so its settings can still be adjusted
    yield from undo()
    yield lambda: bpy.data.objects["Bump"]["wirewarp_report"] == report
    assert bpy.context.mode == "EDIT_MESH"
    heights = [vertex.co.z for vertex in bmesh.from_edit_mesh(bpy.data.objects["Bump"].data).verts]
    assert max(heights) < 0.41


def settings_can_be_adjusted_after_a_run() -> drive.Tour:
    """A run uses the scene's settings, and Blender can repeat it with other settings."""
    source = marked_bump()
    bpy.context.scene.wirewarp.mirror = True
    yield from flatten()
    last = bpy.context.window_manager.operators[-1]
    assert (last.bl_idname, last.properties.mirror) == ("OBJECT_OT_wirewarp_flatten", True)
    assert flat_of(source).data.polygons[0].normal.z < 0
    last.properties.mirror = False
    with drive.in_view():
        bpy.ops.screen.repeat_last()
    assert flat_of(source).data.polygons[0].normal.z > 0


def report_shows_the_place() -> drive.Tour:
    """A button of the report selects elements of the model or pieces in Edit Mode, and moves the view to them."""
    source = grid("Bump", bump, seam=on_line(0, 0.0))
    remember()
    yield from flatten()
    view = drive.view_area().spaces.active.region_3d
    for target in (source, flat_of(source)):
        bpy.context.view_layer.objects.active = target
        before = view.view_location.copy()
        with drive.in_view():
            bpy.ops.mesh.wirewarp_select_result("INVOKE_DEFAULT", True, what="OUTLINE", index=0)
            assert (bpy.context.mode, bpy.context.object) == ("EDIT_MESH", target)
        # The dome is 2 units wide. The view moves from its middle to the middle of one half.
        yield lambda before=before: (view.view_location - before).length > 0.2
        with drive.in_view():
            bpy.ops.object.mode_set(mode="OBJECT")


def report_turns_the_view_to_elements_on_the_back() -> drive.Tour:
    """The view turns only if elements are not visible, or to see flat pieces from above."""
    source = grid("Bump", bump, seam=on_line(0, 0.0))
    remember()
    yield from flatten()
    view = drive.view_area().spaces.active.region_3d
    for target, from_above in ((source, True), (source, False), (flat_of(source), False)):
        with drive.in_view():
            bpy.context.view_layer.objects.active = target
            bpy.ops.view3d.view_axis(type="TOP" if from_above else "BOTTOM")
        yield from drive.ticks(40)  # until the view, which turns slowly, has turned
        before = view.view_rotation.copy()
        with drive.in_view():
            bpy.ops.mesh.wirewarp_select_result("INVOKE_DEFAULT", True, what="PIECE", index=0)
        yield from drive.ticks(10)
        assert view.view_rotation.to_matrix().col[2].z > 0.3
        assert (view.view_rotation.rotation_difference(before).angle < 1e-3) == from_above
        selected = [target.matrix_world @ vertex.co for vertex in target.data.vertices if vertex.select]
        assert selected
        sidebar = drive.region("UI").width / drive.region("WINDOW").width
        for place in selected:
            x, y, _, w = view.perspective_matrix @ place.to_4d()
            assert abs(y) < w and -w < x < (1 - 2 * sidebar) * w + 1e-6
        with drive.in_view():
            bpy.ops.object.mode_set(mode="OBJECT")


def copies_the_report() -> drive.Tour:
    grid("Bump", bump, wire=on_line(1, 0.0))
    yield from flatten()
    with drive.in_view():
        bpy.ops.object.wirewarp_copy_report("INVOKE_DEFAULT", True)
    yield lambda: drive.window_manager().clipboard.startswith("Kind,Name,Piece,Length on model (mm)")
    kinds = [line.split(",")[0] for line in drive.window_manager().clipboard.splitlines()[1:]]
    assert kinds == ["Wire", "Open edge", "Piece"]
