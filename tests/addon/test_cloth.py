# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces are shaped for the fabric of the panel, and their report measures strains along the threads."""

import math

import bpy
import numpy as np
import pytest
from everything import draw_panels
from flattening import flat_places, flat_sources, report_after
from surfaces import bump, flat_of, grid, half_cylinder, on_line, read

THREADS = ("weft_strain", "warp_strain", "shear_angle")


@pytest.fixture
def source():
    return grid("Bump", bump, faces="triangles", wire=on_line(0, 0.0))


def test_a_piece_for_a_fabric_has_the_shape_that_the_library_returns(source, addon):
    bpy.ops.object.wirewarp_flatten(cloth="DENIM", orientation="UP")
    items = addon.properties.WIREWARP_PG_settings.bl_rna.properties["cloth"].enum_items
    named = [item.identifier.lower() for item in items if item.identifier not in ("NONE", "CUSTOM")]
    assert named == list(addon.core.Cloth.presets())
    library, mesh = addon.core.library(), source.data
    vertices = read(mesh.vertices, "co", np.float32, 3).astype(np.float64)
    faces = read(mesh.loops, "vertex_index", np.int32).reshape(-1, 3)
    wire = library.Wire([4 + 9 * k for k in range(9)])
    options = library.Options(cloth="denim", orientation="up")
    (piece,) = library.flatten(vertices, faces, wires=[wire], options=options).pieces
    (entry,) = addon.state.reports.last_report(source).pieces
    assert entry.arap_energy == pytest.approx(piece.metrics.arap_energy, rel=1e-6)
    of_flat = read(flat_of(source).data.attributes["source_face"].data, "value", np.int32)
    for name in THREADS:
        expected = np.empty(len(faces))
        expected[piece.source_face] = getattr(piece.metrics, f"face_{name}")
        found = read(flat_of(source).data.attributes[name].data, "value", np.float32)
        wanted = np.abs(expected) if name == "shear_angle" else expected
        assert found == pytest.approx(wanted[of_flat], abs=1e-5)


def test_maps_of_threads_need_a_fabric(source, addon):
    bpy.ops.object.wirewarp_flatten(cloth="WOVEN")
    flat, names = flat_of(source).data, {color_map.attribute for color_map in addon.solve.maps.CLOTH_MAPS}
    assert names <= set(flat.color_attributes.keys()) and names <= set(addon.state.record.read_record(flat).ranges)
    bpy.ops.object.wirewarp_flatten()
    assert not (names | set(THREADS)) & set(flat.attributes.keys())


def test_a_fabric_that_does_not_stretch_enough_is_reported_with_the_place(source, addon, capfd):
    report = report_after(addon, source, cloth="WOVEN", gives_across=1.0, gives_along=1.0)
    (piece,), (hint,) = report.pieces, [each for each in report.hints if each.code == "beyond_cloth"]
    threads = piece.threads
    assert threads.over and max(threads.across, threads.along) > 0.01
    ways = {"across": threads.across, "along": threads.along}
    needed = " and ".join(f"{addon.core.percent_text(share)} {way}" for way, share in ways.items() if share > 0.01)
    sentence = f"Bump must stretch {needed}, but this woven cotton stretches only 1.0%"
    assert sentence in capfd.readouterr().out and sentence in draw_panels(addon)
    assert 0 < len(hint.faces) < len(source.data.polygons)
    assert addon.core.verdict(report).kind == "beyond fabric"
    assert bpy.ops.mesh.wirewarp_select_result(what="HINT", index=report.hints.index(hint)) == {"FINISHED"}


def grain(source):
    """Return the angle of the middle wire in the flat piece, in degrees from upright, counterclockwise, modulo 180."""
    sources = flat_sources(source).tolist()
    along = flat_places(source)[sources.index(4 + 9 * 8)] - flat_places(source)[sources.index(4)]
    return math.degrees(math.atan2(-along[0], along[1])) % 180


def test_the_grain_angle_turns_the_grain_wire(source, addon, capfd):
    bpy.ops.object.wirewarp_flatten(cloth="WOVEN", grain_angle=math.radians(45))
    assert "Grain Angle was not used" in capfd.readouterr().out
    ((_, wire),) = addon.state.identities.listed_wires(source)
    bpy.ops.mesh.wirewarp_grain_wire(edge=wire.edges[0])
    bpy.ops.object.wirewarp_flatten(cloth="WOVEN")
    assert min(grain(source), 180 - grain(source)) == pytest.approx(0, abs=1e-3)
    bpy.ops.object.wirewarp_flatten(cloth="WOVEN", grain_angle=math.radians(45))
    assert grain(source) == pytest.approx(45, abs=1e-3)


def test_stretched_fabric_is_cut_smaller(addon):
    target = grid("Half", half_cylinder, size=16, wire=on_line(0, 0.0))
    bpy.ops.object.wirewarp_flatten(orientation="UP", cloth="SWIM")
    ((_, wire),) = addon.state.identities.listed_wires(target)
    bpy.ops.mesh.wirewarp_grain_wire(edge=wire.edges[0])
    bpy.ops.object.wirewarp_flatten(cloth="SWIM", keep_places=False)
    plain = np.ptp(flat_places(target), axis=0)
    bpy.ops.object.wirewarp_flatten(cloth="SWIM", worn_across=20.0, worn_along=10.0, keep_places=False)
    assert np.ptp(flat_places(target), axis=0) == pytest.approx(plain / (1.2, 1.1), rel=1e-5)
    report = addon.state.reports.last_report(target)
    (piece,) = report.pieces
    assert report.ok and all(chain.ok for chain in (*piece.outline, *piece.wires))
    assert piece.threads.across == pytest.approx(0.2, abs=1e-4)
    assert not piece.threads.over  # The stretch is intended.
