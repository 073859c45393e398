// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"

#include <pybind11/numpy.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

#include "wirewarp/error.h"

namespace wirewarp::bindings {
namespace {

constexpr int kPlain = py::array::c_style | py::array::forcecast;

std::string text(py::handle value) { return py::str(value); }

std::string shape_text(const py::array& array) { return text(array.attr("shape")); }

FlattenError wrong_shape(const std::string& name, const std::string& wanted, const py::array& array) {
  return FlattenError(ErrorCode::invalid_shape,
                      ErrorArguments{{"name", name}, {"wanted", wanted}, {"found", shape_text(array)}});
}

/// Throws invalid_type for a masked array, because numpy would drop the mask and read the hidden values.
void refuse_masked(py::handle value, const std::string& name) {
  if (!py::isinstance(value, py::module_::import("numpy").attr("ma").attr("MaskedArray"))) return;
  throw wrong_type(name, "an array without a mask", "a masked array");
}

py::array as_array(py::handle value, const std::string& name) {
  refuse_masked(value, name);
  try {
    return py::module_::import("numpy").attr("asarray")(value);
  } catch (py::error_already_set& error) {
    const ErrorArguments arguments = {{"name", name}, {"found", text(error.value())}};
    if (error.matches(PyExc_ValueError)) throw FlattenError(ErrorCode::invalid_shape, arguments);
    if (error.matches(PyExc_TypeError)) throw FlattenError(ErrorCode::invalid_type, arguments);
    throw;
  }
}

/// Throws invalid_type unless the dtype is accepted. kinds: numpy's letters of the accepted dtypes ("f" floating, "i"
/// signed, "u" unsigned).
void check_kind(const py::array& array, py::handle value, const std::string& name, const std::string& kinds,
                const char* wanted) {
  if (kinds.find(array.dtype().kind()) != std::string::npos) return;
  const std::string found = array.ndim() == 0 ? type_name(value) : text(array.dtype());
  throw wrong_type(name, wanted, found);
}

/// Throws invalid_shape unless all rows have the given shape. Accepts an empty list, whose shape is (0,).
void check_rows(const py::array& array, const std::string& name, const std::vector<py::ssize_t>& row) {
  if (array.ndim() == 1 && array.size() == 0) return;
  if (array.ndim() == static_cast<py::ssize_t>(row.size()) + 1 &&
      std::equal(row.begin(), row.end(), array.shape() + 1)) {
    return;
  }
  std::string wanted;
  for (const py::ssize_t n : row) wanted += ", " + std::to_string(n);
  throw wrong_shape(name, "(n" + wanted + ")", array);
}

template <class Matrix>
Matrix read_reals(py::handle value, const std::string& name, const std::vector<py::ssize_t>& row) {
  const py::array array = as_array(value, name);
  check_kind(array, value, name, "fiu", "real numbers");
  check_rows(array, name, row);
  const py::array_t<double, kPlain> values(array);
  return Eigen::Map<const Matrix>(values.data(), values.size() / Matrix::ColsAtCompileTime, Matrix::ColsAtCompileTime);
}

struct TooLarge {
  py::ssize_t index;
  std::string value;
};

/// Copies integers into 32-bit indices. Returns the first value that does not fit, if any.
template <class Integer>
std::optional<TooLarge> narrow(const py::array& array, int* out) {
  const py::array_t<Integer, kPlain> values(array);
  for (py::ssize_t i = 0; i < values.size(); ++i) {
    const Integer v = values.data()[i];
    bool fits = v <= static_cast<Integer>(std::numeric_limits<int>::max());
    if constexpr (std::is_signed_v<Integer>) fits = fits && v >= std::numeric_limits<int>::min();
    if (!fits) return TooLarge{i, std::to_string(v)};
    out[i] = static_cast<int>(v);
  }
  return std::nullopt;
}

std::optional<TooLarge> narrow(const py::array& array, int* out) {
  const bool is_unsigned = array.dtype().kind() == 'u';
  return is_unsigned ? narrow<std::uint64_t>(array, out) : narrow<std::int64_t>(array, out);
}

[[noreturn]] void throw_too_large(const std::string& element, const std::string& value, ErrorElements elements) {
  throw FlattenError(ErrorCode::vertex_out_of_range, ErrorArguments{{"name", element}, {"found", value}},
                     std::move(elements));
}

std::string row_text(const py::array& array, int row) {
  std::string joined;
  for (const py::handle item : array[py::int_(row)]) joined += (joined.empty() ? "" : "-") + text(item);
  return joined;
}

template <class Matrix>
Matrix read_indices(py::handle value, const std::string& name, const std::string& element) {
  constexpr int kColumns = Matrix::ColsAtCompileTime;
  const py::array array = as_array(value, name);
  const bool is_empty = array.size() == 0;  // numpy gives an empty list a floating dtype
  check_kind(array, value, name, is_empty ? "iuf" : "iu", "whole numbers");
  check_rows(array, name, {kColumns});
  Matrix result(array.size() / kColumns, kColumns);
  if (const auto found = narrow(array, result.data())) {
    const int row = static_cast<int>(found->index / kColumns);
    ErrorElements elements;
    if (element == "Face") elements.faces = {row};
    throw_too_large(element + " " + std::to_string(row) + " (" + row_text(array, row) + ")", found->value, elements);
  }
  return result;
}

/// Reads a sequence that is not an array. Does not use numpy, which would convert True among whole numbers to 1, and
/// very large numbers to objects.
std::vector<int> read_sequence(py::handle value, const std::string& owner) {
  std::vector<int> result;
  for (const py::handle item : value) {
    const std::string element = owner + " vertex " + std::to_string(result.size());
    if (!PyIndex_Check(item.ptr()) || PyBool_Check(item.ptr())) {
      throw wrong_type(element, "a whole number", type_name(item));
    }
    const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(item.ptr()));
    if (!number) throw py::error_already_set();
    int overflow = 0;
    const long long v = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
    if (overflow != 0 || v != static_cast<int>(v)) throw_too_large(element, text(number), {});
    result.push_back(static_cast<int>(v));
  }
  return result;
}

template <std::size_t N>
std::array<double, N> read_row(py::handle value, const std::string& name) {
  const py::array array = as_array(value, name);
  check_kind(array, value, name, "fiu", "real numbers");
  if (array.ndim() != 1 || array.size() != N) {
    throw wrong_shape(name, "(" + std::to_string(N) + ",)", array);
  }
  const py::array_t<double, kPlain> values(array);
  std::array<double, N> row;
  for (std::size_t i = 0; i < N; ++i) row[i] = values.at(static_cast<py::ssize_t>(i));
  return row;
}

}  // namespace

