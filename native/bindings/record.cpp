// SPDX-License-Identifier: GPL-3.0-or-later
#include "record.h"

#include <cmath>

namespace wirewarp::bindings {
namespace {

py::object plain_array(py::handle array) {
  const py::module_ numpy = py::module_::import("numpy");
  const py::object finite = numpy.attr("isfinite")(array);
  if (finite.attr("all")().cast<bool>()) return array.attr("tolist")();
  return numpy.attr("where")(finite, array, py::none()).attr("tolist")();
}

py::object plain(py::handle value) {
  if (py::isinstance<py::array>(value)) return plain_array(value);
  if (py::isinstance<py::float_>(value) && !std::isfinite(value.cast<double>())) return py::none();
  if (py::isinstance<py::dict>(value)) {
    py::dict result;
    for (const auto& [key, item] : py::reinterpret_borrow<py::dict>(value)) result[key] = plain(item);
    return result;
  }
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
    py::list result;
    for (const py::handle item : value) result.append(plain(item));
    return result;
  }
  if (py::hasattr(value, "to_dict")) return value.attr("to_dict")();
  return py::reinterpret_borrow<py::object>(value);
}

std::string short_text(py::handle value) {
  if (py::isinstance<py::array>(value)) return "array" + std::string(py::str(value.attr("shape")));
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value) || py::isinstance<py::dict>(value)) {
    return "<" + std::to_string(py::len(value)) + ">";
  }
  if (py::isinstance<py::float_>(value)) return py::str("{:.6g}").format(value);
  if (py::hasattr(value, "_fields")) return std::string(py::str(py::type::handle_of(value).attr("__name__"))) + "(...)";
  return py::repr(value);
}

}  // namespace

py::tuple record_reduce(const py::object& record, int) {
  const py::object make = py::module_::import("copyreg").attr("__newobj__");
  return py::make_tuple(make, py::make_tuple(py::type::of(record)), record.attr("__getstate__")());
}

py::tuple record_state(const py::object& record) {
  py::list state;
  for (const py::handle name : record.attr("_fields")) state.append(record.attr(py::str(name)));
  return py::tuple(state);
}

py::dict record_to_dict(py::handle record) {
  py::dict result;
  for (const py::handle name : record.attr("_fields")) result[name] = plain(record.attr(py::str(name)));
  return result;
}

std::string record_repr(py::handle record) {
  std::string fields;
  for (const py::handle name : record.attr("_fields")) {
    if (!fields.empty()) fields += ", ";
    fields += std::string(py::str(name)) + "=" + short_text(record.attr(py::str(name)));
  }
  return std::string(py::str(py::type::handle_of(record).attr("__name__"))) + "(" + fields + ")";
}

}  // namespace wirewarp::bindings
