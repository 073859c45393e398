# SPDX-License-Identifier: GPL-3.0-or-later
"""Wire and Options are checked when they are created."""

import array
import copy
import json
import math
import pickle
from fractions import Fraction

import numpy as np
import pytest
from wirewarp import Ease, ErrorCode, FlattenError, Options, Wire


@pytest.mark.parametrize(
    "vertices",
    [
        [3, 1, 2],
        (3, 1, 2),
        array.array("i", [3, 1, 2]),
        np.array([3, 1, 2], np.uint8),
        np.array([3, 9, 1, 9, 2, 9], np.int64)[::2],
        [np.int64(3), np.uint8(1), 2],
        range(3, 0, -1),
    ],
    ids=repr,
)
def test_any_sequence_of_whole_numbers_makes_a_wire(vertices):
    assert Wire(vertices).vertices.tolist() == [int(v) for v in vertices]


def test_a_wire_keeps_what_it_was_given():
    wire = Wire([0, 1], math.inf, "bust")
    assert (wire.tolerance, wire.name) == (math.inf, "bust")
    assert (Wire([0, 1]).tolerance, Wire([0, 1]).name) == (0.0, "")
    assert Wire([0, 1], tolerance=np.float32(0.25)).tolerance == 0.25


def test_a_checked_wire_cannot_be_changed():
    wire = Wire([0, 1])
    with pytest.raises(ValueError, match="read-only"):
        wire.vertices[0] = -5
    with pytest.raises(AttributeError):
        wire.tolerance = -1.0


@pytest.mark.parametrize(
    ("vertices", "code"),
    [
        ([0, True], ErrorCode.invalid_type),
        (np.array([True, False]), ErrorCode.invalid_type),
        ([0, 1.0], ErrorCode.invalid_type),
        (np.array([0.0, 1.0]), ErrorCode.invalid_type),
        ([0, None], ErrorCode.invalid_type),
        ("01", ErrorCode.invalid_type),
        (b"01", ErrorCode.invalid_type),
        (bytearray(b"01"), ErrorCode.invalid_type),
        (np.ma.array([0, 1, 2], mask=[False, True, False]), ErrorCode.invalid_type),
        ({0, 1}, ErrorCode.invalid_type),
        (None, ErrorCode.invalid_type),
        (7, ErrorCode.invalid_type),
        (np.array([[0, 1]]), ErrorCode.invalid_shape),
        ([], ErrorCode.wire_too_short),
        ([4], ErrorCode.wire_too_short),
        (np.array([4]), ErrorCode.wire_too_short),
        ([0, 2**31], ErrorCode.vertex_out_of_range),
        ([0, -(2**80)], ErrorCode.vertex_out_of_range),
        (np.array([0, 2**40]), ErrorCode.vertex_out_of_range),
        (np.array([0, 2**64 - 1], np.uint64), ErrorCode.vertex_out_of_range),
    ],
    ids=repr,
)
def test_what_is_no_chain_is_refused(vertices, code):
    with pytest.raises(FlattenError) as caught:
        Wire(vertices)
    assert caught.value.code is code


@pytest.mark.parametrize(
    ("tolerance", "code"),
    [
        (-0.01, ErrorCode.invalid_tolerance),
        (-math.inf, ErrorCode.invalid_tolerance),
        (math.nan, ErrorCode.invalid_tolerance),
        ("0.1", ErrorCode.invalid_type),
        (None, ErrorCode.invalid_type),
        (True, ErrorCode.invalid_type),
        (np.True_, ErrorCode.invalid_type),
        ([0.1], ErrorCode.invalid_type),
        (0.1 + 0j, ErrorCode.invalid_type),
        (Fraction(1, 10), ErrorCode.invalid_type),
    ],
    ids=repr,
)
def test_what_is_no_tolerance_is_refused(tolerance, code):
    with pytest.raises(FlattenError) as caught:
        Wire([0, 1], tolerance)
    assert caught.value.code is code


