# SPDX-License-Identifier: GPL-3.0-or-later
"""Written pages have the number, sizes and contents that page_sizes() and pages() report."""

import re
from dataclasses import replace
from functools import cache
from itertools import combinations

import numpy as np
import pypdfium2
import pytest
import shapely
import wirewarp
from patterns import MILLIMETER, letters, line_string, quads, rectangle, sample
from wirewarp.pattern import Line, Pattern
from wirewarp.pattern.geometry import Motion
from wirewarp.pattern.label import helvetica
from wirewarp.pattern.make.outline import flat_piece
from wirewarp.pattern.model import Point
from wirewarp.pattern.sheet.drawing import LOOKS, WIRES
from wirewarp.pattern.sheet.furniture import SIZE, scale_marks
from wirewarp.pattern.sheet.plan import plan


@pytest.mark.parametrize(
    ("paper", "sides"),
    [
        ("a4", (210, 297)),
        ("letter", (215.9, 279.4)),
        ("a3", (297, 420)),
        ("a0", (841, 1189)),
        ("24in", (609.6, None)),
        (700.0, (700, None)),
        ("projector", (None, None)),
    ],
)
def test_the_pages_are_reported_before_they_are_written(tmp_path, paper, sides):
    pattern = sample("Hat")
    sizes = pattern.page_sizes(paper)
    written = pattern.write(tmp_path / "pages.pdf", paper=paper)
    pages = np.array([page.get_size() for page in pypdfium2.PdfDocument(tmp_path / "pages.pdf")]) / MILLIMETER
    assert len(pages) == written.sheets and pages == pytest.approx(np.array(sizes), abs=0.01)
    for page in pages:
        expected = [own if side is None else side for own, side in zip(page, sides, strict=True)]
        assert sorted(page) == pytest.approx(sorted(expected), abs=1e-3)


@pytest.mark.parametrize("keep_places", [False, True])
@pytest.mark.parametrize(("paper", "margin"), [("a4", 10.0), ("a3", 10.0), (2500.0, 0.0), ("projector", 0.0)])
def test_the_pages_show_the_reported_parts_of_the_pattern(tmp_path, paper, margin, keep_places):
    """Every point of a cutting line is on at least one page, and is dark on each page that shows it."""
    pattern = sample("Hat").with_only([])
    apart = np.array([[0.0, 0.0], [33.0, 21.0]])[np.arange(len(pattern.pieces)) % 2]
    pattern = replace(pattern, pieces=[piece.moved(by) for piece, by in zip(pattern.pieces, apart, strict=True)])
    laid, pages = pattern.pages(paper, keep_places)
    if keep_places:
        lows = [np.array([piece.bounds[0] for piece in each.pieces]) for each in (laid, pattern)]
        assert np.ptp(lows[0] - lows[1], axis=0) == pytest.approx(0)
    pattern.write(tmp_path / "pages.pdf", paper=paper, keep_places=keep_places)
    shown = list(pypdfium2.PdfDocument(tmp_path / "pages.pdf"))[-len(pages) :]
    points = np.concatenate([line.points for piece in laid.pieces for line in piece.of_role("cut", "inner_cut")])
    seen = np.zeros(len(points), dtype=bool)
    for page, sheet in zip(pages, shown, strict=True):
        pixels = np.atleast_3d(sheet.render(scale=2 / MILLIMETER, grayscale=True).to_numpy())[..., 0]
        inside = np.all((points > page.low + 1) & (points < page.low + page.size - 1), axis=1)
        x, y = (2 * (points[inside] - page.low + margin)).T.astype(int)
        rows = len(pixels) - 1 - y
        around = [pixels[rows + i, x + j] for i in (-1, 0, 1) for j in (-1, 0, 1)]
        assert np.min(around, axis=0).max() < 160
        assert inside.any()
        seen |= inside
    assert seen.all()
    assert len({page.name for page in pages}) == len(pages)


