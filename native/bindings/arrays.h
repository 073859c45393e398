// SPDX-License-Identifier: GPL-3.0-or-later
// What users pass, checked and copied into the types of the public API. Any dtype, strides, byte order or nested list
// of the right kind of numbers; everything else throws FlattenError. A copy, so that the caller may change or free its
// arrays while the core runs without the GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <array>
#include <string>
#include <vector>

#include "wirewarp/types.h"

namespace wirewarp::bindings {

namespace py = pybind11;

/// vertices (n, 3), real numbers.
Positions3 read_vertices(py::handle value);

/// faces (m, 3), whole numbers.
Triangles read_faces(py::handle value);

/// seams (k, 2), whole numbers; None or an empty list for none.
VertexPairs read_seams(py::handle value);

/// no_seam (k, 2), whole numbers; None or an empty list for none.
VertexPairs read_no_seam(py::handle value);

/// Of an Ease.
VertexPairs read_half_edges(py::handle value);

/// corner_uv (m, 3, 2), real numbers.
CornerUv read_corner_uv(py::handle value);

/// Of a SurfacePath: coordinates (k, 3), real numbers.
Positions3 read_coordinates(py::handle value);

/// One-dimensional, whole numbers; throws invalid_type or invalid_shape, calling it `name`.
std::vector<int> read_whole_numbers(py::handle value, const std::string& name);

/// Vertices in a row: any sequence or one-dimensional array of whole numbers; owner: "Wire", for messages.
std::vector<int> read_chain(py::handle value, const std::string& owner);

/// One real number; throws invalid_type, calling it `name`.
double read_number(py::handle value, const std::string& name);

/// Three real numbers in a row; throws invalid_type or invalid_shape, calling them `name`.
std::array<double, 3> read_triple(py::handle value, const std::string& name);

/// Two real numbers in a row; throws as read_triple() does.
std::array<double, 2> read_pair(py::handle value, const std::string& name);

/// The name of the type of a value, for messages.
std::string type_name(py::handle value);

/// The error of an argument that must be something else: wrong_type("progress", "a function", type_name(value)).
FlattenError wrong_type(const std::string& name, const std::string& wanted, const std::string& found);

}  // namespace wirewarp::bindings
