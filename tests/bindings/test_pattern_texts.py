# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts and grain arrows on pieces are readable, apart from each other, and inside of or close to their pieces."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
import shapely
import wirewarp
from patterns import cut_polygon, flattened, grid, letters, line_string, quads, rectangle, sample, sew_polygon, turn
from wirewarp.pattern import FlatPiece, Pattern, Text
from wirewarp.pattern.label.grain_beside import grain_beside
from wirewarp.pattern.label.leaders import FARTHEST, Beside
from wirewarp.pattern.label.text_place import LINE
from wirewarp.pattern.make.outline import flat_piece
from wirewarp.pattern.model import Line, short_name

READABLE = 2.5  # millimeters


def texts(pattern):
    return [text for piece in pattern.pieces for text in piece.texts]


@pytest.mark.parametrize("size", [200.0, 60.0, 30.0, 15.0, 8.0, 3.0])
def test_no_text_is_too_small_to_be_read(size):
    pattern = Pattern.from_result(rectangle(2 * size, size), title="A style", allowance=0, piece_names=["Front left"])
    assert all(text.height >= READABLE for text in texts(pattern))


def test_a_small_piece_has_its_name_alone():
    def card(width, height):
        (piece,) = Pattern.from_result(rectangle(width, height), allowance=0, piece_names=["Cuff"]).pieces
        return [text.lines for text in piece.texts if text.role == "card"]

    assert "Cut 1" in card(200, 100)[0]
    assert card(20, 10) == [("Cuff",)]


def test_a_piece_names_no_allowance_that_it_does_not_have():
    points = [(0, 0), (200, 0), (200, 150), (0, 150), (300, 0), (500, 0), (500, 150), (300, 150)]
    result = quads(points, [(0, 1, 2, 3), (4, 5, 6, 7)])
    pattern = Pattern.from_result(result, allowance=10.0, allowances=[(0, 1, 30.0)])
    lines = ["Includes 10 mm to 30 mm allowance", "Includes 10 mm allowance"]
    assert all(line in piece.texts[0].lines for line, piece in zip(lines, pattern.pieces, strict=True))
    assert pattern.allowance_text == "10 mm to 30 mm"


def test_texts_without_room_are_beside_the_piece_with_a_leader_line():
    pattern = Pattern.from_result(rectangle(20, 2), allowance=0, piece_names=["Cuff"])
    (piece,) = pattern.pieces
    (name,) = (text for text in piece.texts if text.role == "card")
    (leader,) = piece.of_role("card leader")
    (cut,) = piece.of_role("cut")
    low, high = cut.points.min(axis=0), cut.points.max(axis=0)
    assert name.lines == ("Cuff",) and name.height == READABLE
    assert letters(name).disjoint(shapely.Polygon(cut.points))
    assert np.all(leader.points[0] > low) and np.all(leader.points[0] < high)
    # The second part of the leader runs along the letters, between the letters and the piece.
    assert np.ptp(leader.points[1:, 1]) == pytest.approx(0)
    assert max(low[1] - leader.points[1, 1], leader.points[1, 1] - high[1]) > 0.4
    assert piece.bounds == (pytest.approx(low), pytest.approx(high))
    assert pattern.with_only(["texts"]).pieces[0].of_role("card leader")


def strap(angle):
    """Return a piece of 60 by 2 mm, rotated by an angle in degrees. Its name has no room inside."""
    piece = flat_piece(rectangle(60, 2).pieces[0], "A strap to tie", 1000.0)
    return replace(piece, vertices=piece.vertices @ turn(angle), grain=piece.grain @ turn(angle))


@pytest.mark.parametrize("angle", [0, 30, 90])
def test_texts_beside_pieces_in_rows_keep_apart(angle):
    rows = Pattern.from_pieces([strap(angle)] * 4, [], allowance=0).arranged()
    texts_of = [[letters(text) for text in piece.texts] for piece in rows.pieces]
    assert all(texts_of)
    for (piece, own), (other, others) in combinations(zip(rows.pieces, texts_of, strict=True), 2):
        boxes = [shapely.box(*np.concatenate(each.bounds)) for each in (piece, other)]
        assert boxes[0].distance(boxes[1]) > 9.9  # rows are 10 mm apart
        assert all(text.disjoint(boxes[1]) for text in own) and all(text.disjoint(boxes[0]) for text in others)
        assert all(a.disjoint(b) for a in own for b in others)


