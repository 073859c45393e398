# SPDX-License-Identifier: GPL-3.0-or-later
"""Patterns have correct cutting and stitching lines, notches, clips, folds and warnings, and refuse bad input."""

import math

import numpy as np
import pytest
import shapely
import wirewarp
from patterns import cut_polygon, grid, line_string, marks, quads, rectangle, sample, sew_polygon
from samples import SAMPLES, flattened
from surfaces import tetrahedron
from wirewarp.pattern import Pattern
from wirewarp.pattern.geometry import innermost_point


@pytest.mark.core
@pytest.mark.parametrize("name", SAMPLES)
def test_the_cutting_line_is_at_the_width_from_every_stitching_line(name):
    for piece in sample(name, darts="cut").pieces:
        cut, outline = cut_polygon(piece), sew_polygon(piece)
        assert cut.is_valid and cut.contains_properly(outline)
        sides = [line_string(line) for line in piece.of_role("sew")]
        corners = shapely.MultiPoint([place for side in sides for place in (side.coords[0], side.coords[-1])])
        edge = shapely.MultiLineString([cut.exterior, *cut.interiors])
        for side, line in zip(sides, piece.of_role("sew"), strict=True):
            places = shapely.line_interpolate_point(side, np.linspace(0, side.length, 30))
            assert np.all(shapely.distance(places[shapely.distance(places, corners) > 30], edge) > line.width - 0.01)
        places = shapely.line_interpolate_point(edge, np.linspace(0, edge.length, 100))
        places = places[shapely.distance(places, corners) > 40]
        nearest = np.array(sides)[shapely.distance(places[:, None], sides).argmin(axis=1)]
        feet = shapely.line_interpolate_point(nearest, shapely.line_locate_point(nearest, places))
        on_edges = shapely.distance(feet, [shapely.MultiPoint(side.coords) for side in nearest]) > 1e-6
        assert shapely.distance(feet, places)[on_edges] == pytest.approx(10, abs=0.01)


@pytest.mark.parametrize("name", ["Fitted top", "Carnival mask", "Toy"])
def test_stitching_lines_are_the_flattened_outlines(name):
    for piece, flat in zip(sample(name).pieces, flattened(name).pieces, strict=True):
        boundaries = sorted(boundary.length_2d * 1000 for boundary in flat.boundaries)
        lengths = sorted(line_string(line).length for line in piece.of_role("sew"))
        assert lengths == pytest.approx(boundaries, rel=1e-12)
        wires = [wire for wire in flat.wires if wire.kind != "boundary"]
        drawn = piece.of_role("wire")
        assert [(line.name, line.kind) for line in drawn] == [(wire.name, wire.kind) for wire in wires]
        for line, wire in zip(drawn, wires, strict=True):
            assert line_string(line).length == pytest.approx(wire.length_2d * 1000, rel=1e-12)


def test_cutting_lines_of_different_pieces_are_apart():
    cuts = [cut_polygon(piece) for piece in sample("Toy").pieces]
    tree = shapely.STRtree(cuts)
    for index, cut in enumerate(cuts):
        assert tree.query(cut, predicate="intersects").tolist() == [index]


@pytest.mark.parametrize("name", ["Fitted top", "Hat", "Jeans", "Wetsuit upper body"])
def test_notches_begin_on_the_cutting_line_and_end_before_the_stitching_line(name):
    for piece in sample(name, hem=30.0).pieces:
        cut, outline = cut_polygon(piece), sew_polygon(piece)
        for point in marks(piece, "notch", "clip"):
            start, end = (shapely.Point(place) for place in point.stroke)
            assert cut.boundary.distance(start) < 1e-3 and outline.distance(end) > 1.9 and cut.contains(end)


@pytest.mark.parametrize("name", ["Fitted top", "Ball of six gores", "Cushion", "Toy"])
def test_notches_pair_at_equal_sewn_length_and_no_seam_fits_upside_down(name):
    places = {}
    for piece in sample(name).pieces:
        lines = [line for line in piece.of_role("sew") if line.seam is not None]
        for point in piece.points:
            if point.pair:
                ray = shapely.LineString([point.at, point.at + 20 * point.direction])
                own = (line_string(line) for line in lines if line.seam == point.pair[0])
                line = next(line for line in own if line.intersects(ray))
                at = line.project(shapely.Point(ray.intersection(line).coords[0]))
                places.setdefault(point.pair, []).append((at, line.length))
    seams = {}
    for (seam, _), ends in places.items():
        # If a seam is not a dart, the outlines along its two sides run in opposite directions.
        (first, length), (second, _) = ends
        assert min(abs(first - second), abs(first - (length - second))) < 1e-6
        seams.setdefault(seam, (length, []))[1].append(first)
    for length, found in seams.values():
        turned = sorted(length - place for place in found)
        assert max(abs(a - b) for a, b in zip(sorted(found), turned, strict=True)) > 4.9


