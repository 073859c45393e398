# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays of every layout lead to equal results, and the errors about invalid arrays contain their names."""

import numpy as np
import pytest
import wirewarp
from surfaces import chain_edges, column_chain, half_cylinder

VERTICES, FACES = half_cylinder()
SEAMS = chain_edges(column_chain(8, 4, 4))
EXPECTED = wirewarp.flatten(VERTICES, FACES, seams=SEAMS).corner_uv.copy()


def unaligned(array):
    """Return the same values at an odd address."""
    raw = np.zeros(array.nbytes + 1, dtype=np.uint8)[1:]
    result = raw.view(array.dtype).reshape(array.shape)
    result[:] = array
    return result


# test_any_arrays.py draws other types and arrangements at random.
ARRANGED = {"list": np.ndarray.tolist, "tuple of rows": tuple, "unaligned": unaligned}


@pytest.mark.parametrize("arrange", ARRANGED.values(), ids=ARRANGED)
def test_memory_layout_of_the_arrays_does_not_matter(arrange):
    result = wirewarp.flatten(arrange(VERTICES), arrange(FACES), seams=arrange(np.array(SEAMS)))
    assert np.array_equal(result.corner_uv, EXPECTED)


@pytest.mark.parametrize("seams", [None, [], (), np.empty((0, 2)), np.empty((0, 2), int)], ids=repr)
def test_no_seams(seams):
    assert len(wirewarp.flatten(VERTICES, FACES, seams=seams).pieces) == 1


# Keyed by code: an argument of flatten() or measure(), a bad value, and words of the error.
REFUSED = {
    wirewarp.ErrorCode.invalid_shape: [
        ("vertices", np.zeros((4, 2)), "(4, 2)"),
        ("vertices", 1.5, "()"),
        ("vertices", [[0.0, 1.0], [2.0]], "inhomogeneous"),
        ("faces", [0, 1, 2], "(3,)"),
        ("seams", np.zeros((0, 3), int), "(0, 3)"),
        ("corner_uv", np.zeros((len(FACES), 6)), f"({len(FACES)}, 6)"),
        ("corner_uv", np.zeros((1, 3, 2)), "1"),
    ],
    wirewarp.ErrorCode.invalid_type: [
        ("vertices", None, "NoneType"),
        ("vertices", VERTICES.astype(object), "object"),
        ("vertices", VERTICES > 0, "bool"),
        ("vertices", np.ma.masked_greater(VERTICES, 0.5), "masked"),
        ("faces", FACES.astype(float), "float64"),
        ("faces", FACES > 0, "bool"),
        ("seams", [[0.0, 1.0]], "float64"),
        ("corner_uv", None, "NoneType"),
        ("wires", [[0, 1]], "list"),
        ("wires", wirewarp.Wire([0, 1]), "Wire"),
        ("options", {"mirror": True}, "dict"),
        ("progress", 3, "int"),
        ("cache", {}, "dict"),
    ],
    wirewarp.ErrorCode.vertex_out_of_range: [
        *(("faces", [[0, 1, 9], [0, index, 1]], str(index)) for index in (len(VERTICES), -1, 2**31, -(2**40))),
        ("faces", np.array([[0, 1, 9], [0, 2**63, 1]], dtype=np.uint64), str(2**63)),
        ("seams", [[0, 1], [1, len(VERTICES)]], "use indices of this mesh"),
        ("seams", [[0, 1], [7, 2**35]], "Seam edge 1 (7-34359738368)"),
    ],
    wirewarp.ErrorCode.non_finite_coordinates: [("vertices", np.vstack([[[np.nan] * 3], VERTICES[1:]]), "vertex 0")],
    # numpy converts an empty list to an array of floats
    wirewarp.ErrorCode.empty_mesh: [("faces", np.zeros((0, 3)), "")],
}


@pytest.mark.parametrize("code", REFUSED, ids=str)
def test_bad_arguments_are_named(code):
    for name, value, words in REFUSED[code]:
        arguments = {"vertices": VERTICES, "faces": FACES, name: value}
        with pytest.raises(wirewarp.FlattenError) as caught:
            (wirewarp.measure if name == "corner_uv" else wirewarp.flatten)(**arguments)
        assert caught.value.code is code
        assert words in str(caught.value), (name, value)
        assert name in str(caught.value) or code not in ("invalid_shape", "invalid_type"), (name, value)
        assert caught.value.faces == ((1,) if (name, code) == ("faces", "vertex_out_of_range") else ())


def test_exceptions_of_array_likes_are_not_swallowed():
    class Broken:
        def __array__(self, *args, **kwargs):
            raise OSError("the disk is gone")

    with pytest.raises(OSError, match="the disk is gone"):
        wirewarp.flatten(Broken(), FACES)
