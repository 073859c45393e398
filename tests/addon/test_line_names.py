# SPDX-License-Identifier: GPL-3.0-or-later
"""Names along the lines of the exported pattern."""

import re

import bpy
import numpy as np
import pytest
from drawing import SVG, Drawing
from surfaces import bump, grid, mark, mark_seam, on_line, select_only


@pytest.fixture
def source():
    """Two pieces with a rigid wire through both; a Blender unit is 100 mm."""
    bpy.context.scene.unit_settings.scale_length = 0.1
    target = grid("Bump", bump)
    mark_seam(target, on_line(0, 0.0))
    mark(target, on_line(1, 0.0))
    return target


def exported(source, tmp_path):
    select_only(source)
    bpy.ops.object.wirewarp_flatten()
    path = tmp_path / "pattern.svg"
    assert bpy.ops.object.wirewarp_export_svg(filepath=str(path)) == {"FINISHED"}
    return Drawing(path)


def names_in(drawing, piece):
    """{name: place} of the names along the lines of a piece."""
    texts = drawing.layer(piece, "Line Names").findall(f"{SVG}text")
    places = [re.match(r"translate\((\S+) (\S+)\)", text.get("transform")).groups() for text in texts]
    return {
        text.find(f"{SVG}tspan").text: np.array(place, dtype=float) for text, place in zip(texts, places, strict=True)
    }


def test_both_sides_of_a_seam_have_its_number_and_wires_their_names(source, tmp_path):
    drawing = exported(source, tmp_path)
    for piece in drawing.pieces:
        names = names_in(drawing, piece)
        assert names.keys() == {"Seam 1", "Wire 1"}
        (outline,) = drawing.lines(piece, "Cut")
        (wire,) = drawing.lines(piece, "Rigid Wires")
        low, high = outline.min(axis=0), outline.max(axis=0)
        for name, line, distance in (("Seam 1", outline, 9.0), ("Wire 1", wire, 3.5)):
            assert np.all((low < names[name]) & (names[name] < high))
            dense = np.concatenate([np.linspace(a, b, 50) for a, b in zip(line[:-1], line[1:], strict=True)])
            nearest = np.linalg.norm(dense - names[name], axis=1).min()
            assert nearest == pytest.approx(distance, abs=0.6)


def test_a_wire_shorter_than_its_name_goes_without(source, tmp_path):
    source.data.wirewarp_names[0].name = "The line that goes all around the bump from its left to its right"
    drawing = exported(source, tmp_path)
    assert all(names_in(drawing, piece).keys() == {"Seam 1"} for piece in drawing.pieces)


def test_where_a_wire_ends_at_the_seam_its_number_stands_beside(source, tmp_path):
    drawing = exported(source, tmp_path)  # the wire meets the seam in its middle
    for piece in drawing.pieces:
        (wire,) = drawing.lines(piece, "Rigid Wires")
        ends = np.linalg.norm(wire[[0, -1]] - names_in(drawing, piece)["Seam 1"], axis=1)
        assert ends.min() > 15
