# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on names pieces, orders suggestions and divides its work into steps."""

import inspect
import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest


def test_many_pieces_of_mirrored_pairs_have_one_name_but_for_the_side(addon):
    normals = np.array([[0, -1, 0]] * 5 + [[1, 0, 0], [-1, 0, 0]] * 2, dtype=float)
    places = [(0.2, -0.1, 0.3), (-0.2, -0.1, -0.3), (0.2, -0.1, -0.3), (-0.2, -0.1, 0.3), (0, -0.1, 0)]
    places += [(0.4, 0, -0.2), (-0.4, 0, 0.2), (0.4, 0, 0.2), (-0.4, 0, -0.2)]
    offsets = np.array(places, dtype=float)
    identity = addon.solve.identity
    order, names = identity.from_top(offsets), identity.side_names(normals, offsets)
    names = dict(zip(order, identity.numbered([names[index] for index in order], []), strict=True))
    front = ["Front Upper Left", "Front Lower Right", "Front Lower Left", "Front Upper Right", "Front"]
    sides = ["Left Lower", "Right Upper", "Left Upper", "Right Lower"]
    assert [names[index] for index in range(9)] == [*front, *sides]


def test_pieces_in_an_even_row_are_named_by_their_half(addon):
    for count, (upper, middle, lower) in {3: (1, 1, 1), 4: (2, 0, 2), 5: (2, 1, 2), 6: (2, 2, 2)}.items():
        places = ["Upper"] * upper + [""] * middle + ["Lower"] * lower
        offsets = np.array([[0.4, 0, 0.3 - 0.6 * k / (count - 1)] for k in range(count)])
        names = addon.solve.identity.side_names(np.tile([1.0, 0, 0], (count, 1)), offsets)
        assert names == [f"Left {place}".rstrip() for place in places]


@pytest.mark.parametrize(
    ("normals", "offsets", "names"),
    [
        ([(0, 0, 0)] * 2, [(0, 0, 0), (0, 0, 0.4)], ["Around", "Top"]),
        ([(0, -1, 0)] * 3, [(0, -0.2, 0), (-0.3, -0.2, 0.02), (-0.3, -0.2, -0.02)], ["Front"] + ["Front Right"] * 2),
        (
            [(0, -1, 0)] * 2 + [(1, 0, 0)] * 2,
            [(0.2, -0.4, 0), (-0.2, -0.4, 0), (0.4, -0.2, 0), (0.4, 0.2, 0)],
            ["Front Left", "Front Right", "Left Side Front", "Left Back"],
        ),
    ],
    ids=["ring and top", "middle of the front", "front of the left"],
)
def test_pieces_are_named_after_their_side_and_place(addon, normals, offsets, names):
    """normals: directions that the pieces face; zero for a ring. offsets: places from the model's middle."""
    assert addon.solve.identity.side_names(np.array(normals, float), np.array(offsets, float)) == names


