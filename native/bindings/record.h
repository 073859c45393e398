// SPDX-License-Identifier: GPL-3.0-or-later
// Binds a struct of the public API as a Python class of named fields: each field is registered once and appears as an
// attribute, in to_dict() and in repr(). Arrays are views that keep the object that holds their memory alive.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

#include "wirewarp/types.h"

namespace wirewarp::bindings {

namespace py = pybind11;

/// A numpy array over memory that `owner` keeps alive.
template <class Scalar>
py::object view(const Scalar* data, std::vector<py::ssize_t> shape, py::handle owner) {
  return py::array_t<Scalar>(std::move(shape), data, owner);
}

inline py::object to_python(const std::vector<int>& values, py::handle owner) {
  return view(values.data(), {static_cast<py::ssize_t>(values.size())}, owner);
}

inline py::object to_python(const std::vector<VertexPair>& pairs, py::handle owner) {
  return view(pairs.empty() ? nullptr : pairs.front().data(), {static_cast<py::ssize_t>(pairs.size()), 2}, owner);
}

inline py::object to_python(const CornerUv& corners, py::handle owner) {
  return view(corners.data(), {corners.rows(), 3, 2}, owner);
}

template <class Scalar, int Columns, int Options>
py::object to_python(const Eigen::Matrix<Scalar, Eigen::Dynamic, Columns, Options>& matrix, py::handle owner) {
  if constexpr (Columns == 1) return view(matrix.data(), {matrix.rows()}, owner);
  static_assert(Columns == 1 || Options == Eigen::RowMajor, "numpy expects rows one after the other");
  return view(matrix.data(), {matrix.rows(), matrix.cols()}, owner);
}

/// Numbers, strings and maps by value; records and lists of records by reference into their owner.
template <class Value>
py::object to_python(const Value& value, py::handle owner) {
  return py::cast(value, py::return_value_policy::reference_internal, owner);
}

/// A record's fields as plain values that json can write: arrays and tuples become lists; what JSON cannot say, NaN
/// and infinity, becomes None.
py::dict record_to_dict(py::handle record);

/// One line: the class and its fields, arrays by their shape.
std::string record_repr(py::handle record);

/// A Python class for the struct T.
template <class T>
class Record : public py::class_<T> {
 public:
  Record(py::module_& module, const char* name, const char* doc)
      : py::class_<T>(module, name, py::module_local(), doc) {
    // The class belongs to the package; the extension module is a private part of it.
    const std::string module_name = py::str(module.attr("__name__"));
    this->attr("__module__") = module_name.substr(0, module_name.rfind('.'));
    this->attr("_fields") = py::list();
    this->def("to_dict", &record_to_dict, "All fields as plain, JSON-able values; NaN and infinity become None.");
    this->def("__repr__", &record_repr);
  }

  /// A member of the struct.
  template <class Member>
  Record& field(const char* name, Member T::*member, const char* doc) {
    return field(
        name, [member](const T& record, py::handle owner) { return to_python(record.*member, owner); }, doc);
  }

  /// A value made by get(record, owner), where owner is the Python object of the record.
  template <class Get>
  Record& field(const char* name, Get get, const char* doc) {
    this->def_property_readonly(
        name, [get](py::object self) -> py::object { return get(self.cast<const T&>(), self); }, doc);
    return listed(name);
  }

  /// A property that is bound elsewhere.
  Record& listed(const char* name) {
    this->attr("_fields").attr("append")(name);
    return *this;
  }
};

}  // namespace wirewarp::bindings
