// SPDX-License-Identifier: GPL-3.0-or-later
#include "errors.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "wirewarp/options.h"

namespace wirewarp::bindings {
namespace {

py::tuple pairs(const std::vector<VertexPair>& edges) {
  py::tuple result(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) result[i] = py::make_tuple(edges[i][0], edges[i][1]);
  return result;
}

py::tuple pairs(const std::vector<ProposedTolerance>& tolerances) {
  py::tuple result(tolerances.size());
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    result[i] = py::make_tuple(tolerances[i].wire, tolerances[i].tolerance);
  }
  return result;
}

void raise_flatten_error(std::exception_ptr pointer) {
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const FlattenError& error) {
    const py::object instance = to_python_error(error);
    PyErr_SetObject(py::type::handle_of(instance).ptr(), instance.ptr());
  }
}

}  // namespace

std::string package_name() { return py::str(py::type::of<Options>().attr("__module__")); }

py::object to_python_error(const FlattenError& error) {
  const py::object type = py::module_::import(package_name().c_str()).attr("FlattenError");
  return type(describe(error.code).name, error.what(), error.elements.vertices, pairs(error.elements.edges),
              error.elements.faces, error.has_layout, pairs(error.elements.proposed_seams),
              pairs(error.elements.proposed_tolerances), error.arguments);
}

FlattenError from_python_error(py::handle error) {
  const std::string name = py::str(error.attr("code").attr("value"));
  const std::vector<ErrorCode>& codes = all_error_codes();
  const auto code =
      std::find_if(codes.begin(), codes.end(), [&](ErrorCode known) { return describe(known).name == name; });
  if (code == codes.end()) throw py::value_error("'" + name + "' is not an error code of this version of wirewarp");
  ErrorElements elements{error.attr("vertices").cast<std::vector<int>>(),
                         error.attr("edges").cast<std::vector<VertexPair>>(),
                         error.attr("faces").cast<std::vector<int>>(),
                         error.attr("proposed_seams").cast<std::vector<VertexPair>>(),
                         {}};
  for (const py::handle proposed : error.attr("proposed_tolerances")) {
    const auto [wire, tolerance] = proposed.cast<std::pair<int, double>>();
    elements.proposed_tolerances.push_back({wire, tolerance});
  }
  return FlattenError(*code, error.attr("message").cast<std::string>(), std::move(elements),
                      error.attr("has_layout").cast<bool>(), error.attr("arguments").cast<ErrorArguments>());
}

void bind_errors(py::module_& module) {
  module.def(
      "error_descriptions",
      [] {
        py::dict result;
        for (const ErrorCode code : all_error_codes()) {
          const ErrorDescription& description = describe(code);
          result[description.name] = py::make_tuple(description.meaning, description.remedy, description.arguments);
        }
        return result;
      },
      "Returns a dict: name of every error code -> (meaning, remedy, arguments), in declaration order.");
  py::register_local_exception_translator(raise_flatten_error);
}

}  // namespace wirewarp::bindings
