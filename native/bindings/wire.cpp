// SPDX-License-Identifier: GPL-3.0-or-later
// Binds wirewarp.Wire and wirewarp.Ease, which are checked when they are created and cannot be changed afterwards.
#include <cmath>

#include "arrays.h"
#include "bind.h"
#include "record.h"
#include "running_call.h"
#include "wirewarp/flatten.h"

namespace wirewarp::bindings {
namespace {

Wire make_wire(const py::object& vertices, const py::object& tolerance, const py::object& name,
               const py::object& ease) {
  Wire wire;
  wire.vertices = read_chain(vertices, "Wire");
  wire.tolerance = read_number(tolerance, "Wire tolerance");
  if (!py::isinstance<py::str>(name)) {
    throw wrong_type("Wire name", "a string", type_name(name));
  }
  try {
    wire.name = name.cast<std::string>();
  } catch (const py::cast_error&) {
    throw wrong_type("Wire name", "text", "a string with lone surrogates");
  }
  wire.ease = read_number(ease, "Wire ease");
  check_wire(wire);
  return wire;
}

Ease make_ease(const py::object& half_edges, const py::object& ratio) {
  Ease ease{read_half_edges(half_edges), read_number(ratio, "Ease ratio")};
  check_ease(ease);
  return ease;
}

/// Returns the values of a field as a read-only array, because changed values would not be checked.
template <class Values>
py::object read_only(const Values& values, const py::object& owner) {
  py::object array = to_python(values, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

}  // namespace

void bind_wire(py::module_& module) {
  Record<Wire> record(module, "Wire");
  record.def(py::init(&make_wire), py::call_guard<RunningCall>(), py::arg("vertices"), py::arg("tolerance") = 0.0,
             py::arg("name") = "", py::arg("ease") = 0.0,
             "vertices: any sequence or array of whole numbers. An edge joins each vertex to the next. A closed wire "
             "repeats its first vertex. tolerance: 0 for a rigid wire, a finite number for an elastic wire, math.inf "
             "for a free wire. ease: the flat length is (1 + h) times the 3D length, with |h - ease| <= tolerance. "
             "Along a seam or outline, all sides have the same h.");
  record.def(
      py::pickle([](const Wire& wire) { return py::make_tuple(wire.vertices, wire.tolerance, wire.name, wire.ease); },
                 [](const py::tuple& fields) { return make_wire(fields[0], fields[1], fields[2], fields[3]); }));
  record.def_property_readonly(
      "vertices", [](const py::object& self) { return read_only(self.cast<const Wire&>().vertices, self); },
      doc_of("Wire.vertices"));
  record.listed("vertices").field("tolerance", &Wire::tolerance).field("name", &Wire::name).field("ease", &Wire::ease);
}

void bind_ease(py::module_& module) {
  Record<Ease> record(module, "Ease");
  record.def(py::init(&make_ease), py::call_guard<RunningCall>(), py::arg("half_edges"), py::arg("ratio"),
             "half_edges: (k, 2) vertex pairs. ratio: above -1; 0.05 for a sleeve head, 1 for gathers.");
  record.def(
      py::pickle([](const py::object& self) { return py::make_tuple(self.attr("half_edges"), self.attr("ratio")); },
                 [](const py::tuple& fields) { return make_ease(fields[0], fields[1]); }));
  record.def_property_readonly(
      "half_edges", [](const py::object& self) { return read_only(self.cast<const Ease&>().half_edges, self); },
      doc_of("Ease.half_edges"));
  record.listed("half_edges").field("ratio", &Ease::ratio);
}

}  // namespace wirewarp::bindings
