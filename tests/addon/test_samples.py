# SPDX-License-Identifier: GPL-3.0-or-later
"""The sample files contain the data of blend_samples/, and pieces of the top are named after parts of garments."""

import json
import sys
import zlib
from pathlib import Path

import bpy
import numpy as np
import pytest
from flattening import edge_vertices
from suggesting import pairs
from surfaces import read

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "blend_samples"))

import shapes

FOLDER = Path(shapes.__file__).resolve().parents[1]
SAMPLES = {shape.name.lower().replace(" ", "_"): shape for shape in shapes.all_shapes()}


def open_sample(name):
    bpy.ops.wm.open_mainfile(filepath=str(FOLDER / f"{name}.blend"))
    return bpy.context.view_layer.objects.active


def test_there_is_one_file_for_each_shape():
    assert {path.stem for path in FOLDER.glob("*.blend")} == set(SAMPLES)


def check_mesh_and_marks(shape, mesh):
    assert read(mesh.vertices, "co", np.float32, 3) == pytest.approx(shape.vertices, abs=1e-7)
    assert [tuple(polygon.vertices) for polygon in mesh.polygons] == shape.faces
    edges = edge_vertices(mesh)
    assert pairs(edges[read(mesh.edges, "use_seam", bool)]) == pairs(shape.seams)
    ids = read(mesh.attributes["wirewarp_wire"].data, "value", np.int32)
    tolerances = read(mesh.attributes["wirewarp_tolerance"].data, "value", np.float32)
    assert (tolerances[ids == 0] == 0).all()
    for wire in shape.wires:
        chain = np.column_stack([wire.vertices[:-1], wire.vertices[1:]])
        own = ids == zlib.crc32(wire.name.encode()) & 0x7FFFFFFF
        assert pairs(edges[own]) == pairs(chain) and (tolerances[own] == np.float32(wire.tolerance)).all()
    assert {entry.name for entry in mesh.wirewarp_names} == {wire.name for wire in shape.wires}


def check_eases_and_fabric(addon, shape, mesh):
    starts = read(mesh.loops, "vertex_index", np.int32)
    ends = np.concatenate([np.roll(starts[list(polygon.loop_indices)], -1) for polygon in mesh.polygons])
    ratios = addon.state.allowances.SIDE_EASES.read(mesh)
    eased = np.flatnonzero(ratios)
    found = {(int(starts[corner]), int(ends[corner])): ratios[corner] for corner in eased}
    assert found == {tuple(pair): np.float32(ease.ratio) for ease in shape.eases for pair in ease.half_edges.tolist()}
    settings = bpy.context.scene.wirewarp
    assert settings.cloth == (shape.cloth or "none").upper()
    assert (settings.worn_across, settings.worn_along) == pytest.approx([100 * share for share in shape.stretch])
    assert settings.fairness == pytest.approx(shape.fairness)
    assert settings.allowance == pytest.approx(shape.allowance)


def check_view(mesh):
    """Check that the model fills more than half of a window, and is not cut off.

    The window is 1.5 times as wide as high, and the focal length is Blender's default of 50 mm.
    """
    points = read(mesh.vertices, "co", np.float32, 3)
    areas = [area for screen in bpy.data.screens for area in screen.areas if area.type == "VIEW_3D"]
    assert areas
    for view in (area.spaces.active.region_3d for area in areas):
        x, y, z = ((points - np.array(view.view_location)) @ np.array(view.view_rotation.to_matrix())).T
        across, upward = 50 / 36 * x / (view.view_distance - z), 1.5 * 50 / 36 * y / (view.view_distance - z)
        farthest = float(np.abs([across, upward]).max())
        assert 0.5 < farthest < 1


@pytest.mark.parametrize("name", SAMPLES)
def test_the_file_contains_what_the_script_makes_and_opens_with_a_view_of_it(name, addon):
    shape, mesh = SAMPLES[name], open_sample(name).data
    check_mesh_and_marks(shape, mesh)
    check_eases_and_fabric(addon, shape, mesh)
    check_view(mesh)


def test_the_sleeves_of_the_top_are_named_sleeves(tmp_path):
    open_sample("fitted_top")
    settings = bpy.context.scene.wirewarp
    chosen = {name: getattr(settings, name) for name in ("cloth", "worn_across", "worn_along", "fairness")}
    report_path = tmp_path / "report.json"
    assert bpy.ops.object.wirewarp_flatten(report_path=str(report_path), **chosen) == {"FINISHED"}
    (report,) = json.loads(report_path.read_text())["objects"]
    assert sorted(piece["name"] for piece in report["pieces"]) == ["Back", "Front", "Left sleeve", "Right sleeve"]