@cache
def whole_and_alone():
    """Return a pattern of 30 straps of 60 by 2 mm with names beside them, and a pattern of their cutting lines only."""
    points = [(x, 4.0 * strap + y) for strap in range(30) for x, y in ((0, 0), (60, 0), (60, 2), (0, 2))]
    straps = quads(points, np.arange(4 * 30).reshape(-1, 4).tolist()).pieces
    pieces = [flat_piece(strap, f"Strap {number}", 1000.0) for number, strap in enumerate(straps, start=1)]
    return Pattern.from_pieces(pieces, [], allowance=0), Pattern.of_cut_lines(pieces, allowance=0)


@pytest.mark.parametrize("keep_places", [False, True])
@pytest.mark.parametrize("paper", ["a4", "a3", "36in"])
def test_cutting_lines_alone_have_the_same_pages(paper, keep_places):
    assert all(piece.of_role("card leader") for piece in whole_and_alone()[0].pieces)
    drawn = [(each if keep_places else each.arranged()).pages(paper, keep_places) for each in whole_and_alone()]
    assert len({len(pages) for _, pages in drawn}) == 1
    frames = [[(*(page.low - laid.bounds[0]), *page.size) for page in pages] for laid, pages in drawn]
    assert np.array(frames[0]) == pytest.approx(np.array(frames[1]))


def test_a_layout_that_is_too_wide_for_the_roll_is_reported():
    pattern = Pattern.from_result(rectangle(600, 100))
    (piece,) = pattern.pieces
    pattern = replace(pattern, pieces=[piece, replace(piece.moved(np.array([1200.0, 0.0])), number=2)])
    with pytest.raises(wirewarp.FlattenError, match="The pieces as laid out are 1.32 m wide, but only"):
        pattern.pages("36in", keep_places=True)
    assert len(pattern.pages("36in")[1]) == 1


@pytest.mark.parametrize(("name", "once"), [("Fitted top", True), ("Hat", False), ("Wetsuit upper body", True)])
def test_sheets_show_every_piece_apart_from_others(name, once):
    laid, pages = sample(name, pairs=once, on_fold=once).pages("a4")
    printed = shapely.union_all([shapely.box(*page.low, *(page.low + page.size)) for page in pages])
    cut = [shapely.Polygon(line.points) for piece in laid.pieces for line in piece.of_role("cut")]
    assert all(printed.buffer(1e-3).contains(piece) for piece in cut)
    tree = shapely.STRtree(cut)
    for index, piece in enumerate(cut):
        assert tree.query(piece, predicate="dwithin", distance=9.9).tolist() == [index]


@pytest.mark.parametrize(("once", "most"), [(False, 20), (True, 11)])
def test_the_fitted_top_takes_few_sheets(tmp_path, once, most):
    """The counts include the map. If no piece were rotated, they would be 22 and 12."""
    assert sample("Fitted top", pairs=once, on_fold=once).write(tmp_path / "top.pdf").sheets <= most


@pytest.mark.parametrize("name", ["Fitted top", "Jeans"])
def test_the_card_of_each_piece_is_whole_on_one_sheet(tmp_path, name):
    pattern = sample(name)
    pattern.write(tmp_path / "a.pdf")
    whole = set()
    for page in list(pypdfium2.PdfDocument(tmp_path / "a.pdf"))[1:]:
        text = page.get_textpage()
        for piece in pattern.pieces:
            place = f"{piece.number} of {len(pattern.pieces)}"
            found = text.search(place, match_whole_word=True).get_next()
            if found:
                begin, end = (text.get_text_range().find(words, found[0]) for words in (place, "allowance"))
                boxes = np.array([text.get_charbox(at) for at in range(begin, end + len("allowance"))]) / MILLIMETER
                size = np.array(page.get_size()) / MILLIMETER
                if np.all(boxes[:, :2] > 10) and np.all(boxes[:, 2:] < size - 10):
                    whole.add(piece.number)
    assert whole == {piece.number for piece in pattern.pieces}


