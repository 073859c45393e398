// SPDX-License-Identifier: GPL-3.0-or-later
// Coarse to fine: a large chart starts from the shape of a coarser copy.
#pragma once

#include <optional>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Solves a coarser copy of the chart, and prolongs the shape and multipliers of the copy to the chart. The edges of
/// the copy are four times as long, or shorter if longer edges could not follow the wires. Returns nullopt if the copy
/// is hardly coarser or no shape with exact lengths is found. The token is polled in the stage "start". Throws Stopped
/// and FactorizationFailed.
std::optional<Shape> start_from_coarse(const Problem& problem, const Control& control);

}  // namespace wirewarp
