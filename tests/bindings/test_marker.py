# SPDX-License-Identifier: GPL-3.0-or-later
"""On a marker, all requested pieces are on the fabric, apart from each other and along the grain."""

import json
import math
import os
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import psutil
import pypdfium2
import pytest
import shapely
import wirewarp
from patterns import cut_polygon, grid, quads, rectangle, sample
from processes import wait_until_gone
from wirewarp.pattern import FORMATS, Marker, Pattern
from wirewarp.pattern.geometry import Motion
from wirewarp.pattern.make.outline import flat_piece
from wirewarp.pattern.nest.items import simplified


@pytest.fixture(params=["slides", "spyrrow"])
def engine(request, monkeypatch):
    """Run the test with each of the two nesting engines."""
    if request.param == "spyrrow":
        pytest.importorskip("spyrrow")
    else:
        monkeypatch.setattr("wirewarp.pattern.nest.nesting.is_installed", lambda: False)
    return request.param


def check_lies_on_cloth(pattern: Pattern, marker: Marker) -> None:
    cuts = [cut_polygon(piece) for piece in pattern.laid_on(marker).pieces]
    for index, cut in enumerate(cuts):
        assert all(cut.distance(other) > marker.gap - 1e-6 for other in cuts[:index])
        left, low, right, high = cut.bounds
        assert left > -0.02 and low > -0.02 and right < marker.width + 0.02
        assert high < (marker.sheets * 1e4 if marker.sheet_length else marker.length + 1e-6)


@pytest.mark.parametrize(("name", "grain"), [("Fitted top", "one way"), ("Jeans", "both ways"), ("Toy", "free")])
def test_pieces_lie_apart_on_the_cloth_along_the_grain(name, grain, engine):
    pattern = sample(name)
    width = max(float(piece.size[0]) for piece in pattern.pieces)
    marker = pattern.nested(width + (1 if grain == "free" else 0), gap=3.0, grain=grain, seconds=1)
    check_lies_on_cloth(pattern, marker)
    allowed = {"one way": {0}, "both ways": {0, 180}}.get(grain)
    assert allowed is None or {round(abs(placement.angle)) % 360 for placement in marker.placements} <= allowed
    area = sum(cut_polygon(piece).area for piece in pattern.pieces)
    assert marker.efficiency == pytest.approx(area / (marker.width * marker.length), rel=1e-6)


def test_squares_fill_the_cloth():
    # There are 4 x 3 squares of 100 mm, 10 mm apart. Each gap is 0.4 mm wider, because outlines are simplified.
    pattern = Pattern.from_result(rectangle(100, 100), allowance=0).with_quantities({1: (12, 0)})
    marker = pattern.nested(435, gap=10.0, seconds=0)
    assert marker.length == pytest.approx(3 * 100 + 2 * 10.4, abs=0.1)
    assert marker.efficiency == pytest.approx(12 * 100**2 / (435 * marker.length))


def test_every_copy_is_placed_including_mirrored_ones(engine):
    paired = sample("Fitted top", pairs=True).with_quantities({1: (2, 1)})
    marker = paired.nested(1400, times=2, seconds=1)
    counts = {(p, m): 0 for p in (1, 2, 3) for m in (False, True)}
    for placement in marker.placements:
        counts[placement.piece, placement.mirrored] += 1
    assert counts == {(1, False): 4, (1, True): 2, (2, False): 2, (2, True): 0, (3, False): 2, (3, True): 2}
    check_lies_on_cloth(paired, marker)


def test_texts_beside_a_small_piece_do_not_change_the_piece():
    marked = Pattern.from_result(rectangle(20, 2), folds=[(0, 3)], allowance=0, piece_names=["Cuff"])
    assert marked.pieces[0].of_role("card leader")
    marker = marked.nested(400, seconds=0)
    for pattern in (marked, marked.with_only(["sew"])):
        (piece,) = pattern.laid_on(marker).pieces
        assert sorted(piece.size) == pytest.approx([2, 40])
        # The texts are left out, because other pieces of the marker may be at their places.
        assert not piece.texts and not piece.of_role("card leader")


def test_texts_in_a_piece_stay_on_a_marker():
    pattern = sample("Fitted top")
    for piece in pattern.laid_on(pattern.nested(1400, seconds=0)).pieces:
        assert len(piece.texts) == len([text for text in pattern.pieces[piece.number - 1].texts if not text.is_beside])
        assert any(piece.name in text.lines for text in piece.texts)


