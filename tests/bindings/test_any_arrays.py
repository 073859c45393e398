# SPDX-License-Identifier: GPL-3.0-or-later
"""Any arguments lead to the same result as plain arrays of the same numbers, or to a FlattenError.

They never cause a crash or change the caller's arrays.
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

# Includes byte orders, sizes and kinds that the library does not use itself.
NUMBERS = st.one_of(hnp.integer_dtypes(), hnp.unsigned_integer_dtypes(), hnp.floating_dtypes(), hnp.boolean_dtypes())
ANY_DTYPE = st.one_of(NUMBERS, hnp.complex_number_dtypes(), hnp.byte_string_dtypes(), hnp.datetime64_dtypes())
ANY_SHAPE = hnp.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=5)
HUGE = st.one_of(st.integers(-3, 200), st.sampled_from([2**31 - 1, 2**31, -(2**31) - 1, 2**63 - 1, -(2**63), 2**64]))


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
    # Numbers that also fit into small dtypes.
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


def flattens_or_refuses(**arguments):
    try:
        result = wirewarp.flatten(**{"vertices": VERTICES, "faces": FACES} | arguments)
    except wirewarp.FlattenError as error:
        assert str(error).endswith(".")
    else:
        assert result.corner_uv.shape == (len(arguments.get("faces", FACES)), 3, 2)


@given(st.sampled_from(["vertices", "faces", "seams"]), hnp.arrays(ANY_DTYPE, ANY_SHAPE))
def test_any_array_is_flattened_or_refused(argument, array):
    flattens_or_refuses(**{argument: array})


@given(st.lists(st.lists(HUGE, min_size=3, max_size=3), max_size=6))
def test_any_faces_are_flattened_or_refused(faces):
    flattens_or_refuses(faces=faces)


@given(st.lists(st.lists(HUGE, min_size=2, max_size=2), max_size=6))
def test_any_seams_are_flattened_or_refused(seams):
    flattens_or_refuses(seams=seams)


@given(st.lists(HUGE, max_size=6), st.one_of(st.floats(), st.integers(), st.none(), st.text(max_size=3)), st.text())
def test_any_wire_is_flattened_or_refused(vertices, tolerance, name):
    try:
        wire = wirewarp.Wire(vertices, tolerance=tolerance, name=name)
    except wirewarp.FlattenError as error:
        assert str(error).endswith(".")
    else:
        flattens_or_refuses(wires=[wire])


@given(hnp.arrays(NUMBERS, st.one_of(ANY_SHAPE, st.just((len(FACES), 3, 2)))))
def test_any_corner_coordinates_are_measured_or_refused(corner_uv):
    try:
        result = wirewarp.measure(VERTICES, FACES, corner_uv)
    except wirewarp.FlattenError as error:
        assert str(error).endswith(".")
    else:
        assert len(result.pieces) == 1