@pytest.mark.parametrize("paper", ["a4", "projector", "36in"])
def test_the_first_page_has_a_key_of_the_lines_that_are_drawn(tmp_path, paper):
    lampshade, path = sample("Lampshade", on_fold=True), tmp_path / "a.pdf"

    def words(pattern):
        pattern.write(path, paper=paper)
        return pypdfium2.PdfDocument(path)[0].get_textpage().get_text_range()

    labels = ["Cutting line", "Stitching line", "Fold of the fabric", "Rigid wire", "Grain", "Notch"]
    key = words(lampshade)
    assert all(label in key for label in labels) and "Elastic wire" not in key
    if paper == "projector":  # one paper is enough, because the key is the same on all papers
        assert "Stitching line" not in words(lampshade.with_only([]))


@pytest.mark.parametrize("units", ["metric", "imperial"])
def test_squares_bars_and_a_key_of_all_kinds_of_lines_are_inside_the_block(units):
    pattern = Pattern.from_result(rectangle(100, 100), allowance=10, units=units)
    (piece,) = pattern.pieces
    ends = np.array([[0.0, 0.0], [100.0, 0.0]])
    lines = [Line("fold", ends), *(Line("wire", ends, kind=kind) for kind in WIRES), *piece.lines]
    points = [Point(role, ends[0]) for role in ("notch", "clip", "drill")]
    corner = np.array([30.0, 40.0])
    marks = scale_marks(replace(pattern, pieces=[replace(piece, lines=lines, points=points)]), corner)
    block = shapely.box(*corner, *corner + SIZE)
    assert all(block.covers(line_string(stroke)) for stroke in marks.strokes)
    assert all(block.covers(letters(text)) for text in marks.texts)
    labels = {look.label for look in LOOKS.values() if look.label}
    named = [text for text in marks.texts if text.lines[0] in labels]
    assert len(labels) == len(named) == 10
    halves = np.array([[helvetica.width(text.lines[0].encode(), text.height) / 2, 0] for text in named])
    centers = np.array([text.center for text in named])
    words = shapely.linestrings(np.stack([centers - halves, centers + halves], axis=1))
    samples = [line_string(stroke) for stroke in marks.strokes if stroke.role != "scale"]
    assert all(one.distance(other) > 1 for one, other in combinations([*words, *samples], 2))


def test_sheets_name_only_neighbors_that_are_printed(tmp_path):
    pattern = sample("Jeans", pairs=True, on_fold=True)
    names = {page.name for page in pattern.pages("a4")[1]}
    pattern.with_only([]).write(tmp_path / "a.pdf")
    pages = list(pypdfium2.PdfDocument(tmp_path / "a.pdf"))[1:]
    named = {name for page in pages for name in re.findall("[A-Z]+[0-9]", page.get_textpage().get_text_range())}
    assert named == names and len(names) == len(pages)


@pytest.mark.parametrize("keep_places", [False, True])
@pytest.mark.parametrize("name", ["Toy", "Swimsuit"])
def test_the_names_of_sheets_and_their_neighbors_cross_no_line_and_no_text(name, keep_places):
    planned = plan(sample(name), "a4", keep_places)
    crossed = []
    for sheet in planned.sheets:
        pieces = [planned.pattern.pieces[index] for index in sheet.pieces]
        drawn = shapely.MultiLineString([line.path for piece in pieces for line in piece.lines])
        written = [letters(text) for piece in pieces for text in piece.texts if len(text.lines) == 1]
        (marks,) = sheet.marks(planned.pattern)
        names = [letters(text.placed(Motion(sheet.low - sheet.corner))) for text in marks.texts]
        assert names
        crossed += [sheet.name for own in names if own.intersects(drawn) or any(map(own.intersects, written))]
        crossed += [sheet.name for one, other in combinations(names, 2) if one.intersects(other)]
    assert crossed == []