@pytest.mark.parametrize("angle", [20, 45, 135])
def test_texts_beside_a_piece_are_nearer_than_sheets_overlap(angle):
    """A sheet that shows a part of the piece also shows its texts, because sheets overlap by 10 mm."""
    (piece,) = Pattern.from_pieces([strap(angle)], [], allowance=0).pieces
    (text,) = piece.texts
    leaders = [line_string(leader) for leader in piece.of_role("card leader")]
    assert all(letters(text).disjoint(leader) for leader in leaders)
    around = cut_polygon(piece).buffer(10)
    assert all(around.contains(each) for each in (letters(text), *leaders))


def test_no_line_to_a_name_crosses_a_large_piece():
    square = 1000.0 * np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]])
    near, far = (Text(("Wire 1",), np.array([500.0, height]), READABLE) for height in (FARTHEST / 2, 500.0))
    text, leader = Beside([square]).lead([near], np.array([0.0, -1.0]))
    assert text.center[1] < 0 and np.linalg.norm(leader.points[1] - near.center) < FARTHEST
    assert Beside([square]).lead([far], np.array([0.0, -1.0])) is None


def test_names_beside_a_piece_are_clear_of_each_other():
    result = grid(range(0, 10, 2), [0, 6], seams=[(column, column + 5) for column in range(1, 4)])
    pattern = Pattern.from_result(result, allowance=0, piece_names=["A", "B", "C", "D"])
    for piece, seams in zip(pattern.pieces, (1, 2, 2, 1), strict=True):
        named = sorted(line.name for line in piece.of_role("sew") if line.name)
        assert len(named) == seams
        written = sorted(text.lines[0] for text in piece.texts if text.role == "line name")
        # Names are written as "Seam 1", or only as "1".
        assert all(name in (whole, whole[-1]) for name, whole in zip(written, named, strict=True))
        for first, second in combinations(map(letters, piece.texts), 2):
            assert first.disjoint(second)


def test_a_dart_is_not_taken_for_the_seam_of_the_same_number():
    short = {"Seam 3": "3", "Seam 3 / 5": "3 / 5", "Dart 3": "Dart 3", "Waist 3": "Waist 3"}
    assert {name: short_name(name) for name in short} == short


def test_a_seam_names_the_other_piece_if_there_is_room():
    names = ["Front", "Back", "Left sleeve", "Right sleeve"]
    pattern = Pattern.from_result(flattened("Fitted top"), piece_names=names)
    lines = [line for piece in pattern.pieces for line in piece.of_role("sew") if line.seam is not None]
    assert {line.joins for line in lines if line.joins} == set(names)
    written = {line for text in texts(pattern) if text.role == "line name" for line in text.lines}
    assert any(line.startswith("Seam ") and line.endswith((": Front", ": Back")) for line in written)


def test_the_legs_of_a_dart_join_no_other_piece():
    lines = [line for piece in sample("Hat").pieces for line in piece.of_role("sew")]
    assert [line for line in lines if line.seam is not None and not line.joins]


def grain(piece: FlatPiece) -> np.ndarray:
    (laid,) = Pattern.from_pieces([piece], []).pieces
    (line,) = laid.of_role("grain")
    way = line.points[1] - line.points[0]
    return way / np.linalg.norm(way)


def test_the_grain_follows_its_setting_and_is_upright_by_default():
    piece = flat_piece(rectangle(200, 100).pieces[0], "Front", 1000.0)
    assert grain(piece) == pytest.approx([0, 1])
    assert grain(replace(piece, grain=np.array([0.6, -0.8]))) == pytest.approx([0.6, -0.8])


def card_and_arrow(piece):
    """Return the area of the card's lines, and the area of the grain arrow, which is as wide as its heads."""
    (card,) = (text for text in piece.texts if text.role == "card")
    (arrow,) = piece.of_role("grain")
    step = LINE * card.height * np.array([0.0, -1.0]) @ turn(card.angle)  # from a line of the card to the next
    first = card.center - (len(card.lines) - 1) / 2 * step
    parts = [replace(card, lines=(line,), center=first + row * step) for row, line in enumerate(card.lines)]
    return shapely.union_all([letters(part) for part in parts]), line_string(arrow).buffer(2.5)


