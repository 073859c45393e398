# SPDX-License-Identifier: GPL-3.0-or-later
"""Names along the lines of the exported pattern."""

import itertools
import math
import re

import bpy
import numpy as np
import pytest
from drawing import LABEL, SVG, Drawing
from surfaces import bump, flatten, grid, make_object, mark, mark_seam, on_line

BESIDE = 5.0 + 1e-6  # millimeters from the box of a piece, as far as texts beside it reach


@pytest.fixture
def source():
    """Two pieces with a rigid wire through both; a Blender unit is 100 mm."""
    bpy.context.scene.unit_settings.scale_length = 0.1
    target = grid("Bump", bump)
    mark_seam(target, on_line(0, 0.0))
    mark(target, on_line(1, 0.0))
    return target


def exported(source, tmp_path):
    flatten(source)
    path = tmp_path / "pattern.svg"
    assert bpy.ops.object.wirewarp_export_svg(filepath=str(path)) == {"FINISHED"}
    return Drawing(path)


def texts_in(drawing, piece, layer):
    """(line, place, height, angle) of each text of a piece."""
    found = []
    for text in drawing.layer(piece, layer).findall(f"{SVG}text"):
        place = re.match(r"translate\((\S+) (\S+)\) rotate\((\S+)\)", text.get("transform")).groups()
        x, y, angle = map(float, place)
        for span in text.findall(f"{SVG}tspan"):
            height = float(text.get("font-size"))
            middle = float(span.get("y")) - 0.36 * height  # capitals are 0.72 of the size high
            turn = math.radians(angle)
            at = np.array([x - middle * math.sin(turn), y + middle * math.cos(turn)])
            found.append((span.text, at, height, angle))
    return found


def layers_of(drawing, piece):
    return [layer.get(LABEL) for layer in drawing.pieces[piece].findall(f"{SVG}g")]


def names_in(drawing, piece):
    """{name: place} of the names along the lines of a piece, without what a seam joins."""
    return {line.split(":")[0]: place for line, place, _, _ in texts_in(drawing, piece, "Line Names")}


def box_of(text):
    """The lowest and the highest corner of a level or upright line of text; half as wide as high a letter at least."""
    line, place, height, angle = text
    size = np.array([0.5 * height * len(line), 0.72 * height])
    half = (size if angle % 180 == 0 else size[::-1]) / 2
    return place - half, place + half


def strips(*widths):
    """A level sheet, 200 mm long, cut into strips of these widths in millimeters, with a wire across all of them."""
    xs = np.concatenate([[0], np.cumsum(widths)]).tolist()
    row = len(xs)
    vertices = [(x, 10.0 * y, 0.0) for y in range(21) for x in xs]
    cells = [y * row + x for y in range(20) for x in range(row - 1)]
    target = make_object("Strips", vertices, [(i, i + 1, i + row + 1, i + row) for i in cells])
    bpy.context.scene.unit_settings.scale_length = 0.001
    for x in xs[1:-1]:
        mark_seam(target, on_line(0, x))
    mark(target, on_line(1, 50.0))
    return target


def test_both_sides_of_a_seam_have_its_number_and_wires_their_names(source, tmp_path):
    drawing = exported(source, tmp_path)
    for piece in drawing.pieces:
        names = names_in(drawing, piece)
        assert names.keys() == {"Seam 1", "Wire 1"}
        (outline,) = drawing.lines(piece, "Cut")
        (wire,) = drawing.lines(piece, "Rigid Wires")
        low, high = outline.min(axis=0), outline.max(axis=0)
        for name, line, distance in (("Seam 1", outline, 3.0), ("Wire 1", wire, 3.0)):
            assert np.all((low < names[name]) & (names[name] < high))
            dense = np.concatenate([np.linspace(a, b, 50) for a, b in zip(line[:-1], line[1:], strict=True)])
            nearest = np.linalg.norm(dense - names[name], axis=1).min()
            assert nearest == pytest.approx(distance, abs=0.6)


def test_a_wire_shorter_than_its_name_goes_without(source, tmp_path):
    source.data.wirewarp_names[0].name = "Waist, as measured on the fitting day, " * 3
    drawing = exported(source, tmp_path)
    assert all(names_in(drawing, piece).keys() == {"Seam 1"} for piece in drawing.pieces)


def test_where_a_wire_ends_at_the_seam_its_number_stands_beside(source, tmp_path):
    drawing = exported(source, tmp_path)  # the wire meets the seam in its middle
    for piece in drawing.pieces:
        (wire,) = drawing.lines(piece, "Rigid Wires")
        ends = np.linalg.norm(wire[[0, -1]] - names_in(drawing, piece)["Seam 1"], axis=1)
        assert ends.min() > 15


def test_names_lie_inside_narrow_pieces_or_close_beside_and_clear_of_each_other(tmp_path):
    drawing = exported(strips(4, 8, 10, 14, 24, 40, 50), tmp_path)
    for piece in drawing.pieces:
        (outline,) = drawing.lines(piece, "Cut")
        texts = texts_in(drawing, piece, "Line Names")
        cards = texts_in(drawing, piece, "Text") if "Text" in layers_of(drawing, piece) else []
        boxes = [box_of(text) for text in [*texts, *cards]]
        least, most = outline.min(axis=0) - BESIDE, outline.max(axis=0) + BESIDE
        assert all(np.all(least < low) and np.all(high < most) for low, high in boxes)
        assert not any(
            np.all((low < top) & (bottom < high)) for (low, high), (bottom, top) in itertools.combinations(boxes, 2)
        )
        sides = 1 if np.ptp(outline, axis=0).min() in (pytest.approx(4, abs=0.01), pytest.approx(50, abs=0.01)) else 2
        assert sum("Wire" not in line for line, *_ in texts) == sides


def test_what_a_piece_is_too_narrow_for_stands_beside_it(tmp_path):
    drawing = exported(strips(2, 40), tmp_path)
    narrow = min(drawing.pieces, key=lambda piece: np.ptp(drawing.lines(piece, "Cut")[0], axis=0).min())
    (outline,) = drawing.lines(narrow, "Cut")
    boxes = [box_of(text) for layer in ("Text", "Line Names") for text in texts_in(drawing, narrow, layer)]
    assert boxes
    assert all(np.any(high < outline.min(axis=0)) or np.any(outline.max(axis=0) < low) for low, high in boxes)


def test_notches_end_inside_narrow_pieces(tmp_path):
    drawing = exported(strips(3, 8, 40), tmp_path)
    for piece in drawing.pieces:
        (outline,) = drawing.lines(piece, "Cut")
        width = np.ptp(outline, axis=0).min()
        notches = drawing.lines(piece, "Notches")
        lengths = [np.linalg.norm(b - a) for a, b in notches]
        assert lengths == pytest.approx([min(5.0, 0.3 * width)] * len(notches), abs=0.01)
        low, high = outline.min(axis=0) - 0.01, outline.max(axis=0) + 0.01
        assert all(np.all((low < end) & (end < high)) for _, end in notches)
