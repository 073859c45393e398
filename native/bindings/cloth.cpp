// SPDX-License-Identifier: GPL-3.0-or-later
// Binds wirewarp.Cloth, which is checked when it is created and cannot be changed afterwards.
#include "wirewarp/cloth.h"

#include "arrays.h"
#include "bind.h"
#include "record.h"
#include "running_call.h"

namespace wirewarp::bindings {
namespace {

Cloth make_cloth(const py::object& weft, const py::object& warp, const py::object& shear, const py::object& squeeze,
                 const py::object& stretch, const py::object& locking, const py::object& limits) {
  Cloth cloth;
  cloth.weft = read_number(weft, "Cloth weft");
  cloth.warp = read_number(warp, "Cloth warp");
  cloth.shear = read_number(shear, "Cloth shear");
  cloth.squeeze = read_number(squeeze, "Cloth squeeze");
  cloth.stretch = read_pair(stretch, "Cloth stretch");
  if (!locking.is_none()) cloth.locking = read_number(locking, "Cloth locking");
  if (!limits.is_none()) cloth.limits = read_pair(limits, "Cloth limits");
  check_cloth(cloth);
  return cloth;
}

const ClothPreset& preset(const py::object& name) {
  if (py::isinstance<py::str>(name)) return cloth_preset(name.cast<std::string>());
  throw FlattenError(
      ErrorCode::invalid_option,
      ErrorArguments{{"name", "cloth"}, {"value", std::string(py::repr(name))}, {"allowed", "be a string"}});
}

py::tuple preset_names() {
  py::list names;
  for (const ClothPreset& one : cloth_presets()) names.append(one.name);
  return py::tuple(names);
}

py::tuple pair_of(const std::array<double, 2>& pair) { return py::make_tuple(pair[0], pair[1]); }

}  // namespace

void bind_cloth(py::module_& module) {
  Record<Cloth> record(module, "Cloth");
  record.def(py::init(&make_cloth), py::call_guard<RunningCall>(), py::arg("weft") = 1.0, py::arg("warp") = 1.0,
             py::arg("shear") = 0.5, py::kw_only(), py::arg("squeeze") = 1.0,
             py::arg("stretch") = py::make_tuple(0.0, 0.0), py::arg("locking") = py::none(),
             py::arg("limits") = py::none());
  record.def_static(
      "preset", [](const py::object& name) { return preset(name).cloth; }, py::arg("name"),
      "Returns the fabric with this name, one of presets().");
  record.def_static(
      "about",
      [](const py::object& name) {
        const ClothPreset& one = preset(name);
        return py::dict(py::arg("label") = one.label, py::arg("description") = one.description,
                        py::arg("source") = one.source);
      },
      py::arg("name"), "Returns the label, description and source of the preset with this name, as a dict.");
  record.def_static("presets", &preset_names,
                    "Returns the names that preset() accepts. New names are added at the end.");
  record.def(py::pickle(
      [](const Cloth& cloth) {
        return py::make_tuple(cloth.weft, cloth.warp, cloth.shear, cloth.squeeze, cloth.stretch, cloth.locking,
                              cloth.limits);
      },
      [](const py::tuple& fields) {
        return make_cloth(fields[0], fields[1], fields[2], fields[3], fields[4], fields[5], fields[6]);
      }));
  record.def(
      "__eq__",
      [](const Cloth& cloth, const Cloth& other) {
        const auto all = [](const Cloth& of) {
          return std::make_tuple(of.weft, of.warp, of.shear, of.squeeze, of.stretch, of.locking, of.limits);
        };
        return all(cloth) == all(other);
      },
      py::is_operator());
  record.attr("__hash__") = py::none();
  record.field("weft", &Cloth::weft)
      .field("warp", &Cloth::warp)
      .field("shear", &Cloth::shear)
      .field("squeeze", &Cloth::squeeze)
      .field(
          "stretch", [](const Cloth& cloth, py::handle) -> py::object { return pair_of(cloth.stretch); },
          [](Cloth& cloth, py::handle value) { cloth.stretch = read_pair(value, "Cloth stretch"); })
      .field("locking", &Cloth::locking)
      .field(
          "limits",
          [](const Cloth& cloth, py::handle) -> py::object {
            if (!cloth.limits) return py::none();
            return pair_of(*cloth.limits);
          },
          [](Cloth& cloth, py::handle value) {
            if (!value.is_none()) cloth.limits = read_pair(value, "Cloth limits");
          });
}

}  // namespace wirewarp::bindings
