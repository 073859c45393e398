// SPDX-License-Identifier: GPL-3.0-or-later
// FlattenError between C++ and Python. The Python class lives in the package, beside this module.
#pragma once

#include <pybind11/pybind11.h>

#include "initialized.h"
#include "wirewarp/error.h"

namespace wirewarp::bindings {

namespace py = pybind11;

/// The name of the package this module was imported from: "wirewarp", or longer where an add-on carries it inside.
std::string package_name();

/// The Python FlattenError that says the same.
py::object to_python_error(const FlattenError& error);

/// The FlattenError that a Python one says.
FlattenError from_python_error(py::handle error);

/// The table the package makes its ErrorCode from, and the translator that raises FlattenError.
void bind_errors(py::module_& module);

}  // namespace wirewarp::bindings