def test_seams_of_a_back_have_double_notches():
    result = flattened("Fitted top")
    plain = Pattern.from_result(result)
    named = Pattern.from_result(result, piece_names=["Front", "Back", "Sleeve", "Sleeve"])

    def paired(pattern, index):
        return sum(1 for point in pattern.pieces[index].points if point.pair)

    assert paired(named, 1) == 2 * paired(plain, 1)


def junction() -> wirewarp.FlattenResult:
    """Return four pieces around a vertex, at which the seam from left to right is straight and the other seam bends."""
    points = [(0, 0), (160, 0), (300, 0), (0, 100), (150, 100), (300, 100), (0, 200), (190, 200), (300, 200)]
    corners = [(0, 1, 4, 3), (1, 2, 5, 4), (3, 4, 7, 6), (4, 5, 8, 7)]
    return quads(points, corners, seams=[(1, 4), (4, 7), (3, 4), (4, 5)])


def test_both_allowances_of_a_seam_end_on_the_cutting_lines_that_cross_it():
    # The crossing seam runs straight on, so seams 1-4 and 4-7 are sewn before the crossing seam. Their allowances are
    # pressed open, and end on its cutting line.
    result = junction()
    sticks_out, falls_short = np.zeros(4), np.zeros(4)
    for piece in Pattern.from_result(result).pieces:
        cut, lines = cut_polygon(piece), [line for line in piece.of_role("sew") if line.seam is not None]
        ends = [tuple(end) for line in lines for end in (line.points[0], line.points[-1])]
        (meeting,) = {end for end in ends if ends.count(end) == 2}
        for line in lines:
            a, b = line.points[0], line.points[-1]
            along = (b - a) / np.linalg.norm(b - a)
            normal = np.array([along[1], -along[0]])
            first, last = a - 99 * along, b + 99 * along

            def beside(reach, first=first, last=last, normal=normal, cut=cut, meeting=meeting):
                strip = shapely.Polygon([first, last, last + reach * normal, first + reach * normal])
                return cut.intersection(strip).intersection(shapely.Point(meeting).buffer(40))

            corners = np.array(beside(99).exterior.coords)
            folded = shapely.Polygon(corners - 2 * ((corners - a) @ normal)[:, None] * normal)
            sticks_out[line.seam] += folded.difference(cut).area
            under = beside(-10).intersection(shapely.Point(meeting).buffer(25))
            falls_short[line.seam] += under.difference(folded).area
    first = [number for number, seam in enumerate(result.seams) if set(seam.edges[0].tolist()) in ({1, 4}, {4, 7})]
    last = [number for number in range(4) if number not in first]
    assert np.all(sticks_out[first] < 0.01) and np.all(falls_short[first] < 0.01)
    assert np.all(falls_short[last] > 10)


def test_a_hem_is_wider_and_side_allowances_differ_by_side():
    result = grid([0, 300], [0, 100, 200], seams=[(2, 3)])
    pattern = Pattern.from_result(
        result, allowance=10, hem=30, allowances=[(0, 1, 15)], side_allowances=[(3, 2, 6), (2, 0, 0)]
    )
    found = [sorted({line.width for line in piece.of_role("sew")}) for piece in pattern.pieces]
    assert found == [[0.0, 6.0, 15.0, 30.0], [10.0, 30.0]]
    assert sorted(pattern.pieces[0].size) == pytest.approx([100 + 15 + 6, 300 + 30], abs=1e-3)


def test_a_slit_inside_a_piece(tmp_path):
    result = grid(range(0, 360, 40), range(0, 360, 40), seams=[(38, 39), (39, 40), (40, 41)])
    found = {}
    for how in ("close", "cut", "slit"):
        pattern = Pattern.from_result(result, darts=how)
        (piece,) = pattern.pieces
        found[how] = [line_string(line).length for line in piece.of_role("inner_cut")]
        holes = [point.at for point in marks(piece, "drill")]
        assert len(holes) == (0 if how == "cut" else 2)
        if holes:  # each hole is 13 mm from an end of the slit
            assert np.linalg.norm(holes[0] - holes[1]) == pytest.approx(3 * 40 - 2 * 13)
        assert [warning.count("fills 1 of 1 holes") for warning in pattern.warnings] == ([1] if how == "cut" else [])
        for ending in ("svg", "pdf", "dxf", "plt"):
            pattern.write(tmp_path / f"slit.{ending}")
        pattern.write(tmp_path / "slit.dxf", dialect="plain")
    assert found == {"close": [], "cut": [], "slit": pytest.approx([120])}


