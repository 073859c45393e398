// SPDX-License-Identifier: GPL-3.0-or-later
// The refined method for one chart: tries one start after the other until one leads to exact lengths. All starts share
// one budget. The functions throw nothing; the status of the solution says how the search ended.
#pragma once

#include "base/internal_options.h"
#include "base/stop_token.h"
#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Finds the least distorted shape of a chart with exact lengths. For a fabric, finds the shape with the least energy.
/// The shape is injective if options.makes_injective is set and an injective shape is found. The token is polled in the
/// stages "start" and "shape".
///
/// If no start leads to exact lengths, returns the last shape that was tried, with one of these statuses:
/// - cancelled: the caller stopped
/// - infeasible: at least one start was infeasible
/// - singular: otherwise
Solution refine_chart(Problem& problem, const InternalOptions& options, const Control& control);

/// Finds the least distorted shape of a chart with a budget of options.max_factorizations.
Solution refine_chart(const Chart& chart, const InternalOptions& options, const StopToken& stop = {});

/// Returns whether refine_chart() finds a flat shape of the chart with exact lengths, without flips and overlaps.
/// Returns false for pieces that need far more factorizations than most pieces, and if the caller stops.
bool lies_flat(const Chart& chart, const InternalOptions& options, const StopToken& stop = {});

}  // namespace wirewarp
