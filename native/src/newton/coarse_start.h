// SPDX-License-Identifier: GPL-3.0-or-later
// Coarse to fine: a large chart starts from the shape of a coarser copy.
#pragma once

#include <optional>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Returns the shape and multipliers of a coarser copy, prolonged to the chart. Returns nullopt if the copy is hardly
/// coarser or has no exact shape. Throws Stopped (polled in the stage "start") and FactorizationFailed.
std::optional<Shape> start_from_coarse(const Problem& problem, const Control& control);

}  // namespace wirewarp
