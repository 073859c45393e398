# SPDX-License-Identifier: GPL-3.0-or-later
"""SVG files have a layer, a color and dashes for each kind of line, a test square, and groups with names."""

import re

import numpy as np
import pytest
import wirewarp
from drawing import LABEL, SVG, Drawing, points_of, steps
from patterns import cut_polygon, grid
from wirewarp.pattern import Pattern

GROUPMODE = "{http://www.inkscape.org/namespaces/inkscape}groupmode"
KINDS = ["Rigid Wires", "Elastic Wires", "Free Wires"]


@pytest.fixture
def drawn(tmp_path):
    """Return a function that draws two pieces. A wire of each kind crosses both pieces."""
    chains = [list(range(3 * row, 3 * row + 3)) for row in (1, 2, 3)]
    wires = [wirewarp.Wire(chain, tolerance) for chain, tolerance in zip(chains, (0.0, 0.02, np.inf), strict=True)]
    seams = [(3 * row + 1, 3 * row + 4) for row in range(4)]
    result = grid([0, 150, 300], range(0, 300, 60), seams=seams, wires=wires)

    def draw(**options):
        names = options.pop("piece_names", ["Left", "Right"])
        pattern = Pattern.from_result(result, piece_names=names, **options)
        pattern.write(tmp_path / "a.svg")
        return pattern, Drawing(tmp_path / "a.svg")

    return draw


def test_kinds_of_lines_differ_by_layer_color_and_dashes(drawn):
    _, drawing = drawn()
    layers = list(drawing.pieces["Left"].findall(f"{SVG}g"))
    assert all(layer.get(GROUPMODE) == "layer" for layer in layers)
    by_label = {layer.get(LABEL): layer for layer in layers}
    labels = ["Cut", *KINDS, "Notches", "Sew"]
    assert set(by_label) == {*labels, "Grain", "Text", "Line Names"}
    assert list(by_label)[-1] == "Cut"  # a cutter must cut the outline last
    lines = [by_label[label].find(f"{SVG}path") for label in labels]
    assert len({line.get("stroke") for line in lines}) == 6
    assert ["stroke-dasharray" in line.attrib for line in lines] == [False, False, True, True, False, True]


def test_every_line_has_its_own_style_attributes(drawn):
    """Programs of cutters ignore style sheets. Without attributes, they would fill closed lines with black."""
    root = drawn()[1].root
    lines = list(root.iter(f"{SVG}path"))
    assert lines
    assert all(line.get("fill") == "none" and re.fullmatch("#[0-9a-f]{6}", line.get("stroke")) for line in lines)
    assert all(float(line.get("stroke-width")) > 0 for line in lines)
    assert root.find(f"{SVG}style") is None


@pytest.mark.parametrize(("units", "side", "label"), [("metric", 100, "100 mm"), ("imperial", 101.6, "4 in")])
def test_page_and_square_are_in_millimeters_and_the_allowance_is_printed(drawn, units, side, label):
    pattern, drawing = drawn(units=units, allowance=0.0)
    width, height = (drawing.root.get(side)[:-2] for side in ("width", "height"))
    assert [float(width), float(height)] == pytest.approx(pattern.svg_size, abs=1e-3)
    assert drawing.root.get("viewBox") == f"0 0 {width} {height}"
    (scale,) = [group for group in drawing.root.findall(f"{SVG}g") if group.get(LABEL) == "Scale"]
    square = points_of(scale.find(f"{SVG}path"))
    assert steps(square) == pytest.approx([side] * 4)
    assert [span.text for span in scale.iter(f"{SVG}tspan")] == [label, "Measure before cutting", "No seam allowance"]
    pieces = np.concatenate(drawing.outlines())
    everything = np.concatenate([pieces, square])
    assert everything.min(axis=0) == pytest.approx([10, 10], abs=1e-3)
    assert everything.max(axis=0) == pytest.approx([float(width) - 10, float(height) - 10], abs=1e-3)
    assert np.any(square.min(axis=0) >= pieces.max(axis=0)) or np.any(square.max(axis=0) <= pieces.min(axis=0))


def test_groups_are_named_even_if_names_are_not_valid_ids(drawn):
    _, drawing = drawn(piece_names=["1 <Ärmel>", "1 >Ärmel<"])
    assert list(drawing.pieces) == ["1 <Ärmel>", "1 >Ärmel<"]
    ids = [element.get("id") for element in drawing.root.iter() if element.get("id")]
    assert len(set(ids)) == len(ids)
    assert all(re.fullmatch(r"[^\W\d][\w.-]*|_[\w.-]*", each) for each in ids)
    assert [group.get(LABEL) for group in drawing.pieces.values()] == list(drawing.pieces)


def test_the_text_of_a_piece_is_inside_and_has_name_and_area(drawn):
    pattern, drawing = drawn(allowance=0.0)
    for piece in pattern.pieces:
        text = drawing.layer(piece.name, "Text").find(f"{SVG}text")
        lines = [line.text for line in text.findall(f"{SVG}tspan")]
        assert piece.name in lines
        assert float(lines[-1].removesuffix(" cm²")) == pytest.approx(cut_polygon(piece).area / 100, abs=0.06)
        place = [float(number) for number in re.match(r"translate\((\S+) (\S+)\)", text.get("transform")).groups()]
        (outline,) = drawing.lines(piece.name, "Cut")
        assert np.all((outline.min(axis=0) < place) & (place < outline.max(axis=0)))