def test_an_opened_piece_has_no_omitted_texts():
    sewn = grid([0, 100, 200], [0, 60], seams=[(1, 4)])
    named = Pattern.from_result(sewn, folds=[(0, 3)]).with_only(["sew", "line names"])
    laid = named.laid_on(named.nested(400, seconds=0))
    assert [{text.role for text in piece.texts} for piece in laid.pieces] == [{"line name"}] * 2
    left, right = sorted(text.center[0] for text in laid.pieces[0].texts)
    assert left > 10 and right < 210  # inside the stitching lines, on both sides of the fold


def test_the_grain_runs_along_the_cloth():
    pattern = sample("Fitted top")
    turned = [piece.placed(Motion(np.zeros(2), 30.0 * n)) for n, piece in enumerate(pattern.pieces)]
    crooked = replace(pattern, pieces=turned)
    laid = crooked.laid_on(crooked.nested(1400, grain="both ways", seconds=0))
    for piece in laid.pieces:
        (line,) = piece.of_role("grain")
        assert abs(line.points[0, 0] - line.points[1, 0]) < 1e-6


def test_sheets_are_filled_one_after_the_other(tmp_path):
    pattern = Pattern.from_result(rectangle(100, 100), allowance=0).with_quantities({1: (10, 0)})
    marker = pattern.nested(210, 210, gap=5.0, seconds=0)
    assert [placement.sheet for placement in marker.placements] == [0] * 4 + [1] * 4 + [2] * 2
    assert marker.efficiency == pytest.approx(10 * 100**2 / (3 * 210**2))
    check_lies_on_cloth(pattern, marker)
    laid = pattern.laid_on(marker)
    assert laid.write(tmp_path / "sheets.pdf").sheets == len(laid.page_sizes()) == 3
    assert marker.sentence(pattern.units) == "10 pieces on 3 sheets of 210 mm x 210 mm, 76% of it used"


def test_a_marker_is_stored_as_json_and_refuses_other_pieces():
    pattern = sample("Hat")
    marker = pattern.nested(1400, seconds=0)
    again = Marker.from_dict(json.loads(json.dumps(marker.to_dict())))
    assert again == marker
    with pytest.raises(wirewarp.FlattenError, match="have changed since the marker was made"):
        sample("Hat", allowance=12.0).laid_on(again)
    with pytest.raises(wirewarp.FlattenError, match="already laid out on a marker"):
        pattern.laid_on(again).laid_on(again)


def dented(x, y):
    """Return a rectangle of 100 x 60 mm whose upper side is bent at the point x, y."""
    points = [(0, 0), (50, 0), (100, 0), (100, 60), (x, y), (0, 60)]
    (piece,) = quads(points, [(0, 1, 4, 5), (1, 2, 3, 4)]).pieces
    flat = flat_piece(piece, "Yoke", 1000.0)
    return replace(flat, vertices=np.array(points, dtype=float)[flat.source_vertex])


@pytest.mark.parametrize("other", [(50, 45), (60, 40)])
def test_a_marker_refuses_pieces_of_the_same_size_with_another_outline(other):
    pattern, changed = (Pattern.from_pieces([dented(*point)], [], allowance=0) for point in ((50, 40), other))
    assert changed.pieces[0].size == pytest.approx(pattern.pieces[0].size)
    with pytest.raises(wirewarp.FlattenError, match="have changed since the marker was made"):
        changed.laid_on(pattern.nested(400, seconds=0))


def test_a_marker_does_not_depend_on_the_place_of_the_pieces():
    pattern = sample("Toy")
    marker = pattern.nested(1000, grain="free", seconds=0)
    moved = replace(
        pattern, pieces=[piece.moved(np.array([100.0 * n, -70.0 * n])) for n, piece in enumerate(pattern.pieces)]
    )
    check_lies_on_cloth(moved, marker)
    for own, other in zip(moved.laid_on(marker).pieces, pattern.laid_on(marker).pieces, strict=True):
        assert own.of_role("cut")[0].points == pytest.approx(other.of_role("cut")[0].points)


def test_better_markers_are_shown_and_a_stop_keeps_the_best(engine):
    shown, asked = [], []
    pattern = sample("Toy")

    def progress(stage, fraction):
        asked.append(fraction < 0.02 or not shown)  # false after 2% of the time, if a marker exists by then
        return asked[-1]

    marker = pattern.nested(1000, seconds=100, preview=shown.append, progress=progress)
    assert marker.placements == shown[-1].placements
    lengths = [each.length for each in shown]
    assert lengths == sorted(lengths, reverse=True) and len(set(lengths)) == len(lengths)
    assert asked.index(False) == len(asked) - 1  # the search stopped when progress first returned False