def test_the_chosen_set_has_the_fewest_pieces_for_the_fabric(addon):
    suggest = addon.solve.suggest
    # (pieces, stretch); the sets of 6 and 8 pieces need more stretch than the set of 5, or hardly less
    figures = (9, 0.04), (3, 0.3), (5, 0.1), (6, 0.2), (8, 0.097)
    sets = [suggest.Cut([], [], [], None, 0, [1.0], strain, math.inf, pieces) for pieces, strain in figures]
    narrow = [replace(each, is_narrow=True) if each.num_pieces == 5 else each for each in sets]
    assert [each.num_pieces for each in suggest.from_few_pieces(narrow, [0.5, 1.0])] == [3, 5, 6, 8, 9]
    # Only the sets of 8 and 9 pieces are within the limit of 9.8%.
    assert [each.num_pieces for each in suggest.from_few_pieces(sets, [0.098, 1.0])] == [3, 5, 8, 9]
    beside = replace(sets[0], num_pieces=8, strain=0.03, is_narrow=True)
    rows = [(each.num_pieces, each.strain) for each in suggest.from_few_pieces([*sets, beside], [0.098, 1.0])]
    assert rows[2:4] == [(8, 0.097), (8, 0.03)]
    worse = replace(sets[0], num_pieces=12, strain=0.3, is_narrow=True)
    assert worse not in suggest.from_few_pieces([*sets, worse], [0.5, 1.0])
    # The set of 30% is left out, because the softer direction stretches only 20%, and another set needs less stretch.
    assert [each.num_pieces for each in suggest.from_few_pieces(sets, [0.098, 0.2])] == [5, 8, 9]
    assert [each.num_pieces for each in suggest.from_few_pieces(sets, [0.01, 0.02])] == [3, 5, 9]
    sets = suggest.from_few_pieces(sets, [0.5, 1.0])
    assert [each.num_pieces for each in sets] == [3, 5, 9]
    assert [suggest.set_for(sets, [limit]) for limit in (0.5, 0.2, 0.05, 0.01)] == [0, 1, 2, 2]
    assert suggest.set_for(sets, [0.05, 0.5]) == 2  # this set is within the limits of both directions of the fabric
    sets[1] = replace(sets[1], is_narrow=True)
    assert [suggest.set_for(sets, [limit]) for limit in (0.5, 0.2, 0.01)] == [0, 2, 2]
    narrow = [replace(each, is_narrow=True) for each in sets]
    assert suggest.set_for(narrow, [0.2]) == 1
    koala = [replace(sets[0], strain=0.77), replace(sets[0], num_pieces=4, strain=0.17, is_narrow=True)]
    assert suggest.set_for(koala, [0.2]) == 1  # less stretch counts more than a greater width
    assert suggest.set_for(koala, [0.1]) == 1


@pytest.fixture
def measured(addon):
    """Return a function that makes a set of seams whose pieces need the given stretch of minky."""

    def make(pieces, across, along):
        ways = addon.core.report.model.Ways(across=0.2, along=0.05)
        threads = addon.core.Threads(cloth="minky", across=across, along=along, shear=0, gives=ways, worn=ways)
        cut = addon.solve.suggest.Cut([], [], [], None, 0, [1.0], max(across, along), math.inf, pieces)
        return replace(cut, threads=threads)

    return make


def test_each_direction_of_the_fabric_decides_about_a_measured_set(addon, measured):
    suggest, limits = addon.solve.suggest, [0.05, 0.2]
    upright, turned, many = measured(4, 0.15, 0.04), measured(3, 0.04, 0.15), measured(9, 0.03, 0.03)
    assert suggest.set_for([turned, upright, many], limits) == 1
    assert suggest.set_for([turned, many], limits) == 1
    # No set suits the fabric, and the second set exceeds the limits less.
    assert suggest.set_for([turned, measured(4, 0.04, 0.12)], limits) == 1
    close = replace(measured(4, 0.149, 0.03), lengths=[2.0])  # gains little, but the fabric allows it
    assert suggest.from_few_pieces([turned, close, many], limits) == [turned, close, many]
    assert suggest.from_few_pieces([measured(3, 0.15, 0.03), close, many], limits)[1:] == [many]


def test_seams_are_cleared_up_to_the_softer_direction_of_the_fabric_if_the_other_allows_it(addon, measured):
    sets, steps = addon.solve.seam_sets, addon.solve.steps
    assert sets.limits_up_to([]) == [0.05, 0.1, 0.2] and sets.limits_up_to([0.03]) == [0.03]
    assert sets.limits_up_to([0.07, 0.3]) == [0.05, 0.07, 0.1, 0.2, 0.3]

    def search(cuts):
        yield 0.5
        return cuts

    def allowed(*cuts):
        return steps.in_one_go(sets.within_fabric(search(list(cuts)), [0.05, 0.2], "Choose another."))

    upright, turned = measured(4, 0.15, 0.04), measured(3, 0.04, 0.15)
    assert allowed(turned, upright) == [upright]
    with pytest.raises(addon.issues.ObjectError, match=r"Every seam is needed for this fabric\. Choose another"):
        allowed(turned)
    with pytest.raises(steps.CanceledError):
        allowed(replace(upright, threads=None))  # canceled while sets were measured


