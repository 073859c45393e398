# SPDX-License-Identifier: GPL-3.0-or-later
"""Which arrays are accepted, with equal results, and how the others are refused."""

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


# test_any_arrays.py draws all other arrangements at random.
ARRANGED = {"list": np.ndarray.tolist, "tuple of rows": tuple, "unaligned": unaligned}


@pytest.mark.parametrize("arrange", ARRANGED.values(), ids=ARRANGED)
def test_memory_layout_of_the_arrays_does_not_matter(arrange):
    result = wirewarp.flatten(arrange(VERTICES), arrange(FACES), seams=arrange(np.array(SEAMS)))
    assert np.array_equal(result.corner_uv, EXPECTED)


@pytest.mark.parametrize("dtype", ["f2", "f4", "g", "i4", "u8"])
def test_every_real_dtype_is_read_as_the_doubles_it_stands_for(dtype):
    vertices = (VERTICES * 8 + 16).astype(dtype)
    expected = wirewarp.flatten(vertices.astype(float), FACES).corner_uv
    assert np.array_equal(wirewarp.flatten(vertices, FACES).corner_uv, expected)


@pytest.mark.parametrize("seams", [None, [], (), np.empty((0, 2)), np.empty((0, 2), int)], ids=repr)
def test_no_seams(seams):
    assert len(wirewarp.flatten(VERTICES, FACES, seams=seams).pieces) == 1


def refused(code, **arguments):
    """Return the FlattenError of flatten() or, with corner_uv, of measure()."""
    arguments = {"vertices": VERTICES, "faces": FACES} | arguments
    run = wirewarp.measure if "corner_uv" in arguments else wirewarp.flatten
    with pytest.raises(wirewarp.FlattenError) as caught:
        run(**arguments)
    assert caught.value.code is code
    return caught.value


@pytest.mark.parametrize(
    ("name", "value", "shape"),
    [
        ("vertices", np.zeros((4, 2)), "(4, 2)"),
        ("vertices", np.zeros(12), "(12,)"),
        ("vertices", 1.5, "()"),
        ("faces", [[0, 1, 2, 3]], "(1, 4)"),
        ("faces", [0, 1, 2], "(3,)"),
        ("seams", [[0, 1, 2]], "(1, 3)"),
        ("seams", np.zeros((0, 3), int), "(0, 3)"),
        ("corner_uv", np.zeros((len(FACES), 6)), f"({len(FACES)}, 6)"),
        ("corner_uv", np.zeros((1, 3, 2)), "1"),
        ("vertices", [[0.0, 1.0], [2.0]], "inhomogeneous"),
    ],
    ids=str,
)
def test_a_wrong_shape_is_named(name, value, shape):
    error = refused(wirewarp.ErrorCode.invalid_shape, **{name: value})
    assert name in str(error)
    assert shape in str(error)


@pytest.mark.parametrize(
    ("name", "value", "kind"),
    [
        ("vertices", None, "NoneType"),
        ("vertices", "abc", "str"),
        ("vertices", VERTICES.astype(object), "object"),
        ("vertices", VERTICES.astype(complex), "complex"),
        ("vertices", VERTICES > 0, "bool"),
        ("vertices", VERTICES.astype(str), "U"),
        ("vertices", np.ma.masked_greater(VERTICES, 0.5), "masked"),
        ("faces", np.ma.masked_equal(FACES, 3), "masked"),
        ("faces", FACES.astype(float), "float64"),
        ("faces", FACES > 0, "bool"),
        ("faces", [[0, 1, None]], "object"),
        ("faces", object(), "object"),
        ("seams", [[0.0, 1.0]], "float64"),
        ("corner_uv", None, "NoneType"),
        ("wires", [[0, 1]], "list"),
        ("wires", wirewarp.Wire([0, 1]), "Wire"),
        ("wires", None, "NoneType"),
        ("options", {"mirror": True}, "dict"),
        ("progress", 3, "int"),
    ],
    ids=str,
)
def test_a_wrong_type_is_named(name, value, kind):
    error = refused(wirewarp.ErrorCode.invalid_type, **{name: value})
    assert name in str(error)
    assert kind in str(error)


@pytest.mark.parametrize("index", [len(VERTICES), -1, 2**31 - 1, 2**31, 2**32, -(2**40), 2**63 - 1, 2**63])
def test_a_face_that_names_no_vertex_is_named(index):
    faces = FACES.astype(np.uint64 if index > 2**62 else np.int64)
    faces[5, 1] = index
    error = refused(wirewarp.ErrorCode.vertex_out_of_range, faces=faces)
    assert error.faces == (5,)
    assert str(index) in str(error)


@pytest.mark.parametrize("index", [len(VERTICES), -1, 2**32])
def test_a_seam_that_names_no_vertex_is_refused(index):
    error = refused(wirewarp.ErrorCode.vertex_out_of_range, seams=np.array([[0, 1], [1, index]], dtype=np.int64))
    assert str(index) in str(error)
    assert "use indices of this mesh" in str(error)


def test_a_seam_beyond_any_mesh_names_its_edge():
    error = refused(wirewarp.ErrorCode.vertex_out_of_range, seams=[[0, 1], [7, 2**35]])
    assert "Seam edge 1 (7-34359738368)" in str(error)


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ({"vertices": [], "faces": []}, wirewarp.ErrorCode.empty_mesh),
        ({"faces": np.zeros((0, 3))}, wirewarp.ErrorCode.empty_mesh),
        ({"vertices": np.where(VERTICES[7] == VERTICES, np.nan, VERTICES)}, wirewarp.ErrorCode.non_finite_coordinates),
        ({"seams": [[0, 20]]}, wirewarp.ErrorCode.seam_not_an_edge),
        ({"wires": [wirewarp.Wire([0, 20])]}, wirewarp.ErrorCode.wire_not_an_edge),
        ({"wires": [wirewarp.Wire([9, 10, 11]), wirewarp.Wire([11, 10])]}, wirewarp.ErrorCode.edge_in_two_wires),
    ],
    ids=lambda value: str(value) if isinstance(value, str) else "",
)
def test_what_the_core_refuses_is_raised(arguments, code):
    refused(code, **arguments)


def test_what_an_array_like_raises_is_not_swallowed():
    class Broken:
        def __array__(self, *args, **kwargs):
            raise OSError("the disk is gone")

    with pytest.raises(OSError, match="the disk is gone"):
        wirewarp.flatten(Broken(), FACES)
