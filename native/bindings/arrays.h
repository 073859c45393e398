// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the arrays of users and copies them into the types of the public API. Accepts nested lists, and any dtype,
// strides and byte order, if the numbers are of the right kind. Otherwise throws FlattenError. The arrays are copied,
// so that the caller may change or free them while the core runs without the GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <array>
#include <string>
#include <vector>

#include "wirewarp/types.h"

namespace wirewarp::bindings {

namespace py = pybind11;

/// Reads vertices (n, 3), real numbers.
Positions3 read_vertices(py::handle value);

/// Reads faces (m, 3), whole numbers.
Triangles read_faces(py::handle value);

/// Reads seams (k, 2), whole numbers; None or an empty list for no seams.
VertexPairs read_seams(py::handle value);

/// Reads an array (k, 2) of whole numbers; None or an empty list for no edges.
VertexPairs read_edges(py::handle value, const std::string& name);

VertexPairs read_half_edges(py::handle value);

/// Reads corner_uv (m, 3, 2), real numbers.
CornerUv read_corner_uv(py::handle value);

/// Reads coordinates (k, 3) of a SurfacePath, real numbers.
Positions3 read_coordinates(py::handle value);

/// Reads a one-dimensional array of whole numbers. Throws invalid_type or invalid_shape. name: the argument, for
/// errors.
std::vector<int> read_whole_numbers(py::handle value, const std::string& name);

/// Reads consecutive vertices: any sequence or one-dimensional array of whole numbers. owner: "Wire", for messages.
std::vector<int> read_chain(py::handle value, const std::string& owner);

/// Reads one real number. Throws invalid_type. name: the argument, for errors.
double read_number(py::handle value, const std::string& name);

/// Reads three real numbers. Throws invalid_type or invalid_shape. name: the argument, for errors.
std::array<double, 3> read_triple(py::handle value, const std::string& name);

/// Reads two real numbers. Throws the errors of read_triple().
std::array<double, 2> read_pair(py::handle value, const std::string& name);

std::string type_name(py::handle value);

/// Returns the error for an argument of the wrong type, for example wrong_type("progress", "a function",
/// type_name(value)).
FlattenError wrong_type(const std::string& name, const std::string& wanted, const std::string& found);

}  // namespace wirewarp::bindings