@pytest.mark.parametrize(
    ("ratio", "code"),
    [
        (-1, ErrorCode.invalid_ease),
        (math.inf, ErrorCode.invalid_ease),
        (math.nan, ErrorCode.invalid_ease),
        ("0.1", ErrorCode.invalid_type),
    ],
    ids=repr,
)
def test_what_is_no_ease_is_refused(ratio, code):
    with pytest.raises(FlattenError) as caught:
        Wire([0, 1], ease=ratio)
    assert caught.value.code is code
    with pytest.raises(FlattenError) as caught:
        Ease([(0, 1)], ratio)
    assert caught.value.code is code


def test_an_ease_knows_its_sides_and_is_pickled():
    ease = pickle.loads(pickle.dumps(Ease(np.array([[3, 4], [4, 5]]), 0.05)))
    assert ease.half_edges.tolist() == [[3, 4], [4, 5]]
    assert ease.ratio == 0.05
    assert ease.to_dict() == {"half_edges": [[3, 4], [4, 5]], "ratio": 0.05}
    assert pickle.loads(pickle.dumps(Wire([0, 1], ease=-0.1))).ease == -0.1


@pytest.mark.parametrize("half_edges", [[0, 1], [(0, 1, 2)]])
def test_half_edges_are_pairs(half_edges):
    with pytest.raises(FlattenError) as caught:
        Ease(half_edges, 0.1)
    assert caught.value.code is ErrorCode.invalid_shape


@pytest.mark.parametrize(("name", "why"), [(3, "int"), ("\ud800", "lone surrogates")])
def test_a_wire_name_is_text(name, why):
    with pytest.raises(FlattenError, match=why) as caught:
        Wire([0, 1], name=name)
    assert caught.value.code is ErrorCode.invalid_type


def test_what_a_number_raises_is_not_swallowed():
    class Broken:
        def __index__(self):
            raise OSError("the disk is gone")

    with pytest.raises(OSError, match="the disk is gone"):
        Wire([0, Broken()])


CHANGED = {
    "method": "wirewarping",
    "node_weight": "uniform",
    "inner": "least-norm",
    "fairness": 0.2,
    "max_factorizations": 7,
    "layout": "row",
    "orientation": "boundary",
    "grain": 3,
    "up": (0.0, -2.0, 0.5),
    "gap": 0.5,
    "mirror": True,
    "thickness": 2.5,
    "surface": "outside",
}


METHODS = "'wirewarping' or 'wirewarp++' or 'refined'"


@pytest.mark.parametrize(("name", "value"), CHANGED.items())
def test_an_option_is_the_same_however_it_is_set(name, value):
    later = Options()
    assert getattr(later, name) != value
    setattr(later, name, value)
    assert getattr(later, name) == getattr(Options(**{name: value}), name) == value
    listed = list(value) if isinstance(value, tuple) else value
    assert later.to_dict() == Options().to_dict() | {name: listed}


@pytest.mark.parametrize(
    ("name", "value", "allowed"),
    [
        ("method", "magic", METHODS),
        ("method", 3, METHODS),
        ("method", None, METHODS),
        ("node_weight", "Length", "'length' or 'uniform'"),
        ("inner", "least_norm", "'minimum' or 'least-norm'"),
        ("fairness", 0.0009, "between 0.001 and 10"),
        ("fairness", 10.1, "between 0.001 and 10"),
        ("fairness", -0.1, "between 0.001 and 10"),
        ("fairness", math.nan, "between 0.001 and 10"),
        ("fairness", math.inf, "between 0.001 and 10"),
        ("max_factorizations", 0, "at least 1"),
        ("max_factorizations", -3, "at least 1"),
        ("max_factorizations", 2.5, "a whole number"),
        ("max_factorizations", math.nan, "a whole number"),
        ("max_factorizations", math.inf, "a whole number"),
        ("max_factorizations", 2**40, "at most 2147483647"),
        ("layout", "column", "'packed' or 'row'"),
        ("orientation", "grain", "'wire' or 'boundary' or 'up'"),
        ("grain", -2, "be -1 or the index"),
        ("grain", 0.5, "a whole number"),
        ("grain", 2**40, "at most 2147483647"),
        ("up", (0, 0, 0), "finite and not zero"),
        ("up", (0, math.nan, 1), "finite and not zero"),
        ("up", (0, math.inf, 1), "finite and not zero"),
        ("gap", -0.1, "between 0 and 1"),
        ("gap", 1.5, "between 0 and 1"),
        ("gap", math.nan, "between 0 and 1"),
        ("gap", math.inf, "between 0 and 1"),
        ("thickness", -1, "0 or above"),
        ("thickness", math.inf, "0 or above"),
        ("surface", "top", "'inside' or 'middle' or 'outside'"),
        ("mirror", 1, "True or False"),
        ("mirror", "yes", "True or False"),
    ],
)
def test_an_unknown_value_is_named_with_the_allowed_ones(name, value, allowed):
    options = Options()
    for attempt in (lambda: Options(**{name: value}), lambda: setattr(options, name, value)):
        with pytest.raises(FlattenError) as caught:
            attempt()
        assert caught.value.code is ErrorCode.invalid_option
        assert name in str(caught.value)
        assert repr(value) in str(caught.value)
        assert allowed in str(caught.value)
    assert options.to_dict() == Options().to_dict()


