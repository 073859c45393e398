# SPDX-License-Identifier: GPL-3.0-or-later
"""Wire, Ease, Options and Cloth check their values when they are made, and can be copied and printed."""

import array
import copy
import json
import math
import pickle
from fractions import Fraction

import numpy as np
import pytest
from refusals import code_of, error_of
from wirewarp import Cloth, Ease, ErrorCode, FlattenError, Options, Wire


@pytest.mark.parametrize(
    "vertices",
    [
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


def test_a_checked_value_cannot_be_changed():
    wire = Wire([0, 1])
    with pytest.raises(ValueError, match="read-only"):
        wire.vertices[0] = -5
    for value, name in ((wire, "tolerance"), (Cloth(), "weft")):
        with pytest.raises(AttributeError):
            setattr(value, name, -1.0)


CHAINS = {
    ErrorCode.invalid_type: [
        [0, True],
        np.array([True, False]),
        [0, 1.0],
        np.array([0.0, 1.0]),
        [0, None],
        "01",
        b"01",
        bytearray(b"01"),
        np.ma.array([0, 1, 2], mask=[False, True, False]),
        {0, 1},
        7,
    ],
    ErrorCode.invalid_shape: [np.array([[0, 1]])],
    ErrorCode.wire_too_short: [[], np.array([4])],
    ErrorCode.vertex_out_of_range: [[0, 2**31], [0, -(2**80)], np.array([0, 2**40]), np.array([0, 2**64 - 1], "u8")],
}


@pytest.mark.parametrize("code", CHAINS, ids=str)
def test_invalid_chains_are_refused(code):
    for vertices in CHAINS[code]:
        assert code_of(lambda vertices=vertices: Wire(vertices)) is code, repr(vertices)
    for half_edges in ([0, 1], [(0, 1, 2)]):
        assert code_of(lambda half_edges=half_edges: Ease(half_edges, 0.1)) is ErrorCode.invalid_shape


NUMBERS = {
    "tolerance": (lambda value: Wire([0, 1], value), ErrorCode.invalid_tolerance, [-0.01, -math.inf, math.nan]),
    "ease of a wire": (lambda value: Wire([0, 1], ease=value), ErrorCode.invalid_ease, [-1, math.inf, math.nan]),
    "ease": (lambda value: Ease([(0, 1)], value), ErrorCode.invalid_ease, [-1, math.inf, math.nan]),
    "fairness": (lambda value: Options(fairness=value), ErrorCode.invalid_option, [0.0009, 10.1, math.nan]),
    "max_factorizations": (lambda value: Options(max_factorizations=value), ErrorCode.invalid_option, [0, 2.5, 2**40]),
    "thickness": (lambda value: Options(thickness=value), ErrorCode.invalid_option, [-1, math.inf]),
    "weft": (lambda value: Cloth(weft=value), ErrorCode.invalid_option, [0, math.nan, 1e9]),
}


@pytest.mark.parametrize("name", NUMBERS)
def test_numbers_are_checked_with_their_ranges(name):
    make, code, outside = NUMBERS[name]
    for value in outside:
        assert code_of(lambda value=value: make(value)) is code, value
    for value in ("0.1", None, True, np.True_, [0.1], 0.1 + 0j, Fraction(1, 10)):
        assert code_of(lambda value=value: make(value)) is ErrorCode.invalid_type, repr(value)


def test_ends_of_ranges_are_allowed():
    assert [Options(fairness=value).fairness for value in (0.001, 10)] == [0.001, 10]
    assert [Options(max_factorizations=value).max_factorizations for value in (1, np.int64(12), 1e2)] == [1, 12, 100]
    assert Wire([0, 1], tolerance=np.float32(0.25)).tolerance == 0.25
    assert [Options(mirror=value).mirror for value in (np.True_, np.False_)] == [True, False]


@pytest.mark.parametrize(("name", "why"), [(3, "int"), ("\ud800", "lone surrogates"), ("a\0b", r"NUL.*\.$")])
def test_a_wire_name_is_text(name, why):
    with pytest.raises(FlattenError, match=why) as caught:
        Wire([0, 1], name=name)
    assert caught.value.code is ErrorCode.invalid_type


MADE = Cloth(0.2, 1, np.float32(0.25), squeeze=2, stretch=(0.2, 0), locking=0.5, limits=np.array([0.03, 0.04]))
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
    "cloth": MADE,
    "grain_angle": 0.25,
}


@pytest.mark.parametrize("name", Options().to_dict())
def test_an_option_is_the_same_however_it_is_set(name):
    later, value = Options(), CHANGED[name]
    setattr(later, name, value)
    assert getattr(later, name) == getattr(Options(**{name: value}), name) == value
    plain = value.to_dict() if name == "cloth" else list(value) if isinstance(value, tuple) else value
    assert later.to_dict() == Options().to_dict() | {name: plain} != Options().to_dict()


@pytest.mark.parametrize(
    ("name", "value", "allowed"),
    [
        *(("method", value, "'wirewarping' or 'wirewarp++' or 'refined'") for value in ("magic", 3, None)),
        ("node_weight", "Length", "'length' or 'uniform'"),
        ("inner", "least_norm", "'minimum' or 'least-norm'"),
        ("fairness", -0.1, "between 0.001 and 10"),
        ("max_factorizations", -3, "at least 1"),
        ("max_factorizations", math.nan, "a whole number"),
        ("max_factorizations", math.inf, "a whole number"),
        ("layout", "column", "'packed' or 'row'"),
        ("orientation", "Wire", "'wire' or 'boundary' or 'up' or 'best' or 'grain'"),
        ("grain", -2, "be -1 or the index"),
        ("grain", 0.5, "a whole number"),
        ("grain", 2**40, "at most 2147483647"),
        ("up", (0, 0, 0), "finite and not zero"),
        ("gap", 1.5, "between 0 and 1"),
        ("thickness", -1, "0 or above"),
        ("surface", "top", "'inside' or 'middle' or 'outside'"),
        ("mirror", 1, "True or False"),
        ("cloth", "lace", "'woven' or 'denim'"),
        ("cloth", 7, "None, a Cloth or the name of a fabric"),
        ("grain_angle", 7, "grain_angle is 7"),
    ],
)
def test_an_unknown_value_is_named_with_the_allowed_values(name, value, allowed):
    options = Options()
    for attempt in (lambda: Options(**{name: value}), lambda: setattr(options, name, value)):
        error = error_of(attempt)
        assert error.code is ErrorCode.invalid_option
        assert all(words in str(error) for words in (name, str(value), allowed))
    assert options.to_dict() == Options().to_dict()


def test_contradicting_options_are_refused():
    options = Options(cloth="woven")
    with pytest.raises(FlattenError, match="it must be refined"):
        options.method = "wirewarp++"
    options.orientation = "best"
    for attempt in (lambda: setattr(options, "cloth", None), lambda: Options(orientation="best")):
        with pytest.raises(FlattenError, match="if there is no cloth"):
            attempt()


def test_up_is_three_numbers():
    for value in ("up", (True, False, True)):
        assert code_of(lambda value=value: Options(up=value)) is ErrorCode.invalid_type
    for value in (1.0, (0, 1), [[0, 0, 1]]):
        assert code_of(lambda value=value: Options(up=value)) is ErrorCode.invalid_shape
    assert Options(up=np.array([0, 3, 0], np.int8)).up == (0.0, 3.0, 0.0)


def test_an_option_that_does_not_exist_is_an_error():
    with pytest.raises(TypeError, match="wrinkles"):
        Options(wrinkles=3)


def test_a_cloth_keeps_its_given_values():
    assert (MADE.weft, MADE.warp, MADE.shear, MADE.squeeze) == (0.2, 1.0, 0.25, 2.0)
    assert (MADE.stretch, MADE.locking, MADE.limits) == ((0.2, 0.0), 0.5, (0.03, 0.04))
    plain = Cloth()
    assert (plain.weft, plain.warp, plain.shear, plain.squeeze) == (1.0, 1.0, 0.5, 1.0)
    assert (plain.stretch, plain.locking, plain.limits) == ((0.0, 0.0), None, None)


def test_a_preset_is_found_by_its_name_only():
    for name in Cloth.presets():
        assert Options(cloth=name).cloth == Cloth.preset(name) != Cloth()
    for name in ("lace", 3, None):
        assert code_of(lambda name=name: Cloth.preset(name)) is ErrorCode.invalid_option


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"warp": -1}, "warp is -1"),
        ({"shear": math.nan}, "shear is nan"),
        ({"weft": 1e9}, "no stiffness more than"),
        ({"squeeze": 0}, "squeeze is 0"),
        ({"locking": 2}, "locking is 2"),
        ({"limits": (-1, 0)}, "limit is -1"),
        ({"stretch": (0, -1)}, "stretch is -1"),
        ({"limits": (1, 2, 3)}, r"\(3,\)"),
        ({"limits": "wide"}, "limits"),
        ({"locking": [1]}, "locking"),
    ],
)
def test_invalid_fabrics_are_refused(arguments, words):
    with pytest.raises(FlattenError, match=words):
        Cloth(**arguments)


