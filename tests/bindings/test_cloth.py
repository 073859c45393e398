# SPDX-License-Identifier: GPL-3.0-or-later
"""A Cloth is checked when it is created, and Options accept it."""

import copy
import json
import math
import pickle

import numpy as np
import pytest
from surfaces import column_chain, spherical_patch
from wirewarp import Cloth, ErrorCode, FlattenError, Options, Wire, flatten


def test_a_cloth_keeps_what_it_was_given():
    cloth = Cloth(0.2, 1, np.float32(0.25), squeeze=2, stretch=(0.2, 0), locking=0.5, limits=np.array([0.03, 0.04]))
    assert (cloth.weft, cloth.warp, cloth.shear, cloth.squeeze) == (0.2, 1.0, 0.25, 2.0)
    assert (cloth.stretch, cloth.locking, cloth.limits) == ((0.2, 0.0), 0.5, (0.03, 0.04))
    plain = Cloth()
    assert (plain.weft, plain.warp, plain.shear, plain.squeeze) == (1.0, 1.0, 0.5, 1.0)
    assert (plain.stretch, plain.locking, plain.limits) == ((0.0, 0.0), None, None)


def test_a_checked_cloth_cannot_be_changed():
    with pytest.raises(AttributeError):
        Cloth().weft = -1.0


MADE = Cloth(1, 2, 0.1, squeeze=3, stretch=(0, 0.1), locking=0.7, limits=(0.1, 0.2))


@pytest.mark.parametrize("cloth", [Cloth(), MADE], ids=repr)
def test_copies_and_pickles_are_equal(cloth):
    assert copy.deepcopy(cloth) == pickle.loads(pickle.dumps(cloth)) == cloth
    options = Options(cloth=cloth, grain_angle=0.25)
    assert copy.deepcopy(options).cloth == pickle.loads(pickle.dumps(options)).cloth == cloth
    assert json.loads(json.dumps(options.to_dict()))["cloth"]["weft"] == cloth.weft


@pytest.mark.parametrize("name", Cloth.presets())
def test_a_preset_goes_by_its_name(name):
    assert Options(cloth=name).cloth == Cloth.preset(name)
    assert Options(cloth=name).cloth != Cloth()


@pytest.mark.parametrize("name", ["lace", 3, None], ids=repr)
def test_there_is_no_other_preset(name):
    with pytest.raises(FlattenError) as caught:
        Cloth.preset(name)
    assert caught.value.code is ErrorCode.invalid_option


def test_options_that_do_not_go_together_are_refused_when_they_are_set():
    options = Options(cloth="woven")
    for name, value in (("method", "wirewarp++"), ("surface", "top"), ("thickness", -1)):
        with pytest.raises(FlattenError) as caught:
            setattr(options, name, value)
        assert caught.value.code is ErrorCode.invalid_option
    options.orientation = "best"
    with pytest.raises(FlattenError, match="without a cloth"):
        options.cloth = None
    with pytest.raises(FlattenError, match="without a cloth"):
        Options().orientation = "best"


def test_options_have_no_cloth_by_default():
    options = Options()
    assert options.cloth is None
    options.cloth = "jersey"
    options.cloth = None
    assert options.cloth is None


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"weft": 0}, "weft is 0"),
        ({"warp": -1}, "warp is -1"),
        ({"shear": math.nan}, "shear is nan"),
        ({"weft": 1e9}, "no stiffness more than"),
        ({"squeeze": 0}, "squeeze is 0"),
        ({"locking": 2}, "locking is 2"),
        ({"limits": (-1, 0)}, "limit is -1"),
        ({"stretch": (0, -1)}, "stretch is -1"),
    ],
)
def test_what_is_no_cloth_is_refused(arguments, words):
    with pytest.raises(FlattenError, match=words) as caught:
        Cloth(**arguments)
    assert caught.value.code is ErrorCode.invalid_option


@pytest.mark.parametrize(
    "arguments", [{"limits": (1, 2, 3)}, {"limits": "wide"}, {"weft": "soft"}, {"locking": [1]}], ids=repr
)
def test_other_types_are_refused(arguments):
    with pytest.raises(FlattenError) as caught:
        Cloth(**arguments)
    assert caught.value.code in (ErrorCode.invalid_type, ErrorCode.invalid_shape)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"cloth": "lace"}, "'woven' or 'denim'"),
        ({"cloth": 7}, "None, a Cloth or the name of one"),
        ({"cloth": "woven", "method": "wirewarp++"}, "it must be refined"),
        ({"orientation": "best"}, "without a cloth"),
        ({"grain_angle": 7}, "grain_angle is 7"),
    ],
)
def test_options_that_do_not_go_together_are_refused(options, words):
    with pytest.raises(FlattenError, match=words) as caught:
        Options(**options)
    assert caught.value.code is ErrorCode.invalid_option


def test_metrics_tell_the_strain_of_threads_with_and_without_a_cloth():
    vertices, faces = spherical_patch()
    marked = [Wire(column_chain(8, 8, 4))]
    plain = flatten(vertices, faces, wires=marked).pieces[0].metrics
    woven = flatten(vertices, faces, wires=marked, options=Options(cloth="woven")).pieces[0].metrics
    assert math.isnan(plain.cloth_energy)
    assert woven.cloth_energy > 0
    for metrics in (plain, woven):
        for measured in (metrics.face_weft_strain, metrics.face_warp_strain, metrics.face_shear_angle):
            assert measured.shape == (len(faces),)
            assert np.isfinite(measured).all()
    assert np.abs(woven.face_shear_angle).max() > np.abs(plain.face_shear_angle).max()
    assert np.square(woven.face_weft_strain).sum() < np.square(plain.face_weft_strain).sum()


def test_a_piece_that_only_the_stretch_spoils_is_cut_at_its_stretched_lengths():
    """A slim triangle is joined to a square by a seam that runs across the grain of one and along that of the other.

    The stretch leaves a fifth of the triangle's legs, but three times as much of the seam.
    """
    around = [(i / 4, 0, 0) for i in range(5)] + [(0.5, 0.08, 0)]
    vertices = [*around, *((i / 4, 0, -1) for i in range(5))]
    faces = [(i, i + 1, 5) for i in range(4)]
    faces += [face for i in range(4) for face in ((i, 6 + i, 7 + i), (i, 7 + i, i + 1))]
    seams = [(i, i + 1) for i in range(4)]
    fabric = {"orientation": "up", "up": (0.1, 1, 0)}
    stretched = Options(**fabric, cloth=Cloth(stretch=(4, 0)))
    plain = Options(**fabric, cloth=Cloth())
    assert all(piece.error is None for piece in flatten(vertices, faces, seams=seams, options=plain).pieces)
    error = flatten(vertices, faces, seams=seams, options=stretched).pieces[0].error
    assert error.arguments["reason"] == "stretch"
    assert "use less stretch, or mark a seam, such as along edge" in str(error)
    cut = flatten(vertices, faces, seams=[*seams, *error.proposed_seams], options=stretched)
    assert [piece.error for piece in cut.pieces] == [None, None, None]
