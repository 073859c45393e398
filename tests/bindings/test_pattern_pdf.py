# SPDX-License-Identifier: GPL-3.0-or-later
"""PDF files have the actual size, all lines and named layers, as rendered by pdfium."""

import re

import numpy as np
import pypdfium2
import pytest
import wirewarp
from patterns import MILLIMETER, SCALE, dark, extent, quads, rectangle, sample
from wirewarp.pattern import Pattern


def test_prints_have_the_actual_size(tmp_path):
    pattern = Pattern.from_result(rectangle(150, 700), allowance=10.0)
    pattern.write(tmp_path / "strip.pdf", paper=1000)
    (page,) = pypdfium2.PdfDocument(tmp_path / "strip.pdf")
    width, height = (side / MILLIMETER for side in page.get_size())
    assert width == pytest.approx(1000, abs=1e-3)
    above_the_test_square = dark(page)[int(168 * SCALE) :]
    line = 0.5  # millimeters, the width of the cutting line
    assert sorted(extent(above_the_test_square)) == pytest.approx((170 + line, 720 + line), abs=1.5 / SCALE)


@pytest.mark.parametrize("name", ["Hat", "Carnival mask"])
def test_a4_sheets_put_together_show_the_same_lines_as_one_page(tmp_path, name):
    pattern = sample(name).with_only([])
    pattern.write(tmp_path / "tiles.pdf", paper="a4", keep_places=True)
    pattern.write(tmp_path / "page.pdf", paper="projector")
    scale, wide = 6.0, 2  # pixels per millimeter; pixels by which a line may be off

    def black(page):
        """Return a mask of the cutting lines. Everything else is gray."""
        image = page.render(scale=scale / MILLIMETER, grayscale=True).to_numpy().squeeze()
        return image[::-1] < 40

    (page,) = pypdfium2.PdfDocument(tmp_path / "page.pdf")
    bottom = round((10 + 158) * scale)  # margin and test square
    size = np.ceil(pattern.size * scale).astype(int)
    one = black(page)[bottom - 12 : bottom + size[1] + 12, 60 - 12 : 60 + size[0] + 12]

    document = pypdfium2.PdfDocument(tmp_path / "tiles.pdf")
    names = [re.search(r"\b([A-Z])(\d)", each.get_textpage().get_text_range()).groups() for each in document][1:]
    shown = np.array(document[1].get_size()) / MILLIMETER - 20
    high, wide_by = max(ord(row) - 64 for row, _ in names), max(int(column) for _, column in names)
    whole = np.zeros(np.ceil(shown * (wide_by, high) * scale).astype(int)[::-1], dtype=bool)
    for (row, column), sheet in zip(names, list(document)[1:], strict=True):
        inner = black(sheet)[60:-60, 60:-60]
        x, y = np.rint((int(column) - 1, high - (ord(row) - 64)) * (shown - 10) * scale).astype(int)
        whole[y : y + inner.shape[0], x : x + inner.shape[1]] |= inner
    # The pattern ends 5 mm below the upper edge of the printed area.
    top = round((high * (shown[1] - 10) + 10 - 5) * scale)
    tiled = whole[top - size[1] - 12 : top + 12, 30 - 12 : 30 + size[0] + 12]
    for first, second in ((one, tiled), (tiled, one)):
        height, width = (min(side) for side in zip(first.shape, second.shape, strict=True))
        near = np.zeros_like(second)
        for dx in range(-wide, wide + 1):
            for dy in range(-wide, wide + 1):
                near |= np.roll(second, (dy, dx), axis=(0, 1))
        missing = first[:height, :width] & ~near[:height, :width]
        assert first.any() and not missing.any()


def test_pieces_that_fit_on_sheets_are_not_cut_apart(tmp_path):
    points = [(x + 400 * n, y) for n in range(3) for x, y in ((0, 0), (300, 0), (300, 200), (0, 200))]
    pattern = Pattern.from_result(quads(points, np.arange(12).reshape(3, 4).tolist()), notch_spacing=0)
    assert pattern.write(tmp_path / "x.pdf", paper="a3").sheets == 1 + 3
    document = pypdfium2.PdfDocument(tmp_path / "x.pdf")
    for page in list(document)[1:]:
        pixels = dark(page, 2.0)
        frame = round(12 * 2)
        inside = pixels[frame:-frame, frame:-frame]
        # Rows and columns with over 200 dark pixels have a line of the piece, because texts are shorter.
        long = inside.sum(axis=1) > 200, inside.sum(axis=0) > 200
        across, up = sorted(extent(np.outer(*long), 2.0))
        assert (across, up) == pytest.approx((220.5, 320.5), abs=1)


def test_layers_are_named_and_the_grid_is_hidden(tmp_path):
    sample("Hat").write(tmp_path / "hat.pdf", paper="projector")
    data = (tmp_path / "hat.pdf").read_bytes()
    names = re.findall(rb"/Type /OCG/Name \(([^)]*)\)|/Name \(([^)]*)\)", data)
    found = {(one or other).decode() for one, other in names}
    assert {"Cut", "Sew", "Notches", "Rigid Wires", "Text", "Line Names", "Grid"} <= found
    (page,) = pypdfium2.PdfDocument(tmp_path / "hat.pdf")
    hidden = re.search(rb"/OFF \[(\d+) 0 R\]", data)
    assert hidden and dark(page, 1.0).mean() < 0.05


@pytest.mark.parametrize(
    ("paper", "words"),
    [
        ("a5", "paper is 'a5'"),
        (50, "the width of a roll"),
        ([210, 297], "the width of a roll, is .210, 297."),
        (float("nan"), "nan"),
        (200, "too large for a roll of 200 mm"),
    ],
)
def test_impossible_papers_are_refused(tmp_path, paper, words):
    with pytest.raises(wirewarp.FlattenError, match=words):
        Pattern.from_result(rectangle(300, 300)).write(tmp_path / "x.pdf", paper=paper)
    assert list(tmp_path.iterdir()) == []


def test_a_pattern_of_kilometers_is_refused(tmp_path):
    pattern = Pattern.from_result(rectangle(300, 300), millimeters_per_unit=1e6, notch_spacing=0)
    sentences = {"a4": "more than 2000 sheets", "projector": "choose a roll or sheets", 1000: "too large"}
    for paper, words in sentences.items():
        with pytest.raises(wirewarp.FlattenError, match=words):
            pattern.write(tmp_path / "x.pdf", paper=paper)
