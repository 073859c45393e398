# SPDX-License-Identifier: GPL-3.0-or-later
"""Sizes of the pattern as they are told, and the square to measure, in the units that the cutter's ruler has."""

import re

import bpy
import numpy as np
import pytest
from drawing import Drawing
from surfaces import bump, flat_of, grid, mark_seam, on_line, select_only


@pytest.fixture
def source():
    """Two pieces; a Blender unit is 100 mm."""
    units = bpy.context.scene.unit_settings
    units.scale_length, units.length_unit = 0.1, "MILLIMETERS"
    target = grid("Bump", bump)
    mark_seam(target, on_line(0, 0.0))
    bpy.ops.object.wirewarp_flatten()
    return target


def test_sizes_told_before_saving(source, addon):
    choices = addon.export.export.PatternChoices(0.0, 100.0, "cut")
    pattern = addon.solve.steps.in_one_go(addon.export.read.read_pattern(bpy.context.scene, source).making(choices))
    total, largest = addon.export.steps.size_sentences(pattern, pattern.svg_size)
    assert re.fullmatch(r"2 pieces on \d+ × \d+ mm\.", total)
    wide, high = map(int, re.fullmatch(r"Largest piece: Top (?:Left|Right), (\d+) × (\d+) mm\.", largest).groups())
    assert 200 < max(wide, high) < 260
    assert 100 < min(wide, high) < 130


def test_of_many_pieces_over_one_another_the_first_are_named(addon):
    module, square = addon.core.pattern, np.array([(0, 0), (9, 0), (9, 9), (0, 9)], dtype=float)
    told = addon.export.steps.crossing_sentence

    def pattern(count):
        outlines = [[module.Line("cut", square + k, closed=True)] for k in range(count)]
        pieces = [module.PatternPiece(k, f"P{k}", outline, [], []) for k, outline in enumerate(outlines)]
        return module.Pattern("Pile", pieces, "none", module.UnitSystem())

    assert told(pattern(1)) == ""
    assert "overlap: P0, P1, P2, P3. Move" in told(pattern(4))
    assert "overlap: P0, P1, P2, P3 and 2 more. Move" in told(pattern(6))


@pytest.mark.parametrize("scale", [(0.9, 0.9, 0.9), (-1, 1, 1)])
@pytest.mark.parametrize("by_parent", [False, True])
def test_pieces_that_are_scaled_as_a_whole_are_refused(source, tmp_path, scale, by_parent):
    scaled = flat_of(source)
    if by_parent:
        scaled = flat_of(source).parent = bpy.data.objects.new("Table", None)
        bpy.context.scene.collection.objects.link(scaled)
    scaled.scale = scale
    with pytest.raises(RuntimeError, match='"Bump Flat" or its parent is scaled or mirrored.*scale "Bump" and flatten'):
        bpy.ops.object.wirewarp_export_svg(filepath=str(tmp_path / "pattern.svg"))
    scaled.scale, scaled.rotation_euler = (1, 1, 1), (0.1, 0.2, 0.3)
    assert bpy.ops.object.wirewarp_export_svg(filepath=str(tmp_path / "pattern.svg")) == {"FINISHED"}


def test_one_of_several_selected_models_is_written_and_that_is_said(source, tmp_path, capfd):
    other = grid("Other", bump)
    bpy.ops.object.wirewarp_flatten()
    path = str(tmp_path / "pattern.svg")
    bpy.ops.object.wirewarp_export_svg(filepath=path)
    assert 'Exported "Other" only' not in capfd.readouterr().out
    select_only(other, source, flat_of(source))
    bpy.ops.object.wirewarp_export_svg(filepath=path)
    assert 'Print at 100% scale. Exported "Other" only; export the others separately.' in capfd.readouterr().out


def test_who_measures_in_inches_is_told_sizes_in_inches(source, tmp_path, capfd):
    units = bpy.context.scene.unit_settings
    units.system, units.scale_length = "IMPERIAL", 0.1
    path = tmp_path / "pattern.svg"
    bpy.ops.object.wirewarp_export_svg(filepath=str(path))
    width, height = (float(Drawing(path).root.get(side)[:-2]) for side in ("width", "height"))
    said = f"2 pieces on {width:.0f} × {height:.0f} mm ({width / 25.4:.1f} × {height / 25.4:.1f} in)."
    assert said in capfd.readouterr().out
