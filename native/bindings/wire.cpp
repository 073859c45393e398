// SPDX-License-Identifier: GPL-3.0-or-later
// wirewarp.Wire: checked when it is made, unchangeable afterwards.
#include <cmath>

#include "arrays.h"
#include "bind.h"
#include "record.h"
#include "wirewarp/flatten.h"

namespace wirewarp::bindings {
namespace {

Wire make_wire(const py::object& vertices, const py::object& tolerance, const py::object& name) {
  Wire wire;
  wire.vertices = read_chain(vertices);
  wire.tolerance = read_number(tolerance, "Wire tolerance");
  if (!py::isinstance<py::str>(name)) {
    throw FlattenError(ErrorCode::invalid_type, "Wire name must be a string, not " + type_name(name) + ".");
  }
  try {
    wire.name = name.cast<std::string>();
  } catch (const py::cast_error&) {
    throw FlattenError(ErrorCode::invalid_type, "Wire name has characters that are no text (lone surrogates).");
  }
  check_wire(wire);
  return wire;
}

}  // namespace

void bind_wire(py::module_& module) {
  Record<Wire> record(module, "Wire");
  record.def(py::init(&make_wire), py::arg("vertices"), py::arg("tolerance") = 0.0, py::arg("name") = "",
             "vertices: any sequence or array of whole numbers, consecutive ones joined by an edge; a closed wire "
             "repeats its first. tolerance: 0 rigid, finite elastic, math.inf super-elastic.");
  record.def(py::pickle([](const Wire& wire) { return py::make_tuple(wire.vertices, wire.tolerance, wire.name); },
                        [](const py::tuple& fields) { return make_wire(fields[0], fields[1], fields[2]); }));
  record.def_property_readonly(
      "vertices",
      [](const py::object& self) {
        py::object vertices = to_python(self.cast<const Wire&>().vertices, self);
        vertices.attr("setflags")(py::arg("write") = false);  // a checked wire stays as it was checked
        return vertices;
      },
      doc_of("Wire.vertices"));
  record.listed("vertices").field("tolerance", &Wire::tolerance).field("name", &Wire::name);
}

}  // namespace wirewarp::bindings
