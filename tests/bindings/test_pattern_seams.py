# SPDX-License-Identifier: GPL-3.0-or-later
"""On the samples, a seam that is sewn first is pressed open, and both its allowances end on the crossing seam."""

import collections
import itertools

import numpy as np
import pytest
import shapely
from patterns import cut_polygon, flattened, sample, sew_polygon
from shapely.ops import substring
from wirewarp.pattern import PatternPiece

NEAR = 15.0  # millimeters of each seam that are checked
STRAIGHT = 8.0  # degrees: largest turn of the crossing line at a seam
OTHERS = 10.0  # degrees; at other seams of the same place, the line must turn by this much more


def seam_ends(name: str) -> dict:
    """Return, for each vertex and seam, its sides: piece, points of the stitching line from the vertex, and angle."""
    found = collections.defaultdict(list)
    for piece, flat in zip(sample(name).pieces, flattened(name).pieces, strict=True):
        boundary = np.isin(flat.source_vertex, np.concatenate([each.vertices for each in flat.boundaries]))
        sew = np.concatenate([line.points for line in piece.of_role("sew")])
        places = 1000 * flat.vertices + sew.min(axis=0) - 1000 * flat.vertices[boundary].min(axis=0)
        for line in piece.of_role("sew"):
            for points in (line.points, line.points[::-1]) if line.seam is not None and not line.closed else ():
                row = int(np.linalg.norm(places - points[0], axis=1).argmin())
                assert np.linalg.norm(places[row] - points[0]) < 1e-6
                angle = angle_inside(sew_polygon(piece), points[0])
                found[int(flat.source_vertex[row]), line.seam].append((piece, points, angle))
    return found


def angle_inside(outline: shapely.Polygon, place: np.ndarray) -> float:
    """Return the angle in degrees, from the share of a small circle that is inside the piece."""
    circle = shapely.Point(place).buffer(0.5, quad_segs=64)
    return 360 * circle.intersection(outline).area / circle.area


def lines_from(piece: PatternPiece, place: np.ndarray) -> list:
    """Return the seams that end at the vertex (None for an outline), with their points from the vertex on."""
    lines = [line for line in piece.of_role("sew") if not line.closed]
    ways = [(line.seam, points) for line in lines for points in (line.points, line.points[::-1])]
    return [(seam, points) for seam, points in ways if np.allclose(points[0], place, rtol=0, atol=1e-9)]


def is_straight(points: np.ndarray) -> bool:
    line = shapely.LineString(points)
    part = substring(line, 0, 2 * NEAR)
    chord = shapely.LineString([part.coords[0], part.coords[-1]])
    return line.length > 2 * NEAR and part.hausdorff_distance(chord) < 0.5


def off_when_pressed(piece: PatternPiece, points: np.ndarray) -> tuple[float, float]:
    """Return, in square millimeters, the part of the allowance that sticks out when it is folded back, and the missing
    part.
    """
    cut, end = cut_polygon(piece), points[0]
    other = np.array(shapely.LineString(points).interpolate(NEAR).coords[0])
    along = (end - other) / NEAR
    outward = np.array([along[1], -along[0]])
    if sew_polygon(piece).contains(shapely.Point((end + other) / 2 + 0.5 * outward)):
        outward = -outward

    def beside(reach: float) -> shapely.Polygon:
        far = end + 99 * along
        strip = shapely.Polygon([other, far, far + reach * outward, other + reach * outward])
        found = cut.intersection(strip).intersection(shapely.Point(end).buffer(40))
        return max(getattr(found, "geoms", [found]), key=lambda part: part.area)

    allowance = np.array(beside(30).exterior.coords)
    folded = shapely.Polygon(allowance - 2 * ((allowance - end) @ outward)[:, None] * outward)
    return folded.difference(cut).area, beside(-9.9).difference(folded).area  # the allowance is 10 mm wide


@pytest.mark.parametrize(("name", "count"), [("Cushion", 8), ("Armchair cover", 4)])
def test_both_allowances_of_a_seam_end_on_the_line_that_crosses_it(name, count):
    ends = seam_ends(name)
    turns = {place: abs(sum(angle for *_, angle in sides) - 180) for place, sides in ends.items() if len(sides) == 2}
    checked = 0
    for _, group in itertools.groupby(sorted(turns), key=lambda place: place[0]):
        first, *others = sorted(group, key=turns.get)
        is_first = turns[first] < STRAIGHT and all(turns[other] > turns[first] + OTHERS for other in others)
        around = [line for piece, points, _ in ends[first] for line in lines_from(piece, points[0])]
        if is_first and all(seam is not None and is_straight(points) for seam, points in around):
            checked += 1
            for piece, points, _ in ends[first]:
                sticks_out, is_missing = off_when_pressed(piece, points)
                assert sticks_out < 0.5 and is_missing < 0.5  # with mitres, it would be 6 to 10
    assert checked == count
