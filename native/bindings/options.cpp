// SPDX-License-Identifier: GPL-3.0-or-later
// wirewarp.Options: the enums as strings, every value checked when it is set.
#include "wirewarp/options.h"

#include <cmath>

#include "arrays.h"
#include "bind.h"
#include "enums.h"
#include "record.h"

namespace wirewarp::bindings {
namespace {

[[noreturn]] void refuse(const std::string& name, py::handle value, const std::string& allowed) {
  throw FlattenError(ErrorCode::invalid_option,
                     "Option " + name + " is " + std::string(py::repr(value)) + "; it must be " + allowed + ".");
}

template <class Enum, std::size_t N>
Enum read_enum(py::handle value, const std::string& name, const Named<Enum> (&names)[N]) {
  std::string allowed;
  for (const Named<Enum>& entry : names) {
    if (py::isinstance<py::str>(value) && value.equal(py::str(entry.name))) return entry.value;
    allowed += (allowed.empty() ? "'" : " or '") + std::string(entry.name) + "'";
  }
  refuse(name, value, allowed);
}

double read_gap(py::handle value) {
  const double gap = read_number(value, "Option gap");
  if (!(gap >= 0 && gap <= 1)) refuse("gap", value, "from 0 to 1");
  return gap;
}

double read_fairness(py::handle value) {
  const double fairness = read_number(value, "Option fairness");
  if (!(fairness >= Options::least_fairness && fairness <= Options::most_fairness))
    refuse("fairness", value, "from 0.001 to 10");
  return fairness;
}

int read_max_factorizations(py::handle value) {
  const double number = read_number(value, "Option max_factorizations");
  if (!(number >= 1 && number <= 1e6 && number == std::floor(number))) {
    refuse("max_factorizations", value, "a whole number from 1 to 1000000");
  }
  return static_cast<int>(number);
}

bool read_bool(py::handle value, const std::string& name) {
  const py::object numpy_bool = py::module_::import("numpy").attr("bool_");
  if (!py::isinstance<py::bool_>(value) && !py::isinstance(value, numpy_bool)) refuse(name, value, "True or False");
  return value.cast<bool>();
}

template <class Enum, std::size_t N>
void bind_enum(Record<Options>& record, const char* name, Enum Options::*member, const Named<Enum> (&names)[N],
               const char* doc) {
  record.def_property(
      name, [member, &names](const Options& options) { return name_of(options.*member, names); },
      [member, name, &names](Options& options, const py::object& value) {
        options.*member = read_enum(value, name, names);
      },
      doc);
  record.listed(name);
}

}  // namespace

void bind_options(py::module_& module) {
  const Options defaults;
  Record<Options> record(module, "Options",
                         "How to flatten. A value that is not known or out of range raises FlattenError "
                         "(invalid_option), here and when an attribute is set.");
  record.def(py::init([](const py::object& method, const py::object& node_weight, const py::object& inner,
                         const py::object& fairness, const py::object& max_factorizations, const py::object& gap,
                         const py::object& mirror) {
               Options options;
               options.method = read_enum(method, "method", kMethods);
               options.node_weight = read_enum(node_weight, "node_weight", kNodeWeights);
               options.inner = read_enum(inner, "inner", kInners);
               options.fairness = read_fairness(fairness);
               options.max_factorizations = read_max_factorizations(max_factorizations);
               options.gap = read_gap(gap);
               options.mirror = read_bool(mirror, "mirror");
               return options;
             }),
             py::kw_only(), py::arg("method") = name_of(defaults.method, kMethods),
             py::arg("node_weight") = name_of(defaults.node_weight, kNodeWeights),
             py::arg("inner") = name_of(defaults.inner, kInners), py::arg("fairness") = defaults.fairness,
             py::arg("max_factorizations") = defaults.max_factorizations, py::arg("gap") = defaults.gap,
             py::arg("mirror") = defaults.mirror);

  bind_enum(record, "method", &Options::method, kMethods, "How wire lengths and the shape are found.");
  bind_enum(record, "node_weight", &Options::node_weight, kNodeWeights,
            "Weight of a corner in Eq. (1): 'length', one over the mean length of its two edges, or 'uniform', 1.");
  bind_enum(record, "inner", &Options::inner, kInners,
            "'minimum' of Eq. (1), or its first feasible point 'least-norm' for comparison.");
  record.def_property(
      "fairness", [](const Options& options) { return options.fairness; },
      [](Options& options, const py::object& value) { options.fairness = read_fairness(value); },
      "Refined method: the shortest wiggle of an outline or wire that is left alone, over the square root of the "
      "piece's area, 0.001 to 10. Larger: smoother lines, more distortion inside.");
  record.listed("fairness");
  record.def_property(
      "max_factorizations", [](const Options& options) { return options.max_factorizations; },
      [](Options& options, const py::object& value) { options.max_factorizations = read_max_factorizations(value); },
      "Refined method: after so many factorizations a piece stops at the shape it has, at least 1.");
  record.listed("max_factorizations");
  record.def_property(
      "gap", [](const Options& options) { return options.gap; },
      [](Options& options, const py::object& value) { options.gap = read_gap(value); },
      "Space between packed pieces over the side of a square with the area of all pieces, 0 to 1.");
  record.listed("gap");
  record.def_property(
      "mirror", [](const Options& options) { return options.mirror; },
      [](Options& options, const py::object& value) { options.mirror = read_bool(value, "mirror"); },
      "True: the pieces as seen from inside.");
  record.listed("mirror");
}

}  // namespace wirewarp::bindings
