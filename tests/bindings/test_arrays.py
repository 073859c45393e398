# SPDX-License-Identifier: GPL-3.0-or-later
"""Any arguments give the result of plain arrays of the same numbers, or a FlattenError that names the invalid array.

No arguments cause a crash, and the caller's arrays do not change.
"""

import numpy as np
import pytest
import wirewarp
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from surfaces import chain_edges, column_chain, half_cylinder

VERTICES, FACES = half_cylinder()
SEAMS = chain_edges(column_chain(8, 4, 4))
EXPECTED = wirewarp.flatten(VERTICES, FACES, seams=SEAMS).corner_uv.copy()

NUMBERS = st.one_of(hnp.integer_dtypes(), hnp.unsigned_integer_dtypes(), hnp.floating_dtypes(), hnp.boolean_dtypes())
ANY_DTYPE = st.one_of(NUMBERS, hnp.complex_number_dtypes(), hnp.byte_string_dtypes(), hnp.datetime64_dtypes())
ANY_SHAPE = hnp.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=5)
HUGE = st.one_of(st.integers(-3, 200), st.sampled_from([2**31 - 1, 2**31, -(2**31) - 1, 2**63 - 1, -(2**63), 2**64]))


def unaligned(array):
    """Return a copy of the array at an odd address."""
    raw = np.zeros(array.nbytes + 1, dtype=np.uint8)[1:]
    result = raw.view(array.dtype).reshape(array.shape)
    result[:] = array
    return result


ARRANGED = {"list": np.ndarray.tolist, "tuple of rows": tuple, "unaligned": unaligned}


@pytest.mark.parametrize("arrange", ARRANGED.values(), ids=ARRANGED)
def test_memory_layout_of_the_arrays_does_not_matter(arrange):
    result = wirewarp.flatten(arrange(VERTICES), arrange(FACES), seams=arrange(np.array(SEAMS)))
    assert np.array_equal(result.corner_uv, EXPECTED)


@pytest.mark.parametrize("seams", [None, [], (), np.empty((0, 2)), np.empty((0, 2), int)], ids=repr)
def test_no_seams(seams):
    assert len(wirewarp.flatten(VERTICES, FACES, seams=seams).pieces) == 1


# Keyed by error code: (argument of flatten() or measure(), bad value, words of the error).
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
    # numpy converts an empty list to an array of floats, so floats are allowed here.
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


READ = {  # methods with which arguments are read
    "__array__": lambda broken: wirewarp.flatten(broken, FACES),
    "__index__": lambda broken: wirewarp.Wire([0, broken]),
}


@pytest.mark.parametrize("method", READ)
def test_exceptions_of_arrays_and_numbers_are_not_swallowed(method):
    def fail(*args, **kwargs):
        raise OSError("the disk is gone")

    with pytest.raises(OSError, match="the disk is gone"):
        READ[method](type("Broken", (), {method: fail})())


@st.composite
def rearranged(draw, array):
    """Return the same numbers in another dtype, order, stride or writability."""
    kinds = ("i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", "f2", "f4", "f8", "g")
    held = [kind for kind in kinds if (array >= 0).all() or not kind.startswith("u")]
    held = [kind for kind in held if (array.astype(kind) == array).all()]
    dtype = np.dtype(draw(st.sampled_from(held))).newbyteorder(draw(st.sampled_from("<>")))
    steps = draw(st.tuples(st.sampled_from([1, 2, 3, -1, -2]), st.sampled_from([1, 2, -1])))
    wide = np.zeros([abs(step) * size for step, size in zip(steps, array.shape, strict=True)], dtype=dtype)
    if draw(st.booleans()):
        wide = np.asfortranarray(wide)
    view = wide[:: steps[0], :: steps[1]]
    view[:] = array
    view.flags.writeable = draw(st.booleans())
    return view


@given(st.data())
def test_any_arrangement_of_the_same_numbers_gives_the_same_bits(data):
    # The coordinates are rounded to whole numbers, so that they fit into small dtypes.
    plain = {"vertices": np.round(VERTICES * 8), "faces": FACES, "seams": np.array(SEAMS)}
    passed = {name: data.draw(rearranged(array)) for name, array in plain.items()}
    before = [array.copy() for array in passed.values()]
    if any(np.issubdtype(passed[name].dtype, np.floating) for name in ("faces", "seams")):
        with pytest.raises(wirewarp.FlattenError) as caught:  # indices must be whole numbers
            wirewarp.flatten(**passed)
        assert caught.value.code == "invalid_type"
    else:
        assert np.array_equal(wirewarp.flatten(**passed).corner_uv, wirewarp.flatten(**plain).corner_uv)
    for array, copy in zip(passed.values(), before, strict=True):
        assert np.array_equal(array, copy)


def result_or_refusal(call):
    """Return the result of the call, or None if it raises a FlattenError with a sentence."""
    try:
        result = call()
    except wirewarp.FlattenError as error:
        assert str(error).endswith(".")
        return None
    assert result is not None
    return result


def flattens_or_refuses(**arguments):
    result = result_or_refusal(lambda: wirewarp.flatten(**{"vertices": VERTICES, "faces": FACES} | arguments))
    assert result is None or result.corner_uv.shape == (len(arguments.get("faces", FACES)), 3, 2)


@given(st.sampled_from(["vertices", "faces", "seams"]), hnp.arrays(ANY_DTYPE, ANY_SHAPE))
def test_any_array_is_flattened_or_refused(argument, array):
    flattens_or_refuses(**{argument: array})


@pytest.mark.parametrize(("argument", "size"), [("faces", 3), ("seams", 2)])
@given(st.data())
def test_any_faces_and_seams_are_flattened_or_refused(argument, size, data):
    rows = st.lists(HUGE, min_size=size, max_size=size)
    flattens_or_refuses(**{argument: data.draw(st.lists(rows, max_size=6))})


@given(st.lists(HUGE, max_size=6), st.one_of(st.floats(), st.integers(), st.none(), st.text(max_size=3)), st.text())
def test_any_wire_is_flattened_or_refused(vertices, tolerance, name):
    wire = result_or_refusal(lambda: wirewarp.Wire(vertices, tolerance=tolerance, name=name))
    if wire is not None:
        flattens_or_refuses(wires=[wire])


@given(hnp.arrays(NUMBERS, st.one_of(ANY_SHAPE, st.just((len(FACES), 3, 2)))))
def test_any_corner_coordinates_are_measured_or_refused(corner_uv):
    result = result_or_refusal(lambda: wirewarp.measure(VERTICES, FACES, corner_uv))
    assert result is None or len(result.pieces) == 1