def test_a_mirrored_flattening_has_its_allowance_outside():
    plain, mirrored = sample("Hat"), Pattern.from_result(flattened("Hat", mirror=True))
    for one, other in zip(plain.pieces, mirrored.pieces, strict=True):
        assert cut_polygon(other).contains_properly(sew_polygon(other))
        assert cut_polygon(other).area == pytest.approx(cut_polygon(one).area, rel=1e-6)
        assert len(one.points) == len(other.points)


def test_an_inward_corner_is_clipped():
    points = [(0, 0), (100, 0), (200, 0), (0, 100), (100, 100), (200, 100), (0, 200), (100, 200)]
    result = quads(points, [(0, 1, 4, 3), (1, 2, 5, 4), (3, 4, 7, 6)])
    (piece,) = Pattern.from_result(result).pieces
    (clip,) = marks(piece, "clip")
    assert clip.depth == pytest.approx(10 * math.sqrt(2) - 2, abs=1e-3)  # measured from the cutting line's corner
    start, end = (shapely.Point(place) for place in clip.stroke)
    assert cut_polygon(piece).exterior.distance(start) < 1e-3
    assert sew_polygon(piece).exterior.distance(end) == pytest.approx(math.sqrt(2), abs=1e-3)


def test_a_gap_filled_by_allowance_has_no_clips():
    points = [(x, y) for y in (0, 100, 300) for x in (0, 100, 112, 212)]  # a piece with a gap of 12 mm from the top
    result = quads(points, [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (4, 5, 9, 8), (6, 7, 11, 10)])
    clips = {}
    for allowance in (4.0, 10.0):
        (piece,) = Pattern.from_result(result, allowance=allowance).pieces
        clips[allowance] = [point.depth for point in marks(piece, "clip")]
    assert clips == {4.0: pytest.approx([4 * math.sqrt(2) - 2] * 2, abs=1e-3), 10.0: []}


def test_pieces_with_different_allowances_are_not_a_pair():
    points = [(0, 0), (100, 0), (100, 50), (0, 80), (200, 0), (300, 0), (300, 80), (200, 50)]
    result = quads(points, [(0, 1, 2, 3), (4, 5, 6, 7)])
    (pair,) = Pattern.from_result(result, pairs=True, on_fold=True).pieces
    assert pair.quantity == (1, 1) and not pair.on_fold
    assert len(Pattern.from_result(result, pairs=True, allowances=[(0, 1, 20)]).pieces) == 2


def test_holes_filled_by_their_allowance_are_reported():
    assert sample("Carnival mask", allowance=25.0).warnings == [
        '"Piece 1": the allowance fills 2 of 2 holes, which are not cut.'
    ]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"allowance": -1}, "allowance is -1"),
        ({"allowance": math.nan}, "allowance is nan"),
        ({"allowance": 1e9}, "from 0 to 1000"),
        ({"allowance": "wide"}, "allowance is 'wide'"),
        ({"hem": math.inf}, "hem is inf"),
        ({"allowances": [(0, 1)]}, r"\(k, 3\)"),
        ({"allowances": [(0, 1, math.nan)]}, "edge 0-1 is nan"),
        ({"allowances": [(0, 2, 5)]}, "Edge 0-2 is not on the outline"),
        ({"allowances": [(0.5, 1, 5)]}, "not a whole number"),
        ({"side_allowances": [(1, 0, 5)]}, "Edge 1-0 is not on the outline"),
        ({"folds": [(0, 99)]}, "Edge 0-99 is not on the outline"),
        ({"folds": [0, 3]}, r"folds must be an array \(k, 2\)"),
        ({"notch_spacing": 0.5}, "Notches every 0.5 mm cannot be cut"),
        ({"notch_spacing": -5}, "notch_spacing is -5"),
        ({"millimeters_per_unit": 0}, "millimeters_per_unit is 0"),
        ({"piece_names": ["a", "b"]}, "must be 1 texts"),
        ({"corner": "pointed"}, "corner is 'pointed'"),
        ({"darts": "open"}, "darts is 'open'"),
        ({"units": "feet"}, "units is 'feet'"),
        ({"title": None}, "title, material and date must be texts"),
        ({"date": 2026}, "title, material and date must be texts"),
    ],
)
def test_bad_input_gives_one_sentence(options, words):
    with pytest.raises(wirewarp.FlattenError, match=words) as raised:
        Pattern.from_result(rectangle(100, 100), **options)
    assert str(raised.value).count(". ") == 0


@pytest.mark.parametrize("size", [1e6, 1e12, 1e30])  # from 1e12 on, Clipper would end the process
def test_a_piece_of_the_wrong_unit_gives_one_sentence(size):
    vertices = size * np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], dtype=float)
    result = wirewarp.flatten(vertices, np.array([(0, 1, 2), (0, 2, 3)]))
    with pytest.raises(wirewarp.FlattenError, match=r'"Piece 1" reaches .* km far, .* unit of the model'):
        Pattern.from_result(result)


