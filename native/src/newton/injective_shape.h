// SPDX-License-Identifier: GPL-3.0-or-later
// Finds shapes without flips and overlaps if the usual starts lead to a flipped or overlapping shape.
#pragma once

#include <optional>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

inline constexpr const char* kInjectiveStart = "injective";  // Solution::start

/// Returns how injective a layout of the chart is. uv: one row per vertex.
Injectivity injectivity_of(const Chart& chart, const Positions2& uv);

/// Returns a start with exact lengths and the injectivity of the stage. Every shape on the way has this injectivity,
/// too. The way begins at the free ARAP map if that is injective enough, otherwise at the Tutte embedding in a circle.
/// Returns nullopt if exact lengths are not reached. The token is polled in the stages "start" and "shape". Throws
/// Stopped and FactorizationFailed.
std::optional<Shape> reach_injectively(Problem& problem, const Stage& stage, const Control& control);

/// Improves an exact solution that is not injective: replaces it by the least distorted shape without flips, then by
/// the least distorted one without overlaps. Keeps the last exact shape if the search fails or the caller stops.
void make_injective(Problem& problem, Stage stage, const Control& control, Solution& solution);

}  // namespace wirewarp
