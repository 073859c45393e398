# SPDX-License-Identifier: GPL-3.0-or-later
"""The overlay has correct lines and names in the UV editor. These tests do not draw them."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from surfaces import bump, flat_of, grid, mark, on_line, select_only

pytestmark = pytest.mark.api

SEAM, RIGID, ELASTIC = on_line(0, 0.0), on_line(1, 0.0), on_line(1, 0.5)


@pytest.fixture
def source():
    """Return a flattened model of two pieces with a rigid and an elastic wire through both."""
    target = grid("Bump", bump, seam=SEAM, wire=RIGID)
    mark(target, ELASTIC, kind="ELASTIC", tolerance=0.05)
    target.data.wirewarp_names[0].name = "Waist"
    bpy.ops.object.wirewarp_flatten()
    return target


def shown(addon, mode="UV", show_overlays=True):
    """Return the drawings of a stand-in for the UV editor, because Blender has no editor without a window."""
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
def test_lines_and_names_are_at_the_pieces_in_the_map(addon, source, mode):
    select_only(source)
    bpy.ops.object.mode_set(mode=mode)
    (drawing,) = shown(addon)
    places = drawing.lines.places
    scale, flat = source.data["wirewarp_uv_scale"], addon.overlay.objects.marked_lines(flat_of(source), None)
    # Wires are drawn twice, once for the faces on each side.
    for kind, sides in (("seam", 1), ("outline", 1), ("rigid", 2), ("elastic", 2)):
        on_pieces = lengths(flat.places[kind])
        assert lengths(places[kind]).sum() * scale == pytest.approx(sides * on_pieces.sum(), rel=1e-5)
        assert 0 <= places[kind][:, :2].min() < places[kind][:, :2].max() <= 1
    assert set(drawing.lines.dashes) == {"elastic"}
    names = [name.texts[-1] for name in drawing.lines.names]
    assert sorted(names) == sorted(2 * ["Seam 1", "Waist", "Wire 2 ±5%"])
    if mode == "OBJECT":
        select_only(flat_of(source))  # If pieces are active, the editor shows the map of their model.
        assert [drawing.target for drawing in shown(addon)] == [source]


def lengths(places):
    return np.linalg.norm(np.diff(places.reshape(-1, 2, 3), axis=1), axis=2)


def test_nothing_is_drawn_over_other_maps_or_images_or_with_hidden_overlays(addon, source):
    assert shown(addon, mode="VIEW") == shown(addon, show_overlays=False) == []
    source.data.uv_layers.active = source.data.uv_layers.new(name="Texture")
    assert shown(addon) == []
    source.data.uv_layers.active = source.data.uv_layers["WireWarp"]
    assert len(shown(addon)) == 1
    bpy.context.scene.wirewarp.show_lines = False
    assert shown(addon) == []


def test_the_suggested_cut_is_in_the_map(addon, source):
    select_only(source)
    bpy.ops.object.wirewarp_suggest_darts(piece=0)
    (drawing,) = shown(addon)
    on_pieces = addon.overlay.failures.suggested_lines(flat_of(source), bpy.context.evaluated_depsgraph_get())
    in_map = lengths(drawing.failures.lines["proposed"]).sum() * source.data["wirewarp_uv_scale"]
    assert in_map == pytest.approx(lengths(on_pieces).sum(), rel=1e-5)
