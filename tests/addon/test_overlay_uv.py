# SPDX-License-Identifier: GPL-3.0-or-later
"""What the overlay draws in the UV editor. Nothing is drawn here."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from surfaces import bump, flat_of, grid, mark, mark_seam, on_line, select_only

pytestmark = pytest.mark.api

SEAM, RIGID, ELASTIC = on_line(0, 0.0), on_line(1, 0.0), on_line(1, 0.5)


@pytest.fixture
def source():
    """Two pieces with a rigid and an elastic wire through both."""
    target = grid("Bump", bump)
    mark_seam(target, SEAM)
    mark(target, RIGID)
    mark(target, ELASTIC, kind="ELASTIC", tolerance=0.05)
    target.data.wirewarp_names[0].name = "Waist"
    bpy.ops.object.wirewarp_flatten()
    return target


def shown(addon, mode="UV", show_overlays=True):
    """In a UV editor, which there is none of without a window."""
    context = SimpleNamespace(
        mode=bpy.context.mode,
        scene=bpy.context.scene,
        selected_objects=list(bpy.context.selected_objects),
        objects_in_mode_unique_data=list(bpy.context.objects_in_mode_unique_data),
        space_data=SimpleNamespace(mode=mode, overlay=SimpleNamespace(show_overlays=show_overlays)),
    )
    bpy.context.view_layer.update()
    return list(addon.overlay.shown.uv_drawings(context))


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_lines_lie_where_the_pieces_have_them(addon, source, mode):
    select_only(source)
    bpy.ops.object.mode_set(mode=mode)
    (drawing,) = shown(addon)
    places = drawing.lines.places
    scale, flat = source.data["wirewarp_uv_scale"], addon.overlay.objects.marked_lines(flat_of(source), None)
    for kind, sides in (("seam", 1), ("outline", 1), ("rigid", 2), ("elastic", 2)):  # a wire has a face on each side
        on_pieces = lengths(flat.places[kind])
        assert lengths(places[kind]).sum() * scale == pytest.approx(sides * on_pieces.sum(), rel=1e-5)
        assert 0 <= places[kind][:, :2].min() < places[kind][:, :2].max() <= 1
    assert set(drawing.lines.dashes) == {"elastic"}


def lengths(places):
    return np.linalg.norm(np.diff(places.reshape(-1, 2, 3), axis=1), axis=2)


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_lines_are_named_in_every_piece(addon, source, mode):
    select_only(source)
    bpy.ops.object.mode_set(mode=mode)
    names = [name.texts[-1] for name in shown(addon)[0].lines.names]
    assert sorted(names) == sorted(2 * ["Seam 1", "Waist", "Wire 2 ±5%"])


def test_a_selected_flat_piece_shows_its_model(addon, source):
    select_only(flat_of(source))
    assert [drawing.target for drawing in shown(addon)] == [source]


def test_nothing_over_other_maps_images_and_hidden_overlays(addon, source):
    assert shown(addon, mode="VIEW") == shown(addon, show_overlays=False) == []
    source.data.uv_layers.active = source.data.uv_layers.new(name="Texture")
    assert shown(addon) == []
    source.data.uv_layers.active = source.data.uv_layers["WireWarp"]
    assert len(shown(addon)) == 1
    bpy.context.scene.wirewarp.show_lines = False
    assert shown(addon) == []


def test_what_failed_is_red_in_the_map_too(addon):
    source = grid("Spike", lambda x, y: (x, y, 2 * (1 - x * x) * (1 - y * y)))
    mark(source, on_line(0, 0.0))
    mark(source, on_line(1, 0.0))
    with pytest.raises(RuntimeError, match="flipped"):
        bpy.ops.object.wirewarp_flatten(method="WIREWARPING")
    select_only(source)
    (drawing,) = shown(addon)
    faces = {face for issue in addon.state.reports.last_report(source).issues for face in issue.faces}
    assert len(drawing.failures.triangles) == 3 * 2 * len(faces)  # of quads
    assert len(drawing.failures.lines["failed"]) > 0


def test_the_suggested_cut_is_in_the_map(addon, source):
    select_only(source)
    bpy.ops.object.wirewarp_suggest_darts(piece=0)
    (drawing,) = shown(addon)
    on_pieces = addon.overlay.failures.suggested_lines(flat_of(source), bpy.context.evaluated_depsgraph_get())
    in_map = lengths(drawing.failures.lines["proposed"]).sum() * source.data["wirewarp_uv_scale"]
    assert in_map == pytest.approx(2 * lengths(on_pieces).sum(), rel=1e-5)  # there is a face on each side
