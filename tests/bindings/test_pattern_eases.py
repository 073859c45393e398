# SPDX-License-Identifier: GPL-3.0-or-later
"""If one side of a seam is longer, its notches still match, and the pattern says how to sew it."""

from pathlib import Path

import numpy as np
import pytest
import shapely
import wirewarp
from drawing import Drawing
from patterns import quads
from wirewarp.pattern import Pattern

COUNT, LENGTH = 20, 400.0  # number of edges, and length of the whole seam in millimeters
SEAM = [(x, x + 1) for x in range(COUNT)]


def two_strips(eased, **options) -> wirewarp.FlattenResult:
    """Flatten two strips of 150 mm, below and above a seam of edges of 20 mm.

    eased: (start, end, ratio) for each ease of the lower strip. The ease is on its edges range(start, end).
    """
    row = COUNT + 1
    points = [(x * LENGTH / COUNT, y) for y in (0, 150, -150) for x in range(row)]
    above = [(x, x + 1, row + x + 1, row + x) for x in range(COUNT)]
    below = [(2 * row + x, 2 * row + x + 1, x + 1, x) for x in range(COUNT)]
    eases = [wirewarp.Ease([(x + 1, x) for x in range(begin, end)], ratio) for begin, end, ratio in eased]
    return quads(points, above + below, seams=SEAM, eases=eases, **options)


def notches_in_file(path: Path, name: str) -> list[float]:
    """Return the distances in mm of a piece's notches from an end of its seam.

    This end is farther from its nearest notch than the other end.
    """
    drawing = Drawing(path)
    (seam,) = [line for line in drawing.lines(name, "Sew") if len(line) == COUNT + 1]
    line = shapely.LineString(seam)
    found = []
    for start, end in drawing.lines(name, "Notches"):
        ray = shapely.LineString([start, start + 20 * (end - start) / np.linalg.norm(end - start)])
        if ray.intersects(line):
            found.append(line.project(shapely.Point(ray.intersection(line).coords[0])))
    return sorted(found) if min(found) > line.length - max(found) else sorted(line.length - place for place in found)


@pytest.mark.parametrize("eased", [[(0, COUNT, 0.04)], [(5, 15, 0.08)], [(0, 10, 0.3), (12, 18, 0.05)]])
def test_notches_of_an_eased_seam_are_at_equal_sewn_lengths(tmp_path, eased):
    result = two_strips(eased)
    pattern = Pattern.from_result(result, piece_names=["Above", "Below"], notch_spacing=50.0)
    pattern.write(tmp_path / "a.svg")
    above, below = (notches_in_file(tmp_path / "a.svg", name) for name in ("Above", "Below"))
    ratios = np.ones(COUNT)
    for begin, end, ratio in eased:
        ratios[begin:end] += ratio
    step = LENGTH / COUNT
    ends_below = np.concatenate([[0.0], np.cumsum(step * ratios)])
    assert above == pytest.approx(np.arange(40, LENGTH, 50), abs=0.02) and len(below) == len(above)
    sewn = np.interp(below, ends_below, np.arange(COUNT + 1) * step)  # places on the seam without its eases
    assert sewn == pytest.approx(above, abs=0.02)
    (walk,) = pattern.walks
    assert np.interp(walk.notches[1], ends_below, np.arange(COUNT + 1) * step) == pytest.approx(walk.notches[0])


def test_the_text_of_the_longer_side_is_at_its_line():
    pattern = Pattern.from_result(two_strips([(0, COUNT, 0.03)]), piece_names=["Above", "Below"])
    names = [text for piece in pattern.pieces for text in piece.texts if text.role == "line name"]
    texts = [line for text in names for line in text.lines]
    assert "Seam 1: Above, 12 mm longer, ease between notches" in texts and "Seam 1: Below" in texts


@pytest.mark.parametrize(
    ("ratio", "expected"),
    [(0.03, "12 mm longer, ease between notches"), (0.5, "200 mm longer, gather between notches"), (0.0, "")],
)
def test_longer_sides_are_eased_or_gathered_and_equal_sides_have_no_text(ratio, expected):
    eased = [(0, COUNT, ratio)] if ratio else []
    pieces = Pattern.from_result(two_strips(eased), piece_names=["Above", "Below"]).pieces
    assert [line.note for piece in pieces for line in piece.of_role("sew") if line.seam is not None] == ["", expected]


def test_a_seam_that_is_eased_alike_on_both_sides_has_equal_notches():
    wires = [wirewarp.Wire([*range(COUNT + 1)], ease=-0.1)]
    pattern = Pattern.from_result(two_strips([], wires=wires), notch_spacing=50.0)
    (walk,) = pattern.walks
    assert walk.lengths == pytest.approx((0.9 * LENGTH, 0.9 * LENGTH))
    assert walk.notches[0] == pytest.approx(walk.notches[1]) and len(walk.notches[0]) > 4
