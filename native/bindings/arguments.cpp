// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.h"

#include <string>
#include <vector>

#include "arrays.h"
#include "errors.h"

namespace wirewarp::bindings {
namespace {

FlattenError wrong_item(const std::string& argument, std::size_t index, const std::string& type, py::handle item) {
  return wrong_type(argument + "[" + std::to_string(index) + "]", (type == "Ease" ? "an " : "a ") + type,
                    type_name(item));
}

/// argument: name of the argument, such as "wires"; type: name of the class of its items, such as "Wire".
template <class Item>
std::vector<Item> read_list(py::handle value, const std::string& argument, const std::string& type) {
  if (py::isinstance<Item>(value) || !py::hasattr(value, "__iter__")) {
    throw wrong_type(argument, "a list of " + type, type_name(value));
  }
  std::vector<Item> items;
  for (const py::handle item : value) {
    if (!py::isinstance<Item>(item)) throw wrong_item(argument, items.size(), type, item);
    items.push_back(item.cast<const Item&>());
  }
  return items;
}

}  // namespace

std::vector<SurfacePath> read_paths(py::handle value) { return read_list<SurfacePath>(value, "paths", "SurfacePath"); }

Options read_options(py::handle value) {
  if (value.is_none()) return {};
  if (py::isinstance<Options>(value)) return value.cast<const Options&>();
  throw wrong_type("options", "Options or None", type_name(value));
}

Cache* read_cache(py::handle value) {
  if (value.is_none()) return nullptr;
  if (py::isinstance<Cache>(value)) return value.cast<Cache*>();
  throw wrong_type("cache", "a Cache or None", type_name(value));
}

FlattenInput read_input(py::handle vertices, py::handle faces, py::handle seams, py::handle wires, py::handle eases) {
  return {read_vertices(vertices), read_faces(faces), read_seams(seams), read_list<Wire>(wires, "wires", "Wire"),
          read_list<Ease>(eases, "eases", "Ease")};
}

}  // namespace wirewarp::bindings
