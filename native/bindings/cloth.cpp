// SPDX-License-Identifier: GPL-3.0-or-later
// wirewarp.Cloth: checked when it is made, unchangeable afterwards.
#include "wirewarp/cloth.h"

#include "arrays.h"
#include "bind.h"
#include "record.h"

namespace wirewarp::bindings {
namespace {

Cloth make_cloth(const py::object& weft, const py::object& warp, const py::object& shear, const py::object& squeeze,
                 const py::object& locking, const py::object& limits) {
  Cloth cloth;
  cloth.weft = read_number(weft, "Cloth weft");
  cloth.warp = read_number(warp, "Cloth warp");
  cloth.shear = read_number(shear, "Cloth shear");
  cloth.squeeze = read_number(squeeze, "Cloth squeeze");
  if (!locking.is_none()) cloth.locking = read_number(locking, "Cloth locking");
  if (!limits.is_none()) cloth.limits = read_pair(limits, "Cloth limits");
  check_cloth(cloth);
  return cloth;
}

}  // namespace

void bind_cloth(py::module_& module) {
  Record<Cloth> record(module, "Cloth",
                       "What the pieces are cut from: how much it resists stretching across and along the grain, and "
                       "shear. Only ratios count.");
  record.def(py::init(&make_cloth), py::arg("weft") = 1.0, py::arg("warp") = 1.0, py::arg("shear") = 0.5, py::kw_only(),
             py::arg("squeeze") = 1.0, py::arg("locking") = py::none(), py::arg("limits") = py::none(),
             "weft, warp: stiffness of the threads across and along the grain; shear: against turning them to one "
             "another. squeeze: how many times more a squeezed thread costs than a stretched one. locking: the shear "
             "angle in radians from which on threads press on one another. limits: the strains (weft, warp) that the "
             "cloth bears; a piece that needs more has a warning.");
  record.def_static(
      "preset", [](const std::string& name) { return cloth_preset(name); }, py::arg("name"),
      "'woven', 'denim', 'jersey', 'swim', 'leather' or 'neoprene'.");
  record.def(py::pickle(
      [](const Cloth& cloth) {
        return py::make_tuple(cloth.weft, cloth.warp, cloth.shear, cloth.squeeze, cloth.locking, cloth.limits);
      },
      [](const py::tuple& fields) {
        return make_cloth(fields[0], fields[1], fields[2], fields[3], fields[4], fields[5]);
      }));
  record.def("__eq__", [](const Cloth& cloth, const Cloth& other) {
    const auto all = [](const Cloth& of) {
      return std::make_tuple(of.weft, of.warp, of.shear, of.squeeze, of.locking, of.limits);
    };
    return all(cloth) == all(other);
  });
  record.attr("__hash__") = py::none();
  record.field("weft", &Cloth::weft, "Stiffness of the threads across, over that of the others.")
      .field("warp", &Cloth::warp, "Of the threads along the grain.")
      .field("shear", &Cloth::shear, "Against turning them to one another.")
      .field("squeeze", &Cloth::squeeze, "How many times more a squeezed thread costs than a stretched one.")
      .field("locking", &Cloth::locking, "The shear angle that locks the threads, radians; None: none does.")
      .field(
          "limits",
          [](const Cloth& cloth, py::handle) -> py::object {
            if (!cloth.limits) return py::none();
            return py::make_tuple((*cloth.limits)[0], (*cloth.limits)[1]);
          },
          [](Cloth& cloth, py::handle value) {
            if (!value.is_none()) cloth.limits = read_pair(value, "Cloth limits");
          },
          "(weft, warp): strains that the cloth bears; None: not checked.");
}

}  // namespace wirewarp::bindings
