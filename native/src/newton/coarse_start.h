// SPDX-License-Identifier: GPL-3.0-or-later
// Coarse to fine: a large chart starts from the shape of a coarser one.
#pragma once

#include <optional>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Solves a copy of the chart with edges four times as long, or less if its wires have shorter waves, and prolongs its
/// shape and multipliers to the chart. Returns nullopt if the copy is hardly coarser or no shape with exact lengths is
/// found. The token is polled in the stage "start". Throws Stopped and FactorizationFailed.
std::optional<Shape> start_from_coarse(const Problem& problem, const Control& control);

}  // namespace wirewarp
