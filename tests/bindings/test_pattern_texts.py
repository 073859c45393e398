# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands on the pieces can be read, says what is sewn to what, and shows which way the grain runs."""

from dataclasses import replace

import numpy as np
import pytest
from patterns import flattened, rectangle, sample
from wirewarp.pattern import FlatPiece, Pattern
from wirewarp.pattern.flat_piece import flat_piece

READABLE = 2.5  # millimeters


def texts(pattern):
    return [text for piece in pattern.pieces for text in piece.texts]


@pytest.mark.parametrize("size", [200.0, 60.0, 30.0, 15.0, 8.0, 3.0])
def test_no_text_is_too_small_to_be_read(size):
    pattern = Pattern.from_result(rectangle(2 * size, size), title="A style", allowance=0, piece_names=["Front left"])
    assert all(text.height >= READABLE for text in texts(pattern))


def test_a_small_piece_has_its_name_alone_and_the_smallest_no_text():
    def card(width, height):
        (piece,) = Pattern.from_result(rectangle(width, height), allowance=0, piece_names=["Cuff"]).pieces
        return [text.lines for text in piece.texts if text.role == "card"]

    assert "Cut 1" in card(200, 100)[0]
    assert card(20, 10) == [("Cuff",)]
    assert card(4, 2) == []


def test_a_seam_says_what_it_is_sewn_to_where_there_is_room():
    names = ["Front", "Back", "Left sleeve", "Right sleeve"]
    pattern = Pattern.from_result(flattened("Fitted top"), piece_names=names)
    lines = [line for piece in pattern.pieces for line in piece.of_role("sew") if line.seam is not None]
    assert {line.joins for line in lines if line.joins} == set(names)
    written = {line for text in texts(pattern) if text.role == "line name" for line in text.lines}
    assert any(line.startswith("Seam ") and line.endswith((": Front", ": Back")) for line in written)


def test_the_legs_of_a_dart_join_no_other_piece():
    hat = sample("Hat")
    darts = [line for piece in hat.pieces for line in piece.of_role("sew") if line.seam is not None and not line.joins]
    assert darts


def grain(piece: FlatPiece) -> np.ndarray:
    (laid,) = Pattern.from_pieces([piece], []).pieces
    (line,) = laid.of_role("grain")
    way = line.points[1] - line.points[0]
    return way / np.linalg.norm(way)


def test_the_grain_runs_as_it_is_told_and_upright_by_itself():
    piece = flat_piece(rectangle(200, 100).pieces[0], "Front", 1000.0)
    assert grain(piece) == pytest.approx([0, 1])
    assert grain(replace(piece, grain=np.array([0.6, -0.8]))) == pytest.approx([0.6, -0.8])


def test_every_piece_has_a_grain_line():
    pattern = sample("Fitted top")
    assert [len(piece.of_role("grain")) for piece in pattern.pieces] == [1] * len(flattened("Fitted top").pieces)