def test_a_numpy_bool_is_a_bool():
    assert Options(mirror=np.True_).mirror is True
    assert Options(mirror=np.False_).mirror is False


@pytest.mark.parametrize("name", ["gap", "fairness", "max_factorizations", "grain"])
@pytest.mark.parametrize("value", ["0.1", None, True])
def test_what_is_to_be_a_number_is_one(name, value):
    with pytest.raises(FlattenError, match=name) as caught:
        Options(**{name: value})
    assert caught.value.code is ErrorCode.invalid_type


@pytest.mark.parametrize(
    ("value", "code"),
    [
        ("up", ErrorCode.invalid_type),
        (("a", "b", "c"), ErrorCode.invalid_type),
        ((True, False, True), ErrorCode.invalid_type),
        (1.0, ErrorCode.invalid_shape),
        ((0, 1), ErrorCode.invalid_shape),
        ([[0, 0, 1]], ErrorCode.invalid_shape),
    ],
)
def test_up_is_three_numbers(value, code):
    with pytest.raises(FlattenError, match="up") as caught:
        Options(up=value)
    assert caught.value.code is code
    assert Options(up=np.array([0, 3, 0], np.int8)).up == (0.0, 3.0, 0.0)


@pytest.mark.parametrize("value", [0.001, 10])
def test_the_limits_of_fairness_are_allowed(value):
    assert Options(fairness=value).fairness == value


@pytest.mark.parametrize("value", [1, np.int64(12), 100.0])
def test_any_whole_number_counts_factorizations(value):
    assert Options(max_factorizations=value).max_factorizations == int(value)


@pytest.mark.parametrize("clone", [copy.copy, copy.deepcopy, lambda value: pickle.loads(pickle.dumps(value))])
def test_options_and_wires_survive_copying_and_pickling(clone):
    options = Options(**CHANGED)
    twin = clone(options)
    assert type(twin) is Options
    assert twin.to_dict() == options.to_dict()
    twin.gap = 0.25
    assert options.gap == CHANGED["gap"]
    wire = clone(Wire([3, 4, 3], math.inf, "bust"))
    assert (wire.vertices.tolist(), wire.tolerance, wire.name) == ([3, 4, 3], math.inf, "bust")


def test_a_wire_that_fits_no_mesh_names_no_vertex_of_one():
    with pytest.raises(FlattenError, match="fewer than two vertices") as caught:
        Wire([1_000_000_000])
    assert caught.value.vertices == ()


def test_an_option_that_does_not_exist_is_an_error():
    with pytest.raises(TypeError, match="wrinkles"):
        Options(wrinkles=3)


def test_options_and_wires_as_plain_values():
    assert json.loads(json.dumps(Wire([0, 1], math.inf, "bust").to_dict(), allow_nan=False)) == {
        "vertices": [0, 1],
        "tolerance": None,
        "name": "bust",
        "ease": 0.0,
    }
    assert repr(Wire(np.arange(5), 0.25, "hem")) == "Wire(vertices=array(5,), tolerance=0.25, name='hem', ease=0)"
    assert "gap=0.5" in repr(Options(gap=0.5))
