// SPDX-License-Identifier: GPL-3.0-or-later
// Binds a struct of the public API as a Python class of named fields: each field is registered once and appears as an
// attribute, in to_dict(), in repr() and in pickles. Arrays are views, and keep the owner of their memory alive.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "docs.h"
#include "initialized.h"
#include "wirewarp/types.h"

namespace wirewarp::bindings {

namespace py = pybind11;

/// Returns a numpy array on memory that `owner` keeps alive.
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

/// Converts numbers, strings and maps by value; records and lists of records refer to their owner.
template <class Value>
py::object to_python(const Value& value, py::handle owner) {
  return py::cast(value, py::return_value_policy::reference_internal, owner);
}

/// Converts a field's value back from the object that to_python() returned.
template <class Value>
void from_python(py::handle from, Value& value) {
  value = from.cast<Value>();
}

inline void from_python(py::handle from, std::vector<int>& values) {
  const py::array_t<int, py::array::c_style> array = py::reinterpret_borrow<py::object>(from);
  values.assign(array.data(), array.data() + array.size());
}

template <class Scalar, int Rows, int Columns, int Options>
void from_python(py::handle from, Eigen::Matrix<Scalar, Rows, Columns, Options>& matrix) {
  static_assert(Columns > 0, "the number of columns is known");
  const py::array_t<Scalar, py::array::c_style> array = py::reinterpret_borrow<py::object>(from);
  using Matrix = Eigen::Matrix<Scalar, Rows, Columns, Options>;
  matrix = Eigen::Map<const Matrix>(array.data(), array.size() / Columns, Columns);
}

inline void from_python(py::handle from, std::vector<VertexPair>& pairs) {
  VertexPairs matrix;
  from_python(from, matrix);
  pairs.clear();
  for (const auto& row : matrix.rowwise()) pairs.push_back({row[0], row[1]});
}

/// Returns what pickle needs to recreate a record, for any protocol: copyreg.__newobj__, the class and the state.
py::tuple record_reduce(const py::object& record, int protocol);

py::tuple record_state(const py::object& record);

/// Returns a record's fields as plain values for json: arrays and tuples become lists; NaN and infinity, which JSON
/// does not have, become None.
py::dict record_to_dict(py::handle record);

/// Returns one line with the class and its fields; arrays appear as their shape.
std::string record_repr(py::handle record);

template <class T>
class Record : public py::class_<T> {
 public:
  Record(py::module_& module, const char* name)
      : py::class_<T>(module, name, py::module_local(), doc_of(name)), name_(name) {
    // The class names the package as its module, because the extension module is private.
    const std::string module_name = py::str(module.attr("__name__"));
    this->attr("__module__") = module_name.substr(0, module_name.rfind('.'));
    this->attr("_fields") = py::list();
    this->def("to_dict", &record_to_dict, "Returns all fields as plain values for JSON. NaN and infinity become None.");
    this->def("__repr__", &record_repr);
    this->def("__reduce_ex__", &record_reduce);
  }

  template <class Member>
  Record& field(const char* name, Member T::*member) {
    return field(
        name, [member](const T& record, py::handle owner) { return to_python(record.*member, owner); },
        [member](T& record, py::handle value) { from_python(value, record.*member); });
  }

  /// Adds an enum member of the struct, which is a string in Python.
  template <class Enum, std::size_t N>
  Record& field(const char* name, Enum T::*member, const char* enumeration, const Named<Enum> (&names)[N]) {
    return field(
        name, [member, &names](const T& record, py::handle) { return py::str(name_of(record.*member, names)); },
        [member, &names](T& record, py::handle value) { record.*member = value_of(py::str(value), names); },
        doc_of(own(name), enumeration, names));
  }

  /// Adds a field.
  ///
  /// - get(record, owner): returns its value; owner is the record's Python object
  /// - set(record, value): restores the value from a pickle
  /// - doc: needed if the header has no member with this name
  template <class Get, class Set>
  Record& field(const char* name, Get get, Set set, const std::string& doc = "") {
    const std::string text = doc.empty() ? doc_of(own(name)) : doc;
    this->def_property_readonly(
        name, [get](py::object self) -> py::object { return get(self.cast<const T&>(), self); }, text.c_str());
    setters_.push_back(set);
    return listed(name);
  }

  /// Makes records picklable from the values of all fields. Call it after the last field.
  Record& picklable() {
    this->def(py::pickle(&record_state, [setters = setters_](const py::tuple& state) {
      if (state.size() != setters.size()) throw py::value_error("the pickle is from another version of wirewarp");
      T record;
      for (std::size_t i = 0; i < setters.size(); ++i) setters[i](record, state[i]);
      return record;
    }));
    return *this;
  }

  std::string own(const std::string& field) const { return name_ + "." + field; }

  /// Adds to the list of fields a property that is bound elsewhere.
  Record& listed(const char* name) {
    this->attr("_fields").attr("append")(name);
    return *this;
  }

 private:
  std::string name_;
  std::vector<std::function<void(T&, py::handle)>> setters_;
};

}  // namespace wirewarp::bindings
