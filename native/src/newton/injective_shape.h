// SPDX-License-Identifier: GPL-3.0-or-later
// Finds shapes without flips and overlaps if the usual starts lead to a flipped or overlapping shape.
#pragma once

#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

inline constexpr const char* kInjectiveStart = "injective";  // value of Solution::start

/// Returns how injective a layout of the chart is. uv: one row per vertex.
Injectivity injectivity_of(const Chart& chart, const Positions2& uv);

/// Replaces an exact solution that is not injective with the least distorted injective shape. If the chart has holes,
/// only removes flips. Keeps the last exact shape if the search fails or the caller stops.
void make_injective(Problem& problem, Stage stage, const Control& control, Solution& solution);

}  // namespace wirewarp
