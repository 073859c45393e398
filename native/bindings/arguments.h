// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the arguments that most functions of the module share. Each function throws FlattenError: invalid_type for a
// wrong type, and the core's errors for wrong values.
#pragma once

#include "bind.h"
#include "wirewarp/cache.h"
#include "wirewarp/cut_mesh.h"
#include "wirewarp/flatten.h"

namespace wirewarp::bindings {

FlattenInput read_input(py::handle vertices, py::handle faces, py::handle seams, py::handle wires, py::handle eases);

std::vector<SurfacePath> read_paths(py::handle value);

Options read_options(py::handle value);

Cache* read_cache(py::handle value);

}  // namespace wirewarp::bindings
