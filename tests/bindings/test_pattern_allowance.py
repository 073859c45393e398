# SPDX-License-Identifier: GPL-3.0-or-later
"""The cutting line around any outline is one loop at the requested distances, and each type of corner has its shape."""

import math

import numpy as np
import pytest
import shapely
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from wirewarp.pattern.geometry import signed_area
from wirewarp.pattern.make.allowance import Corner, Section, cut_lines
from wirewarp.pattern.make.corners import CORNER_TYPES


def random_sections(random: np.random.Generator) -> list[Section]:
    """Return the sections of a wavy outline around a circle with a radius of 200 mm."""
    count = random.integers(12, 200)
    angles = np.linspace(0, 2 * np.pi, count, endpoint=False)
    waves = range(1, int(random.integers(2, 9)))
    radius = 200 + sum(random.uniform(0, 60) / k * np.cos(k * angles + random.uniform(0, 7)) for k in waves)
    points = np.column_stack([radius * np.cos(angles), radius * np.sin(angles)])
    starts = np.sort(random.choice(len(points), int(random.integers(2, min(9, len(points) // 2))), replace=False))
    points, ends = np.roll(points, -starts[0], axis=0), [*(starts[1:] - starts[0]), len(points)]
    closed, begins = np.concatenate([points, points[:1]]), [0, *ends[:-1]]
    return [
        Section(
            closed[a : b + 1],
            float(random.choice([0, 6, 10, 15, 30, *random.uniform(0.5, 40, 5)])),
            Corner(str(random.choice(CORNER_TYPES)), bool(random.random() < 0.5)),
        )
        for a, b in zip(begins, ends, strict=True)
    ]


@settings(max_examples=max(300, settings.default.max_examples))  # 300 examples take 2 s
@given(seed=st.integers(0, 2**32 - 1))
def test_any_widths_around_any_outline_make_one_loop(seed):
    loop = random_sections(np.random.default_rng(seed))
    outline = shapely.Polygon(np.concatenate([section.points[:-1] for section in loop]))
    assume(outline.is_valid)
    found = cut_lines([loop])
    (outer,) = found.outer
    cut = shapely.Polygon(outer)
    assert cut.is_valid and cut.buffer(1e-3).contains(outline)
    closed = cut.buffer(0.01, join_style="mitre").buffer(-0.01, join_style="mitre")  # without slits up to 0.02 mm wide
    assert closed.area - cut.area < 0.5
    corners = shapely.MultiPoint([section.points[-1] for section in loop])
    zone = 4 * max(section.width for section in loop)
    lines = [shapely.LineString(section.points) for section in loop]
    # A pocket is a gap that the allowance encloses. Its outline is at least as far from every section as the section's
    # width.
    for pocket in found.pockets:
        places = shapely.points(pocket)
        for section, line in zip(loop, lines, strict=True):
            free = places[shapely.distance(places, corners) > zone]
            assert np.all(shapely.distance(free, line) > section.width - 0.01)
    for section, line in zip(loop, lines, strict=True):
        places = shapely.line_interpolate_point(line, np.linspace(0, line.length, 40))
        free = places[shapely.distance(places, corners) > zone]
        assert np.all(shapely.distance(free, cut.exterior) > section.width - 0.01)
    places = shapely.line_interpolate_point(cut.exterior, np.linspace(0, cut.length, 300))
    places = places[shapely.distance(places, corners) > zone]
    distances = np.array([shapely.distance(places, line) for line in lines])
    vertices = shapely.MultiPoint(outline.exterior.coords)
    for number, (section, line) in enumerate(zip(loop, lines, strict=True)):
        nearest = places[distances.argmin(axis=0) == number]
        feet = shapely.line_interpolate_point(line, shapely.line_locate_point(line, nearest))
        on_edges = shapely.distance(feet, vertices) > 1e-6  # not at vertices, where a miter is slightly farther away
        assert np.all(np.abs(shapely.distance(feet, nearest)[on_edges] - section.width) < 0.01)


def square(widths, corner: Corner) -> list[Section]:
    """Return the sides of a square of 100 mm, the lower side first. corner: type of the lower right corner."""
    points = np.array([[0.0, 0], [100, 0], [100, 100], [0, 100], [0, 0]])
    corners = [corner, Corner(), Corner(), Corner()]
    return [Section(points[i : i + 2], widths[i], corners[i]) for i in range(4)]


@pytest.mark.parametrize(
    ("kind", "a", "b", "area"),
    [
        ("mitre", 10, 10, 100),
        ("mitre", 20, 10, 200),
        ("step", 20, 20, 400),  # equal widths have no step
        ("fold-back", 20, 10, 200),  # at a right angle, the same area as for a miter
        ("extend", 10, 10, 50),  # a straight line between the ends of both allowances cuts the 100 mm² in half
        ("round", 10, 10, 25 * math.pi),
        ("mitre", 0, 10, 0),
    ],
)
def test_each_type_of_corner_has_its_area(kind, a, b, area):
    (outer,) = cut_lines([square([a, b, 0, 0], Corner(kind))]).outer
    sides = 100 * a + 100 * b  # each ends at a corner whose other side has no allowance
    assert signed_area(outer) == pytest.approx(100 * 100 + sides + area, abs=0.3 if kind == "round" else 0.01)


def test_a_sharp_corner_is_cut_off_at_two_and_a_half_widths():
    points = np.array([[0.0, 0], [300, 0], [0, 30], [0, 0]])
    loop = [Section(points[i : i + 2], 10.0) for i in range(3)]
    (outer,) = cut_lines([loop]).outer
    assert np.linalg.norm(outer - points[1], axis=1).min() > 10
    middle = (points[1] - points[0]) / 300 + (points[1] - points[2]) / math.hypot(300, 30)
    reach = (outer - points[1]) @ (middle / np.linalg.norm(middle))
    assert reach.max() == pytest.approx(25, abs=1e-3)


def test_a_hole_gets_its_allowance_inside_and_a_hole_too_small_is_not_cut():
    outer = np.array([[0.0, 0], [200, 0], [200, 200], [0, 200], [0, 0]])
    hole = np.array([[50.0, 50], [50, 150], [150, 150], [150, 50], [50, 50]])
    found = cut_lines([[Section(outer, 10.0)], [Section(hole, 10.0)]])
    assert signed_area(found.holes[0]) == pytest.approx(-(80**2), abs=0.01)
    for width in (49.99, 50.0):  # the hole of 100 mm would become 0.02 mm or 0 mm wide
        assert cut_lines([[Section(outer, 10.0)], [Section(hole, width)]]).holes == []


def test_a_gap_that_the_allowance_closes_is_a_pocket():
    room = [(40, 40), (40, 160), (160, 160), (160, 40)]
    outline = [(0, 0), (200, 0), (200, 200), (0, 200), (0, 105), (40, 105), (40, 160), (160, 160), (160, 40), (40, 40)]
    points = np.array([*outline, (40, 95), (0, 95), (0, 0)], dtype=float)
    found = cut_lines([[Section(points, 10.0)]])
    assert len(found.outer) == 1 and found.holes == []
    area = shapely.Polygon(room).buffer(-10, join_style="mitre").area
    assert sum(-signed_area(pocket) for pocket in found.pockets) == pytest.approx(area, abs=0.01)
    hole = np.array([(5.0, 5), (5, 35), (195, 35), (195, 5), (5, 5)])
    both = cut_lines([[Section(points, 10.0)], [Section(hole, 10.0)]])
    assert [-signed_area(line) for line in (*both.holes, *both.pockets)] == pytest.approx([170 * 10, area], abs=0.01)


@pytest.mark.parametrize("width", [4.0, 12.0])
@pytest.mark.parametrize("lean", [-0.45, 0.0, 0.45])
@pytest.mark.parametrize(("mouth", "depth"), [(60, 8), (40, 40), (40, 6), (20, 60), (8, 5), (4, 60), (4, 8), (300, 4)])
def test_a_notch_in_a_section_is_filled_as_far_as_the_width(mouth, depth, lean, width):
    """The outline has a V-shaped notch, whose sides may be shorter than the allowance is wide."""
    top = [(200 + mouth / 2, 100), (200 + lean * mouth, 100 - depth), (200 - mouth / 2, 100)]
    points = np.array([(0, 0), (400, 0), (400, 100), *top, (0, 100), (0, 0)], dtype=float)
    (outer,) = cut_lines([[Section(points, width)]]).outer
    expected = shapely.Polygon(points).buffer(width, join_style="mitre", mitre_limit=1e6)
    assert shapely.Polygon(outer).symmetric_difference(expected).area < 0.05


@pytest.mark.parametrize("of_next", [False, True])
@pytest.mark.parametrize("wide_first", [False, True])
def test_at_obtuse_corners_the_wider_allowance_ends_on_the_narrower_cutting_line(wide_first, of_next):
    """The area inside the cutting line of an octagon with miters is the intersection of half planes, one per edge."""
    angles = 2 * np.pi * np.arange(8) / 8
    points = 200 * np.column_stack([np.cos(angles), np.sin(angles)])
    expected, loop = shapely.box(-500, -500, 500, 500), []
    for number, (a, b) in enumerate(zip(points, np.roll(points, -1, axis=0), strict=True)):
        width = 12.0 if (number % 2 == 0) == wide_first else 5.0
        along, aside = (b - a) / np.linalg.norm(b - a), right_of(a, b)
        edge = np.array([a - 1000 * along, b + 1000 * along]) + width * aside
        expected &= shapely.Polygon([*edge, *(edge[::-1] - 2000 * aside)])
        loop.append(Section(np.array([a, b]), width, Corner("mitre", of_next)))
    (outer,) = cut_lines([loop]).outer
    assert shapely.Polygon(outer).symmetric_difference(expected).area < 0.2  # of about 150,000 mm²


def test_without_an_allowance_no_point_moves():
    points = np.random.default_rng(1).uniform(0, 1, (3, 2)) + [[0, 0], [100, 0], [0, 100]]
    (outer,) = cut_lines([[Section(np.concatenate([points, points[:1]]), 0.0)]]).outer
    assert np.array_equal(outer, points)


def right_of(a, b):
    way = (b - a) / np.linalg.norm(b - a)
    return np.array([way[1], -way[0]])


def half_strip(section, at_end):
    """Return the allowance of half of a straight section, at the section's end or at its start."""
    a, b = section.points
    near, far = (b, (a + b) / 2) if at_end else (a, (a + b) / 2)
    aside = section.width * right_of(a, b)
    return shapely.Polygon([near, far, far + aside, near + aside])


@given(
    st.integers(3, 6),
    st.lists(st.sampled_from([4.0, 8.0, 11.0, 20.0]), min_size=6, max_size=6),
    st.booleans(),
    st.data(),
)
def test_an_allowance_that_folds_back_lies_on_the_piece_and_leaves_its_neighbor_whole(sides, widths, of_next, data):
    """If an allowance of a convex polygon is folded over its stitching line, it does not extend beyond the piece."""
    start = data.draw(st.floats(0, 6))
    angles = start + np.linspace(0, 2 * np.pi, sides, endpoint=False)
    points = 300 * np.column_stack([np.cos(angles), np.sin(angles)])
    ends = np.roll(points, -1, axis=0)
    corner = Corner("fold-back", of_next)
    pairs = zip(points, ends, widths[:sides], strict=True)
    loop = [Section(np.array([a, b]), width, corner) for a, b, width in pairs]
    (outer,) = cut_lines([loop]).outer
    cut = shapely.Polygon(outer)
    for number, first in enumerate(loop):
        second = loop[(number + 1) % sides]
        turn = 2 * np.pi / sides
        back, other = (second, first) if of_next else (first, second)
        if turn <= np.pi / 2:
            assert cut.buffer(1e-3).contains(half_strip(other, at_end=other is first))
        if back.width + other.width > 2.2 * min(back.width, other.width):
            continue  # such a corner would extend too far, so it is a miter instead
        a, b = back.points
        aside = right_of(a, b)
        whole = shapely.Polygon([a, b, b + 3 * back.width * aside, a + 3 * back.width * aside])
        folded = cut.intersection(whole)
        corners = np.array(folded.exterior.coords)
        mirrored = shapely.Polygon(corners - 2 * ((corners - a) @ aside)[:, None] * aside)
        near = shapely.Point(b if back is first else a).buffer(60)
        assert mirrored.intersection(near).difference(cut.buffer(1e-3)).area < 1e-3


@pytest.mark.parametrize("width", [3.0, 10.0])
@pytest.mark.parametrize("degrees", [8, 30, 46, 48, 60, 90, 150])
def test_a_tip_inside_of_a_section_is_a_mitre_that_is_cut_square_at_its_limit(degrees, width):
    """The point of the miter is at the distance width / sin(angle / 2) from the tip."""
    half = math.radians(degrees / 2)
    tip, leg = np.array([0.0, 0.0]), 400.0
    ends = leg * np.array([[-math.cos(half), -math.sin(half)], [-math.cos(half), math.sin(half)]])
    outline = np.array([ends[1], [-1.5 * leg, 0.0], ends[0], tip, ends[1]])  # one section, with the tip inside
    (outer,) = cut_lines([[Section(outline, width)]]).outer
    straight_on = shapely.LineString([tip, (50 * width, 0)]).intersection(shapely.LinearRing(outer))
    expected = min(2.5 * width, width / math.sin(half))
    assert shapely.distance(straight_on, shapely.Point(tip)) == pytest.approx(expected, abs=1e-3)
    if expected == 2.5 * width:  # the miter is cut off at a right angle to the middle line of the tip
        edge = outer[np.abs(outer[:, 0] - expected) < 1e-3]
        reach = (width - expected * math.sin(half)) / math.cos(half)
        assert np.sort(edge[:, 1]) == pytest.approx([-reach, reach], abs=2e-3)