def test_errors_of_spyrrow_are_reported_and_pieces_are_packed_without_it(monkeypatch):
    pytest.importorskip("spyrrow")
    bow_tie = [[0.0, 0.0], [50.0, 50.0], [50.0, 0.0], [0.0, 50.0]]
    described, searched = wirewarp.pattern.nest.spyrrow_nesting._described, wirewarp.pattern.nest.nesting.searched

    def searched_to_the_end(*what):
        """Search for 60 s instead of 3 s, because the process may start slowly."""
        yield from list(searched(*what[:-1], 60.0))

    monkeypatch.setattr("wirewarp.pattern.nest.nesting.searched", searched_to_the_end)
    monkeypatch.setattr(
        "wirewarp.pattern.nest.spyrrow_nesting._described",
        lambda item, grain: described(item, grain) | {"outline": bow_tie},
    )
    marker = sample("Hat").nested(1400, seconds=3)
    assert marker.by == "slides"
    (warning,) = marker.warnings
    assert warning.startswith("spyrrow failed, so pieces were packed without it: ")
    assert sample("Hat").laid_on(marker).warnings[-1] == warning


@pytest.fixture
def searches(monkeypatch):
    """Return a list to which each new process of a search is added."""
    pytest.importorskip("spyrrow")
    started = []

    class Noted(subprocess.Popen):
        def __init__(self, *what, **how):
            super().__init__(*what, **how)
            started.append(self)

    monkeypatch.setattr("wirewarp.pattern.nest.spyrrow_nesting.subprocess.Popen", Noted)
    return started


def test_the_search_process_ends_if_progress_raises(searches):
    def progress(*_):
        if searches:
            raise ZeroDivisionError

    # `raised` keeps the frames of the search alive, so garbage collection cannot end the process.
    with pytest.raises(ZeroDivisionError) as raised:
        sample("Hat").nested(1400, seconds=600, progress=progress)
    (search,) = searches
    assert search.returncode is not None and not Path(search.args[-1]).parent.exists(), raised


def test_a_search_ends_if_its_parent_is_killed(tmp_path):
    pytest.importorskip("spyrrow")
    code = "from patterns import sample; sample('Hat').nested(1400, times=4, seconds=3600)"
    temporary = dict.fromkeys(("TMPDIR", "TEMP", "TMP"), str(tmp_path))
    caller = subprocess.Popen([sys.executable, "-c", code], cwd=Path(__file__).parent, env=os.environ | temporary)
    while not any(found.stat().st_size for found in tmp_path.glob("*/found")):
        assert caller.poll() is None
        time.sleep(0.01)
    (search,) = (
        process.pid
        for process in psutil.Process(caller.pid).children(recursive=True)
        if any(word.endswith("spyrrow_process.py") for word in process.cmdline())
    )
    caller.kill()
    caller.wait()
    wait_until_gone(search)
    assert os.name != "posix" or not list(tmp_path.iterdir())  # Windows cannot delete open files


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"width": 0}, "width is 0"),
        ({"width": math.nan}, "width is nan"),
        ({"width": "wide"}, "width is 'wide'"),
        ({"width": 1e9}, "width is 1e"),
        ({"width": 600, "length": -5}, "length is -5"),
        ({"width": 600, "gap": -1}, "gap is -1"),
        ({"width": 600, "gap": math.inf}, "gap is inf"),
        ({"width": 600, "grain": "sideways"}, "grain is 'sideways'"),
        ({"width": 600, "times": 0}, "times is 0"),
        ({"width": 600, "times": 1.5}, "times is 1.5"),
        ({"width": 600, "times": 10**9}, "at most 10000 pieces"),
        ({"width": 600, "seconds": math.nan}, "seconds is nan"),
        ({"width": 600, "seconds": "long"}, "seconds is 'long'"),
        ({"width": "200"}, "too large for a roll of 200 mm"),
        ({"width": 200}, '"Piece 1" is 220.0 mm x 320.0 mm: too large for a roll of 200 mm, with its grain lengthwise'),
        ({"width": 600, "length": 300}, "too large for sheets of 600 mm x 300 mm"),
    ],
)
def test_bad_input_gives_one_sentence(options, words):
    pattern = Pattern.from_result(rectangle(300, 200))  # its long sides are upright, so it is 220 mm wide
    with pytest.raises(wirewarp.FlattenError, match=words) as raised:
        pattern.nested(**options)
    assert str(raised.value).count(". ") == 0


