// SPDX-License-Identifier: GPL-3.0-or-later
// Errors and arguments that several parts of the library make alike.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp {

/// The arguments "wires" and "wire_names" of an error about these wires of an input.
inline ErrorArguments arguments_of_wires(const std::vector<Wire>& wires, std::vector<int> indices) {
  std::vector<std::string> names;
  for (const int w : indices) names.push_back(wires[static_cast<std::size_t>(w)].name);
  return {{"wires", std::move(indices)}, {"wire_names", std::move(names)}};
}

/// The error of an option that has this value and must do something else: wrong_option("gap", "2", "be below 1").
inline FlattenError wrong_option(const std::string& name, const std::string& value, const std::string& allowed) {
  return FlattenError(ErrorCode::invalid_option,
                      ErrorArguments{{"name", name}, {"value", value}, {"allowed", allowed}});
}

}  // namespace wirewarp