PROTOCOLS = [lambda value, p=p: pickle.loads(pickle.dumps(value, p)) for p in range(pickle.HIGHEST_PROTOCOL + 1)]


@pytest.mark.parametrize("clone", [copy.copy, copy.deepcopy, *PROTOCOLS])
def test_arguments_survive_copying_and_pickling(clone):
    ease = Ease(np.array([[3, 4], [4, 5]]), 0.05)
    for value in (Wire([3, 4, 3], math.inf, "bust", ease=-0.1), ease, MADE, Options(**CHANGED | {"method": "refined"})):
        copied = clone(value)
        assert type(copied) is type(value) and copied.to_dict() == value.to_dict()
    assert clone(MADE) == MADE != Cloth() and MADE not in (None, "woven")
    copied.gap = 0.25
    assert value.gap == CHANGED["gap"]


def test_arguments_as_plain_values():
    wire = {"vertices": [0, 1], "tolerance": None, "name": "bust", "ease": 0.0}
    assert json.loads(json.dumps(Wire([0, 1], math.inf, "bust").to_dict(), allow_nan=False)) == wire
    assert Ease(np.array([[3, 4], [4, 5]]), 0.05).to_dict() == {"half_edges": [[3, 4], [4, 5]], "ratio": 0.05}
    assert json.loads(json.dumps(Options(cloth=MADE).to_dict()))["cloth"]["weft"] == MADE.weft
    assert repr(Wire(np.arange(5), 0.25, "hem")) == "Wire(vertices=array(5,), tolerance=0.25, name='hem', ease=0)"
    assert "gap=0.5" in repr(Options(gap=0.5))