def test_imperial_units_are_reported_in_inches(tmp_path):
    pattern = Pattern.from_result(rectangle(254, 254), allowance=0, units="imperial")
    for use in (pattern.nested, lambda width: pattern.write(tmp_path / "x.pdf", paper=width)):
        with pytest.raises(wirewarp.FlattenError, match=r"is 10.00 in x 10.00 in: too large for a roll of 9 in"):
            use(9 * 25.4)
    marker = pattern.nested(12 * 25.4, seconds=0)
    assert marker.sentence(pattern.units) == "1 piece on 10 in of fabric 12 in wide, 83% of it used"


def test_a_piece_of_two_folds_cannot_be_opened():
    two = Pattern.from_result(rectangle(100, 60), folds=[(0, 3), (1, 2)])
    with pytest.raises(wirewarp.FlattenError, match="has 2 folds"):
        two.nested(400, seconds=0)


@pytest.mark.parametrize("quantities", [{2: (1, 0)}, {1: (0, 0)}, {1: (1, -1)}, {1: (1.5, 0)}, {1: (1, 2, 3)}])
def test_impossible_quantities_give_one_sentence(quantities):
    with pytest.raises(wirewarp.FlattenError, match=r"Piece 2 does not exist|The quantity of piece 1"):
        Pattern.from_result(rectangle(100, 100)).with_quantities(quantities)


@pytest.mark.parametrize("ending", [suffix[1:] for suffix in FORMATS])
def test_every_format_has_every_copy(tmp_path, ending):
    pattern = sample("Fitted top")
    laid = pattern.laid_on(pattern.nested(1400, times=2, seconds=0))
    written = laid.write(tmp_path / f"marker.{ending}")
    assert str(written) == f"8 pieces on 1 sheet, read again: {written.off:.2f} mm off"


def test_plotters_have_x_along_the_cloth(tmp_path):
    pattern = Pattern.from_result(rectangle(100, 100), allowance=0).with_quantities({1: (3, 0)})
    pattern.laid_on(pattern.nested(100, gap=0, seconds=0)).write(tmp_path / "marker.plt")
    commands = (tmp_path / "marker.plt").read_text().replace("\n", "").split(";")
    numbers = [number for c in commands if c.startswith(("PU", "PD")) and "," in c for number in c[2:].split(",")]
    places = np.array(numbers, dtype=float).reshape(-1, 2) / 40
    assert places.min(axis=0) == pytest.approx([0, 0], abs=0.05)
    assert places.max(axis=0) == pytest.approx([301, 100], abs=1)


def test_a_long_marker_has_several_pages_that_overlap(tmp_path):
    pattern = Pattern.from_result(rectangle(900, 900), allowance=0).with_quantities({1: (10, 0)})
    laid = pattern.laid_on(pattern.nested(900, gap=10.0, seconds=0))
    length = laid.marker.length
    sizes = laid.page_sizes()
    laid.write(tmp_path / "long.pdf")
    pages = [page.get_size() for page in pypdfium2.PdfDocument(tmp_path / "long.pdf")]
    assert np.array(pages) * 25.4 / 72 == pytest.approx(np.array(sizes), abs=0.01)
    assert len(sizes) == 2 and max(size.max() for size in sizes) <= 5000
    # Both pages have margins of 10 mm, the first page has 158 mm for the test square, and the pages overlap by 10 mm.
    assert sum(size[1] for size in sizes) == pytest.approx(length + 2 * 20 + 158 + 10)
    with pytest.raises(wirewarp.FlattenError, match=r"needs a roll of 920 mm, not 910 mm"):
        laid.page_sizes(910.0)
    assert len(laid.page_sizes(950.0)) == 2 and laid.page_sizes(950.0)[0][0] == 950


def test_a_marker_on_sheets_of_paper_stays_as_it_is(tmp_path):
    pattern = sample("Hat")
    laid = pattern.laid_on(pattern.nested(1000, seconds=0))
    written = laid.write(tmp_path / "marker.pdf", paper="a3")
    assert written.sheets == len(laid.page_sizes("a3")) > 3


def test_simplified_outlines_keep_the_requested_distance():
    turn = np.linspace(0, 2 * math.pi, 400, endpoint=False)
    circle = 100 * np.column_stack([np.cos(turn), np.sin(turn)])
    found = simplified(circle, 0.2, [0, 100, 200, 300])
    assert len(found) < 70
    assert shapely.Polygon(found).exterior.hausdorff_distance(shapely.LinearRing(circle)) <= 0.2