@pytest.fixture
def measuring(addon, measured, monkeypatch):
    """Return a function and two sets of seams, of 3 and 5 pieces. The function measures them with the given results."""
    sets = addon.solve.seam_sets
    found = [replace(measured(pieces, 0.1, 0.1), threads=None) for pieces in (3, 5)]

    def search():
        yield 0.5
        return found

    def begin(*results):
        left = iter(results)

        def measure(*_):
            yield 0.5
            return next(left)

        monkeypatch.setattr(sets, "_measured_set", measure)
        return sets.with_measures(search(), None, None, [0.05, 0.2])

    return begin, found


def test_sets_with_a_piece_that_fails_with_the_fabric_are_left_out(addon, measured, measuring):
    begin, found = measuring
    failed, good = replace(found[0], strain=math.inf), measured(5, 0.08, 0.03)
    assert addon.solve.steps.in_one_go(begin(failed, good)) == [good]
    sentence = "has a piece that fails with this fabric. Choose another fabric."
    with pytest.raises(addon.issues.ObjectError, match=sentence):
        addon.solve.steps.in_one_go(begin(failed, replace(found[1], strain=math.inf)))


def test_a_canceled_comparison_keeps_what_it_has_measured(addon, measured, measuring):
    begin, found = measuring
    good = measured(3, 0.15, 0.03)
    run = begin(good, found[1])
    shares = [next(run) for _ in range(3)]  # shares of the search and of both sets
    assert shares == sorted(shares)
    with pytest.raises(StopIteration) as end:
        run.throw(addon.solve.steps.CanceledError())
    assert end.value.value == [good, found[1]]


def test_mirror_images_are_one_row_with_or_without_common_figures(addon):
    def proposal(strain, twin, together):
        cut = {"edges": np.array([[0, 1]]), "paths": [], "piece": 0, "length": 1.0, "num_pieces": 1}
        return SimpleNamespace(**cut, strain=strain, strain_before=0.5, twin=twin, strain_with_twin=together)

    apart = [proposal(0.3, 1, None), proposal(0.3, 0, None)]
    together = [proposal(0.4, 3, 0.2), proposal(0.4, 2, 0.2)]
    edges, triangles = np.array([[0, 1], [0, 2], [1, 2]]), np.array([[0, 1, 2]])
    arrays = SimpleNamespace(vertices=np.eye(3), edges=edges, triangles=triangles, triangle_polygons=np.array([0]))
    cuts = addon.solve.suggest._with_mirror_images([*apart, *together], arrays)
    assert [(cut.strain, len(cut.lengths)) for cut in cuts] == [(0.3, 1), (0.2, 2)]


@pytest.mark.parametrize(
    ("needed", "proposed"),
    [(0.03, 0.03), (0.012341, 0.0124), (0.9991, 1.0), (1.0004e-5, 1.01e-5), (2.5, 2.5), (math.inf, math.inf)],
)
def test_tolerances_are_rounded_up(addon, needed, proposed):
    assert addon.solve.flatten.round_up(needed) == pytest.approx(proposed, rel=1e-12)


@pytest.mark.parametrize(("tolerance", "text"), [(0.0, "rigid"), (0.03, "±3%"), (0.0125, "±1.25%"), (math.inf, "free")])
def test_tolerances_are_shown_in_percent(addon, tolerance, text):
    assert addon.core.tolerance_text(tolerance) == text


@pytest.mark.parametrize("driver", ["in_one_go", "in_slices", "reported_as"])
def test_steps_are_closed_if_the_listener_raises(addon, driver):
    def working():
        while True:
            yield 0.5

    def fail(_reported):
        raise ZeroDivisionError

    # The variable `work` keeps the generator alive, so garbage collection cannot close it.
    steps, work = addon.solve.steps, working()
    with pytest.raises(ZeroDivisionError):
        if driver == "in_one_go":
            steps.in_one_go(work, fail)
        elif driver == "in_slices":
            steps.in_one_go(steps.in_slices(work), fail)
        else:
            steps.in_one_go(steps.reported_as(work, fail))
    assert inspect.getgeneratorstate(work) == inspect.GEN_CLOSED


def test_shear_is_written_in_degrees(addon):
    assert addon.solve.maps.SHEAR.number(math.radians(18)) == "18°"
