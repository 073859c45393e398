// SPDX-License-Identifier: GPL-3.0-or-later
// Converts FlattenError between C++ and Python. The package beside this module defines the Python class.
#pragma once

#include <pybind11/pybind11.h>

#include "initialized.h"
#include "wirewarp/error.h"

namespace wirewarp::bindings {

namespace py = pybind11;

/// Returns the name of the package from which this module was imported: "wirewarp", or longer if an add-on bundles it.
std::string package_name();

py::object to_python_error(const FlattenError& error);

FlattenError from_python_error(py::handle error);

/// Binds the table from which the package makes its ErrorCode, and the translator that raises FlattenError.
void bind_errors(py::module_& module);

}  // namespace wirewarp::bindings