def test_a_piece_that_breaks_a_guarantee_is_refused():
    result = wirewarp.flatten(*tetrahedron())
    with pytest.raises(wirewarp.FlattenError, match='"Piece 1" is not ready to cut'):
        Pattern.from_result(result)


def test_nothing_is_cut_at_a_fold():
    (piece,) = Pattern.from_result(rectangle(100, 60), allowance=10, folds=[(0, 3)]).pieces
    (fold,) = piece.of_role("fold")
    assert np.linalg.norm(np.diff(fold.points, axis=0), axis=1).sum() == pytest.approx(60)
    (cut,) = piece.of_role("cut")
    assert np.sort(np.ptp(cut.points, axis=0)) == pytest.approx([60 + 10 + 10, 100 + 10])
    assert piece.on_fold and "Cut 1 on the fold" in piece.texts[0].lines
    assert piece.area == pytest.approx(100 * 60)


def test_a_fold_must_not_be_sewn():
    with pytest.raises(wirewarp.FlattenError, match="is a fold, but it is sewn"):
        Pattern.from_result(flattened("Hat"), folds=flattened("Hat").seams[0].edges[:1])


def test_a_crooked_fold_is_reported():
    points = [(0, 0), (100, 0), (100, 30), (3, 30), (0, 60), (100, 60)]
    result = quads(points, [(0, 1, 2, 3), (3, 2, 5, 4)])
    (warning,) = Pattern.from_result(result, folds=[(0, 3), (3, 4)]).warnings
    assert "its fold is 3.0 mm off a straight line" in warning


def test_room_for_text_is_found_in_a_ring_and_beside_its_wires():
    turn = np.linspace(0, 2 * math.pi, 60, endpoint=False)
    circle = np.column_stack([np.cos(turn), np.sin(turn)])
    center, depth = innermost_point([100 * circle, 60 * circle + (20, 0)], [])
    assert depth == pytest.approx(30, abs=2)  # half of the ring's greatest width, on the left
    assert np.linalg.norm(center + (70, 0)) < 20
    square = 100 * np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])
    assert innermost_point([square], [])[1] == pytest.approx(50, abs=1)
    middle = np.array([[0, 60.0], [100, 60]])
    center, depth = innermost_point([square], [middle])
    assert depth == pytest.approx(30, abs=1.5)
    assert center[1] == pytest.approx(30, abs=1.5)


def test_the_date_is_on_every_piece():
    pattern = Pattern.from_result(flattened("Hat"), title="Hat", date="22 November 2026")
    assert all(piece.texts[0].lines[0] == "Hat, 22 November 2026" for piece in pattern.pieces)
    assert Pattern.from_result(rectangle(100, 60), date="2026").pieces[0].texts[0].lines[0] == "2026"


@pytest.mark.parametrize(("height", "depth"), [(8, 2.4), (60, 5.0)])
def test_notches_without_allowance_that_face_each_other_do_not_meet(height, depth):
    """A wire across the piece has two notches. Their depth is 0.3 times the height of the piece, at most 5 mm."""
    result = grid([0, 100, 200], [0, height], wires=[wirewarp.Wire([1, 4])])
    (piece,) = Pattern.from_result(result, allowance=0, notch_spacing=0).pieces
    (wire,) = piece.of_role("wire")
    assert [point.depth for point in piece.points] == pytest.approx([depth, depth], abs=1e-3)
    strokes = [shapely.LineString(point.stroke) for point in piece.points]
    assert all(shapely.distance(stroke, line_string(wire)) < 1e-6 for stroke in strokes)
    assert all(cut_polygon(piece).buffer(1e-6).contains(stroke) for stroke in strokes)
    assert strokes[0].distance(strokes[1]) == pytest.approx(height - 2 * depth, abs=2e-3)


@pytest.mark.parametrize("allowance", [2.0, 6.0, 30.0])
def test_a_notch_is_half_as_deep_as_the_allowance_and_at_most_5_mm(allowance):
    result = grid([0, 100, 200], [0, 60], wires=[wirewarp.Wire([1, 4])])
    (piece,) = Pattern.from_result(result, allowance=allowance, notch_spacing=0).pieces
    assert [point.depth for point in piece.points] == pytest.approx([min(allowance / 2, 5.0)] * 2)
    for point in piece.points:
        assert sew_polygon(piece).distance(shapely.Point(point.at)) == pytest.approx(allowance)
        assert sew_polygon(piece).distance(shapely.LineString(point.stroke)) > allowance / 2 - 1e-6


def test_a_seam_without_an_opening_is_named():
    with pytest.raises(wirewarp.FlattenError, match='Edge 5-6 is a seam inside "Piece 1" that opens nothing') as error:
        Pattern.from_result(grid([0, 10, 20, 30], [0, 10, 20], seams=[(5, 6)]))
    assert list(error.value.edges) == [(5, 6)]