FlattenError wrong_type(const std::string& name, const std::string& wanted, const std::string& found) {
  return FlattenError(ErrorCode::invalid_type, ErrorArguments{{"name", name}, {"wanted", wanted}, {"found", found}});
}

std::string type_name(py::handle value) { return text(py::type::handle_of(value).attr("__name__")); }

Positions3 read_vertices(py::handle value) { return read_reals<Positions3>(value, "vertices", {3}); }

Triangles read_faces(py::handle value) { return read_indices<Triangles>(value, "faces", "Face"); }

VertexPairs read_seams(py::handle value) {
  if (value.is_none()) return VertexPairs(0, 2);
  return read_indices<VertexPairs>(value, "seams", "Seam edge");
}

VertexPairs read_edges(py::handle value, const std::string& name) {
  if (value.is_none()) return VertexPairs(0, 2);
  return read_indices<VertexPairs>(value, name, "Edge");
}

VertexPairs read_half_edges(py::handle value) {
  return read_indices<VertexPairs>(value, "Ease half_edges", "Half-edge");
}

CornerUv read_corner_uv(py::handle value) { return read_reals<CornerUv>(value, "corner_uv", {3, 2}); }

Positions3 read_coordinates(py::handle value) { return read_reals<Positions3>(value, "SurfacePath coordinates", {3}); }

std::vector<int> read_whole_numbers(py::handle value, const std::string& name) {
  const py::array array = as_array(value, name);
  check_kind(array, value, name, array.size() == 0 ? "iuf" : "iu", "whole numbers");
  if (array.ndim() != 1) throw wrong_shape(name, "(n,)", array);
  std::vector<int> result(static_cast<std::size_t>(array.size()));
  if (const auto found = narrow(array, result.data())) {
    throw FlattenError(ErrorCode::invalid_option, ErrorArguments{{"name", name},
                                                                 {"value", "a list with " + found->value},
                                                                 {"allowed", "have indices below 2147483648"}});
  }
  return result;
}

std::vector<int> read_chain(py::handle value, const std::string& owner) {
  const std::string name = owner + " vertices";
  if (!py::isinstance<py::array>(value)) {
    const bool is_text =
        py::isinstance<py::str>(value) || py::isinstance<py::bytes>(value) || py::isinstance<py::bytearray>(value);
    if (PySequence_Check(value.ptr()) && !is_text) return read_sequence(value, owner);
    throw wrong_type(name, "a sequence of whole numbers", type_name(value));
  }
  refuse_masked(value, name);
  const auto array = py::reinterpret_borrow<py::array>(value);
  check_kind(array, value, name, "iu", "whole numbers");
  if (array.ndim() != 1) {
    throw wrong_shape(name, "(n,)", array);
  }
  std::vector<int> result(static_cast<std::size_t>(array.size()));
  if (const auto found = narrow(array, result.data())) {
    throw_too_large(owner + " vertex " + std::to_string(found->index), found->value, {});
  }
  return result;
}

double read_number(py::handle value, const std::string& name) {
  const py::array array = as_array(value, name);
  if (array.ndim() != 0 || std::string("fiu").find(array.dtype().kind()) == std::string::npos) {
    throw wrong_type(name, "a number", type_name(value));
  }
  return array.attr("item")().cast<double>();
}

std::array<double, 3> read_triple(py::handle value, const std::string& name) { return read_row<3>(value, name); }

std::array<double, 2> read_pair(py::handle value, const std::string& name) { return read_row<2>(value, name); }

}  // namespace wirewarp::bindings
