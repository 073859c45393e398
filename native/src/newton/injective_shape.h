// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes without flips and overlaps, if the quick way ends with one that has some.
#pragma once

#include <optional>

#include "newton/refine_shape.h"
#include "newton/start_problem.h"

namespace wirewarp {

/// How injective a layout of the chart is, one row per vertex.
Injectivity injectivity_of(const Chart& chart, const Positions2& uv);

/// A start with exact lengths and the given injectivity, reached through nothing but such shapes: from the free ARAP
/// map if that has it, else from the embedding on a circle. None if it is not found. The token is polled in the stages
/// "start" and "shape". Throws Stopped and FactorizationFailed.
std::optional<RefinementStart> reach_injectively(StartProblem& problem, Injectivity injectivity);

/// Replaces an exact shape that is not injective by the least distorted injective one, or by the most injective one
/// that is found: first without flips, then without overlaps. Returns false if the shape stays, as it does if the
/// caller stops.
bool make_injective(StartProblem& problem, RefinedShape& shape);

}  // namespace wirewarp
