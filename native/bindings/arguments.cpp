// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.h"

#include <string>
#include <vector>

#include "arrays.h"
#include "errors.h"

namespace wirewarp::bindings {
namespace {

std::vector<Wire> read_wires(py::handle value) {
  if (py::isinstance<Wire>(value) || !py::hasattr(value, "__iter__")) {
    throw FlattenError(ErrorCode::invalid_type, "wires must be a list of Wire, not " + type_name(value) + ".");
  }
  std::vector<Wire> wires;
  for (const py::handle item : value) {
    if (!py::isinstance<Wire>(item)) {
      throw FlattenError(ErrorCode::invalid_type,
                         "wires[" + std::to_string(wires.size()) + "] must be a Wire, not " + type_name(item) + ".");
    }
    wires.push_back(item.cast<const Wire&>());
  }
  return wires;
}

}  // namespace

Options read_options(py::handle value) {
  if (value.is_none()) return {};
  if (py::isinstance<Options>(value)) return value.cast<const Options&>();
  throw FlattenError(ErrorCode::invalid_type, "options must be Options or None, not " + type_name(value) + ".");
}

Cache* read_cache(py::handle value) {
  if (value.is_none()) return nullptr;
  if (py::isinstance<Cache>(value)) return value.cast<Cache*>();
  throw FlattenError(ErrorCode::invalid_type, "cache must be a Cache or None, not " + type_name(value) + ".");
}

FlattenInput read_input(py::handle vertices, py::handle faces, py::handle seams, py::handle wires) {
  return {read_vertices(vertices), read_faces(faces), read_seams(seams), read_wires(wires)};
}

}  // namespace wirewarp::bindings
