// SPDX-License-Identifier: GPL-3.0-or-later
// Finds shapes without flips and overlaps if the fast way ends with one that has some.
#pragma once

#include <optional>

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

inline constexpr const char* kInjectiveStart = "injective";  // Solution::start

/// How injective a layout of the chart is, one row per vertex.
Injectivity injectivity_of(const Chart& chart, const Positions2& uv);

/// Returns a start with exact lengths and the injectivity of the stage, reached only through shapes with this
/// injectivity: from the free ARAP map if it has it, otherwise from the embedding on a circle. None if no start is
/// found. The token is polled in the stages "start" and "shape". Throws Stopped and FactorizationFailed.
std::optional<Shape> reach_injectively(Problem& problem, const Stage& stage, const Control& control);

/// Improves an exact solution that is not injective: replaces it by the least distorted shape without flips, then by
/// the least distorted one without overlaps. Keeps the last exact shape if none is found or the caller stops.
void make_injective(Problem& problem, Stage stage, const Control& control, Solution& solution);

}  // namespace wirewarp
