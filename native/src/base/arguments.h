// SPDX-License-Identifier: GPL-3.0-or-later
// Error arguments and errors that several parts of the library create.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp {

inline ErrorArguments arguments_of_wires(const std::vector<Wire>& wires, std::vector<int> indices) {
  std::vector<std::string> names;
  for (const int w : indices) names.push_back(wires[static_cast<std::size_t>(w)].name);
  return {{"wires", std::move(indices)}, {"wire_names", std::move(names)}};
}

/// Returns the error for an option with a value that is not allowed, for example
/// wrong_option("gap", "2", "be below 1").
inline FlattenError wrong_option(const std::string& name, const std::string& value, const std::string& allowed) {
  return FlattenError(ErrorCode::invalid_option,
                      ErrorArguments{{"name", name}, {"value", value}, {"allowed", allowed}});
}

}  // namespace wirewarp