@pytest.mark.parametrize(("width", "height"), [(90, 60), (80, 70), (45, 120)])
@pytest.mark.parametrize("angle", [0, 30, 90])
def test_the_grain_arrow_and_the_card_of_a_piece_keep_apart(width, height, angle):
    """A wire crosses the piece. If the arrow were in the middle, the card of texts would have no room beside it."""
    result = grid([0, width], [0, height / 2, height], wires=[wirewarp.Wire([2, 3], name="Waist")])
    sheet = flat_piece(result.pieces[0], "Left sleeve", 1000.0)
    (piece,) = Pattern.from_pieces([replace(sheet, grain=np.array([0.0, 1.0]) @ turn(angle))], [], title="Top").pieces
    card, arrow = card_and_arrow(piece)
    assert "Cut 1" in piece.texts[0].lines
    assert card.disjoint(arrow)
    grain_line = line_string(piece.of_role("grain")[0])
    assert grain_line.length > 10 and sew_polygon(piece).contains(grain_line)


def test_a_grain_arrow_that_crosses_a_text_is_not_moved_into_the_allowance():
    """The stitching line is a square of 40 mm, which the text fills. The allowance around the square is 30 mm wide."""
    square = np.array([(0.0, 0.0), (100, 0), (100, 100), (0, 100)])
    stitching = 30 + 0.4 * np.concatenate([square, square[:1]])
    text, arrow = Text(("M" * 7,) * 4, np.array([50.0, 50.0]), 6.0), Line("grain", np.array([(50.0, 35.0), (50, 65)]))
    assert grain_beside(text, arrow, [square], [], [stitching], 30.0) is arrow
    moved = grain_beside(text, arrow, [square], [], [stitching], 0.0)
    assert np.abs(moved.points.mean(axis=0) - 50).max() > 20


def test_the_grain_arrows_and_the_cards_of_a_toy_keep_apart():
    pieces = sample("Toy", pairs=True).pieces
    assert [piece.name for piece in pieces if card_and_arrow(piece)[0].intersects(card_and_arrow(piece)[1])] == []


def strips(*widths):
    """Flatten strips of 200 mm with these widths, sewn together side by side, with a wire across all strips."""
    xs = np.concatenate([[0], np.cumsum(widths)]).tolist()
    row = len(xs)
    seams = [(y * row + k, (y + 1) * row + k) for y in range(4) for k in range(1, row - 1)]
    return grid(xs, range(0, 250, 50), seams=seams, wires=[wirewarp.Wire(range(row, 2 * row), name="Waist")])


def test_names_are_inside_narrow_pieces_or_close_to_them_and_apart():
    widths = (4, 8, 10, 14, 24, 40, 50)
    pattern = Pattern.from_result(strips(*widths), allowance=0)
    for piece, width in zip(pattern.pieces, widths, strict=True):
        around = shapely.box(*np.concatenate(piece.bounds)).buffer(5.0 + 1e-6, join_style="mitre")
        assert all(around.contains(letters(text)) for text in piece.texts)
        for first, second in combinations(map(letters, piece.texts), 2):
            assert first.disjoint(second)
        seams = [text for text in piece.texts if text.role == "line name" and "Waist" not in text.lines[0]]
        assert len(seams) == (1 if width in (widths[0], widths[-1]) else 2)


def test_a_wire_shorter_than_its_name_is_not_named_and_others_are_named_inside():
    for name, count in (("Waist", 1), ("Waist, as measured on the fitting day, " * 5, 0)):
        result = grid([0, 200], [0, 100, 200], wires=[wirewarp.Wire([2, 3], name=name)])
        (piece,) = Pattern.from_result(result, allowance=0).pieces
        names = [text for text in piece.texts if text.role == "line name"]
        assert [text.lines for text in names] == [(name,)] * count
        (wire,) = piece.of_role("wire")
        for text in names:
            assert line_string(wire).distance(shapely.Point(text.center)) == pytest.approx(3.0, abs=0.1)
            assert cut_polygon(piece).contains(letters(text))


def test_the_number_of_a_seam_avoids_the_end_of_a_wire():
    """Without the wire, the number would be in the middle of the seam."""
    wire = wirewarp.Wire([3, 4, 5], name="Waist")
    result = grid([-150, 0, 150], [0, 100, 200], seams=[(1, 4), (4, 7)], wires=[wire])
    for piece in Pattern.from_result(result, allowance=0).pieces:
        (wire,) = piece.of_role("wire")
        (number,) = [text for text in piece.texts if text.lines[0].startswith("Seam 1")]
        assert np.linalg.norm(wire.points[[0, -1]] - number.center, axis=1).min() > 15
