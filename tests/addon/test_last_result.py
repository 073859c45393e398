# SPDX-License-Identifier: GPL-3.0-or-later
"""The last good result stays after failed runs, and copies of its pieces are not mistaken for it."""

from itertools import count
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from everything import answer, draw_panels
from flattening import flatten_fails, flattened, raise_vertex, report_after, uv_of
from surfaces import bump, flat_of, grid, read, select_only
from test_failures import cube

pytestmark = pytest.mark.api

READY, AGAIN = "Ready to cut", '"Bump" has no flat pieces. Flatten it again'


def fail(source):
    """Flatten the model with a damaged vertex, and restore the vertex."""
    place = source.data.vertices[0].co.copy()
    source.data.vertices[0].co.x = float("nan")
    flatten_fails("not numbers, or far")
    source.data.vertices[0].co = place
    source.data.update()


def export(tmp_path):
    return answer("object.wirewarp_export_svg", filepath=str(tmp_path / "pattern.svg"))


def test_a_failed_run_keeps_the_report_of_the_pieces(source, addon, tmp_path):
    uv = uv_of(source.data)
    fail(source)
    assert np.array_equal(uv_of(source.data), uv) and len(flat_of(source).data.polygons) == 64
    assert not addon.state.reports.last_report(source).ok and addon.state.reports.pieces_report(source).ok
    words = draw_panels(addon)
    assert "Not flattened" in words or "The model has changed since" in words
    assert export(tmp_path) == "{'FINISHED'}"
    assert answer("object.wirewarp_copy_report") == "{'FINISHED'}"
    assert answer("mesh.wirewarp_select_result", what="PIECE", index=0) == "{'FINISHED'}"
    bpy.ops.object.mode_set(mode="OBJECT")
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert addon.state.reports.last_report(source).ok
    fail(source)  # Blender files do not contain reports of failures.
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "failed.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "failed.blend"))
    assert addon.state.reports.last_report(bpy.data.objects["Bump"]).ok


def test_the_report_of_a_failed_run_stays_with_its_object(addon, tmp_path):
    closed = cube()
    flatten_fails("closed")
    closed.name = "Renamed"
    assert not addon.state.reports.last_report(closed).ok
    bpy.data.objects.remove(closed)
    for name in ("Cube", "Renamed"):
        other = grid(name, bump, size=4)
        assert addon.state.reports.last_report(other) is None
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "other.blend"))
    assert not [each for each in bpy.data.objects if "wirewarp_report" in each]


def test_after_undo_of_a_run_the_failure_before_it_is_the_last_result(source, addon):
    last, stored = addon.state.reports.last_report, source["wirewarp_report"]
    fail(source)
    assert not last(source).ok
    raise_vertex(source)
    bpy.ops.object.wirewarp_flatten()
    assert last(source).ok and source["wirewarp_report"] != stored
    source["wirewarp_report"], later = stored, source["wirewarp_report"]  # as undo does
    assert not last(source).ok
    source["wirewarp_report"] = later  # as redo does
    assert last(source).ok


def test_the_panel_does_not_say_that_the_model_changed_right_after_a_run(source, addon, monkeypatch):
    """The panel keeps results of slow checks for a while. This clock advances by 0.1 s each time it is read."""
    ticks = count()
    monkeypatch.setattr(addon.state.drawings, "time", SimpleNamespace(monotonic=lambda: next(ticks) / 10))
    addon.state.drawings.forget()

    def has_changed():
        return addon.state.reports.seems_changed(source, addon.state.reports.last_report(source))

    assert not has_changed()
    raise_vertex(source)
    assert any(has_changed() for _ in range(50))
    bpy.ops.object.wirewarp_flatten()
    assert not has_changed()


def test_a_piece_renamed_during_a_run_keeps_its_new_name(source, addon):
    models = addon.flatten.read.read_models(bpy.context, [source], bpy.context.scene.wirewarp)
    settings = bpy.context.scene.wirewarp
    choices = addon.state.settings.choices_of(settings, 1.0)
    outcomes = addon.solve.steps.in_one_go(addon.flatten.models.solve_models(models, choices, 1.0))
    source.wirewarp_pieces[0].name = "Sleeve"
    addon.flatten.write.write_results(bpy.context, outcomes, settings)
    names = {entry.name for entry in source.wirewarp_pieces}
    assert "Sleeve" in names
    assert {piece.name for piece in outcomes[0].report.pieces} == names


def test_shape_keys_and_groups_of_earlier_pieces_are_gone(source):
    flat = flat_of(source)
    flat.shape_key_add(name="Basis")
    flat.vertex_groups.new(name="piece")
    source.data.vertices[0].co.x -= 1
    bpy.ops.object.wirewarp_flatten()
    assert flat.data.shape_keys is None and "piece" in flat.data.attributes
    places = read(flat.data.vertices, "co", np.float32, 3)
    shown = flat.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    assert np.array_equal(read(shown.vertices, "co", np.float32, 3), places)


def test_export_notices_a_change_that_blender_was_not_notified_of(source, tmp_path, addon):
    assert READY in draw_panels(addon)  # The panel keeps this verdict, but the export checks again.
    places = read(source.data.vertices, "co", np.float32, 3)
    source.data.vertices.foreach_set("co", (2 * places).ravel())
    assert '"Bump" has changed since it was flattened' in export(tmp_path)


def test_deleted_pieces_are_not_ready_to_cut(source, addon, tmp_path):
    select_only(source)
    assert READY in draw_panels(addon)
    bpy.ops.object.duplicate()  # a copy without pieces
    words = draw_panels(addon)
    assert AGAIN.replace("Bump", "Bump.001") in words and READY not in words
    select_only(source)
    bpy.data.objects.remove(flat_of(source))
    words = draw_panels(addon)
    assert AGAIN in words and READY not in words
    assert "no flat pieces" in export(tmp_path)


def test_a_copy_of_the_pieces_is_distinguished_from_them(source, addon, tmp_path):
    select_only(flat_of(source))
    bpy.ops.object.duplicate()
    copy = bpy.context.active_object
    sentence = '"Bump Flat.001" is a copy or a part of earlier pieces. Use "Bump Flat"'
    assert sentence in draw_panels(addon) and sentence in export(tmp_path)
    select_only(source)
    assert export(tmp_path) == "{'FINISHED'}"
    assert any(sentence in note.text for note in report_after(addon, source).notes)
    bpy.data.objects.remove(copy)
    assert not report_after(addon, source).notes


def test_the_longest_name_leaves_room_for_the_suffix_of_its_pieces():
    source = flattened("ä" * 200, bump, size=4)
    bpy.ops.object.wirewarp_flatten()
    (flat,) = [each for each in bpy.data.objects if each.wirewarp_source == source]
    assert flat.name.startswith("ää") and flat.name.endswith("ä Flat")
