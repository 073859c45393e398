# SPDX-License-Identifier: GPL-3.0-or-later
"""A FlattenError has a code with a meaning and a remedy, elements of the mesh, suggestions, and its sentence."""

import copy
import importlib
import json
import pickle
import shutil
from enum import Enum
from pathlib import Path

import numpy as np
import pytest
import wirewarp
from refusals import error_of
from surfaces import half_cylinder, tetrahedron
from wirewarp import Cloth, ErrorCode, FlattenError, Options, flatten

EXAMPLE = FlattenError(
    "flipped_faces",
    "Wire 2 ends inside.",
    [4, 5],
    [(4, 5)],
    [7],
    True,
    proposed_seams=[[3, 4], [4, 6]],
    proposed_tolerances=[(2, 0.015)],
    arguments={"num_overlapping": 3, "has_wires": True},
)


def test_every_code_is_a_string_with_a_meaning_and_a_remedy():
    assert issubclass(ErrorCode, str) and issubclass(ErrorCode, Enum)
    assert ErrorCode.zero_area_face == "zero_area_face"
    for code in ErrorCode:
        assert code.name == code.value
        for sentence in (code.meaning, code.remedy):
            assert sentence[0].isupper() and sentence[-1] == ".", code
    assert len({code.meaning for code in ErrorCode}) == len(ErrorCode)


def test_an_error_is_a_value_error_that_reads_as_its_sentence():
    assert isinstance(EXAMPLE, ValueError) and str(EXAMPLE) == EXAMPLE.message == "Wire 2 ends inside."
    assert EXAMPLE.code is ErrorCode.flipped_faces
    assert (EXAMPLE.vertices, EXAMPLE.edges, EXAMPLE.faces) == ((4, 5), ((4, 5),), (7,))
    assert json.loads(json.dumps(EXAMPLE.to_dict())) == {
        "code": "flipped_faces",
        "message": "Wire 2 ends inside.",
        "vertices": [4, 5],
        "edges": [[4, 5]],
        "faces": [7],
        "has_layout": True,
        "proposed_seams": [[3, 4], [4, 6]],
        "proposed_tolerances": [[2, 0.015]],
        "arguments": {"num_overlapping": 3, "has_wires": True},
    }
    plain = FlattenError("cancelled", "Cancelled.")
    assert (plain.proposed_seams, plain.proposed_tolerances, plain.arguments) == ((), (), {})
    with pytest.raises(ValueError, match="bad_luck"):
        FlattenError("bad_luck", "Something went wrong.")


@pytest.mark.parametrize("clone", [copy.copy, copy.deepcopy, lambda error: pickle.loads(pickle.dumps(error))])
def test_an_error_survives_copying_and_pickling(clone):
    copied = clone(EXAMPLE)
    assert type(copied) is FlattenError and copied.to_dict() == EXAMPLE.to_dict()
    assert str(copied) == str(EXAMPLE)


def flatten_tube() -> None:
    """Raise the error of a tube. Its two outlines are triangles, one twice as large as the other."""
    around = 2 * np.pi * np.arange(3) / 3
    ring = np.stack([np.cos(around), np.sin(around)], axis=1)
    vertices = np.vstack([np.c_[ring, np.zeros(3)], np.c_[2 * ring, np.full(3, 9.0)]])
    faces = [[i, (i + 1) % 3, 3 + i] for i in range(3)] + [[(i + 1) % 3, 3 + (i + 1) % 3, 3 + i] for i in range(3)]
    (piece,) = flatten(vertices, faces).pieces
    raise piece.error


NAMES = ["Hip", "Waist"]
WIRES = [wirewarp.Wire([0, 1], name="Hip"), wirewarp.Wire([1, 0], name="Waist")]


@pytest.mark.parametrize(
    ("call", "code", "arguments"),
    [
        (lambda: Options(gap=2), "invalid_option", {"name": "gap", "value": "2", "allowed": "be between 0 and 1"}),
        (lambda: flatten(*half_cylinder(), seams=[[0, 1], [0, 40]]), "seam_not_an_edge", {}),
        (lambda: flatten(*half_cylinder(), wires=WIRES), "edge_in_two_wires", {"wires": [0, 1], "wire_names": NAMES}),
        (flatten_tube, "boundary_too_short", {"lengths": pytest.approx([6 * np.sqrt(3), 3 * np.sqrt(3)])}),
    ],
    ids=["option", "seam", "wires", "tube"],
)
def test_an_error_carries_the_values_of_its_sentence(call, code, arguments):
    error = error_of(call)
    assert error.code == code and not error.has_layout
    assert code != "seam_not_an_edge" or error.edges == ((0, 40),)
    for name, value in arguments.items():
        assert error.arguments[name] == value
    for name in error.arguments:
        assert f"{name}: " in error.code.arguments or f"{name}, " in error.code.arguments
    assert pickle.loads(pickle.dumps(error)).arguments == error.arguments
    json.dumps(error.to_dict())


def test_proposed_seams_can_be_passed_as_seams():
    vertices, faces = tetrahedron()
    (piece,) = flatten(vertices, faces).pieces
    proposed = piece.error.proposed_seams
    assert len(proposed) > 0
    result = flatten(vertices, faces, seams=proposed)
    assert all(piece.error is None for piece in result.pieces)


def test_seams_are_proposed_for_a_piece_that_only_the_stretch_makes_infeasible():
    """The stretch shortens the legs of a triangle to a fifth, so its base becomes too long.

    The base is sewn to a square, which would keep its length. Both get the mean of both lengths, three fifths.
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


def test_the_package_works_inside_another_package(tmp_path, monkeypatch):
    shutil.copytree(Path(wirewarp.__file__).parent, tmp_path / "carrier" / "wirewarp")
    monkeypatch.syspath_prepend(tmp_path)
    inner = importlib.import_module("carrier.wirewarp")
    with pytest.raises(inner.FlattenError) as caught:
        inner.Wire([0])
    assert caught.value.code is inner.ErrorCode.wire_too_short and not isinstance(caught.value, FlattenError)
    assert inner.flatten(*half_cylinder()).pieces[0].error is None
