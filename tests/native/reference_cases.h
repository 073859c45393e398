// SPDX-License-Identifier: GPL-3.0-or-later
// Panels and requests that are no part of this repository: read where a folder `shared` lies beside it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wirewarp/flatten.h"

namespace wirewarp::test {

/// A panel with all its wires of one tolerance. Empty where the panels are not at hand.
std::optional<FlattenInput> reference_panel(const std::string& name, double tolerance);

/// Several. Empty where they are not at hand.
std::vector<FlattenInput> reference_panels(const std::vector<std::string>& names, double tolerance);

/// A request from `shared/cases`, with its wires. Empty where they are not at hand.
std::optional<FlattenInput> reference_request(const std::string& name);

}  // namespace wirewarp::test
