// SPDX-License-Identifier: GPL-3.0-or-later
// Each of these functions adds one part of the Python module, and is in a file of its own.
#pragma once

#include <pybind11/pybind11.h>

#include "initialized.h"

namespace wirewarp::bindings {

namespace py = pybind11;

void bind_cloth(py::module_& module);
void bind_cut_mesh(py::module_& module);
void bind_options(py::module_& module);
void bind_wire(py::module_& module);
void bind_ease(py::module_& module);
void bind_results(py::module_& module);
void bind_cache(py::module_& module);
void bind_flatten(py::module_& module);
void bind_job(py::module_& module);
void bind_propose(py::module_& module);
void bind_straighten(py::module_& module);

}  // namespace wirewarp::bindings
