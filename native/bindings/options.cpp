// SPDX-License-Identifier: GPL-3.0-or-later
// Binds wirewarp.Options. Enums are strings in Python, and every value is checked when it is set.
#include "wirewarp/options.h"

#include <cmath>
#include <limits>

#include "arrays.h"
#include "bind.h"
#include "enums.h"
#include "record.h"
#include "running_call.h"

namespace wirewarp::bindings {
namespace {

[[noreturn]] void refuse(const std::string& name, py::handle value, const std::string& allowed) {
  throw FlattenError(
      ErrorCode::invalid_option,
      ErrorArguments{{"name", name}, {"value", std::string(py::repr(value))}, {"allowed", "be " + allowed}});
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

int read_whole_number(py::handle value, const std::string& name) {
  const double number = read_number(value, "Option " + name);
  using Limits = std::numeric_limits<int>;
  if (!(number >= Limits::min() && number <= Limits::max() && number == std::floor(number))) {
    refuse(name, value, "a whole number of at most " + std::to_string(Limits::max()));
  }
  return static_cast<int>(number);
}

/// Sets an option. If the value is out of its range, leaves all options unchanged and throws invalid_option.
template <class Value>
void set(Options& options, Value Options::*member, Value value) {
  Options changed = options;
  changed.*member = value;
  check_options(changed);
  options = changed;
}

py::tuple up_of(const Options& options) { return py::make_tuple(options.up[0], options.up[1], options.up[2]); }

bool read_bool(py::handle value, const std::string& name) {
  const py::object numpy_bool = py::module_::import("numpy").attr("bool_");
  if (!py::isinstance<py::bool_>(value) && !py::isinstance(value, numpy_bool)) refuse(name, value, "True or False");
  return value.cast<bool>();
}

template <class Enum, std::size_t N>
void bind_enum(Record<Options>& record, const char* name, Enum Options::*member, const char* enumeration,
               const Named<Enum> (&names)[N]) {
  record.def_property(
      name, [member, &names](const Options& options) { return name_of(options.*member, names); },
      [member, name, &names](Options& options, const py::object& value) {
        set(options, member, read_enum(value, name, names));
      },
      doc_of(record.own(name), enumeration, names).c_str());
  record.listed(name);
}

std::optional<Cloth> read_cloth(py::handle value) {
  if (value.is_none()) return std::nullopt;
  if (py::isinstance<py::str>(value)) return cloth_preset(value.cast<std::string>()).cloth;
  if (py::isinstance<Cloth>(value)) return value.cast<Cloth>();
  refuse("cloth", value, "None, a Cloth or the name of a fabric");
}

py::dict values_of(const py::object& options) {
  py::dict values;
  for (const py::handle name : options.attr("_fields")) values[name] = options.attr(py::str(name));
  return values;
}

}  // namespace

void bind_options(py::module_& module) {
  const Options defaults;
  Record<Options> record(module, "Options");
  record.def(py::init([](const py::object& method, const py::object& node_weight, const py::object& inner,
                         const py::object& fairness, const py::object& max_factorizations, const py::object& layout,
                         const py::object& orientation, const py::object& grain, const py::object& up,
                         const py::object& gap, const py::object& mirror, const py::object& cloth,
                         const py::object& grain_angle, const py::object& thickness, const py::object& surface) {
               Options options;
               options.method = read_enum(method, "method", kMethods);
               options.node_weight = read_enum(node_weight, "node_weight", kNodeWeights);
               options.inner = read_enum(inner, "inner", kInners);
               options.fairness = read_number(fairness, "Option fairness");
               options.max_factorizations = read_whole_number(max_factorizations, "max_factorizations");
               options.layout = read_enum(layout, "layout", kPieceLayouts);
               options.orientation = read_enum(orientation, "orientation", kOrientations);
               options.grain = read_whole_number(grain, "grain");
               options.up = read_triple(up, "Option up");
               options.gap = read_number(gap, "Option gap");
               options.mirror = read_bool(mirror, "mirror");
               options.cloth = read_cloth(cloth);
               options.grain_angle = read_number(grain_angle, "Option grain_angle");
               options.thickness = read_number(thickness, "Option thickness");
               options.surface = read_enum(surface, "surface", kSurfaces);
               check_options(options);
               return options;
             }),
             py::call_guard<RunningCall>(), py::kw_only(), py::arg("method") = name_of(defaults.method, kMethods),
             py::arg("node_weight") = name_of(defaults.node_weight, kNodeWeights),
             py::arg("inner") = name_of(defaults.inner, kInners), py::arg("fairness") = defaults.fairness,
             py::arg("max_factorizations") = defaults.max_factorizations,
             py::arg("layout") = name_of(defaults.layout, kPieceLayouts),
             py::arg("orientation") = name_of(defaults.orientation, kOrientations), py::arg("grain") = defaults.grain,
             py::arg("up") = up_of(defaults), py::arg("gap") = defaults.gap, py::arg("mirror") = defaults.mirror,
             py::arg("cloth") = py::none(), py::arg("grain_angle") = defaults.grain_angle,
             py::arg("thickness") = defaults.thickness, py::arg("surface") = name_of(defaults.surface, kSurfaces));
  record.def(
      py::pickle(&values_of, [](const py::dict& fields) { return py::type::of<Options>()(**fields).cast<Options>(); }));

  bind_enum(record, "method", &Options::method, "Method", kMethods);
  bind_enum(record, "node_weight", &Options::node_weight, "NodeWeight", kNodeWeights);
  bind_enum(record, "inner", &Options::inner, "Inner", kInners);
  record.def_property(
      "fairness", [](const Options& options) { return options.fairness; },
      [](Options& options, const py::object& value) {
        set(options, &Options::fairness, read_number(value, "Option fairness"));
      },
      doc_of("Options.fairness"));
  record.listed("fairness");
  record.def_property(
      "max_factorizations", [](const Options& options) { return options.max_factorizations; },
      [](Options& options, const py::object& value) {
        set(options, &Options::max_factorizations, read_whole_number(value, "max_factorizations"));
      },
      doc_of("Options.max_factorizations"));
  record.listed("max_factorizations");
  bind_enum(record, "layout", &Options::layout, "PieceLayout", kPieceLayouts);
  bind_enum(record, "orientation", &Options::orientation, "Orientation", kOrientations);
  record.def_property(
      "grain", [](const Options& options) { return options.grain; },
      [](Options& options, const py::object& value) {
        set(options, &Options::grain, read_whole_number(value, "grain"));
      },
      doc_of("Options.grain"));
  record.listed("grain");
  record.def_property(
      "up", &up_of,
      [](Options& options, const py::object& value) { set(options, &Options::up, read_triple(value, "Option up")); },
      doc_of("Options.up"));
  record.listed("up");
  record.def_property(
      "gap", [](const Options& options) { return options.gap; },
      [](Options& options, const py::object& value) { set(options, &Options::gap, read_number(value, "Option gap")); },
      doc_of("Options.gap"));
  record.listed("gap");
  record.def_property(
      "mirror", [](const Options& options) { return options.mirror; },
      [](Options& options, const py::object& value) { options.mirror = read_bool(value, "mirror"); },
      doc_of("Options.mirror"));
  record.listed("mirror");
  record.def_property(
      "cloth", [](const Options& options) { return options.cloth; },
      [](Options& options, const py::object& value) { set(options, &Options::cloth, read_cloth(value)); },
      doc_of("Options.cloth"));
  record.listed("cloth");
  record.def_property(
      "grain_angle", [](const Options& options) { return options.grain_angle; },
      [](Options& options, const py::object& value) {
        set(options, &Options::grain_angle, read_number(value, "Option grain_angle"));
      },
      doc_of("Options.grain_angle"));
  record.listed("grain_angle");
  record.def_property(
      "thickness", [](const Options& options) { return options.thickness; },
      [](Options& options, const py::object& value) {
        set(options, &Options::thickness, read_number(value, "Option thickness"));
      },
      doc_of("Options.thickness"));
  record.listed("thickness");
  bind_enum(record, "surface", &Options::surface, "Surface", kSurfaces);
}

}  // namespace wirewarp::bindings
