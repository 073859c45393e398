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

/// Finds the least distorted shape of a chart. The slits of a chart are sewn at first (newton/open_slits.h). If
/// options.makes_injective is set and the shape is flipped or overlaps itself, searches for an injective shape instead
/// (newton/injective_shape.h). If there is a fabric, minimizes its energy next (newton/refine_cloth.h). If no start
/// leads to exact lengths, returns the last shape that was tried. The status is then cancelled if the caller stopped,
/// infeasible if any start was infeasible, and singular otherwise. The token is polled in the stages "start" and
/// "shape".
Solution refine_chart(Problem& problem, const InternalOptions& options, const Control& control);

/// Finds the least distorted shape of a chart with a budget of options.max_factorizations.
Solution refine_chart(const Chart& chart, const InternalOptions& options, const StopToken& stop = {});

/// Returns whether refine_chart() finds a flat shape of the chart with exact lengths, without flips and overlaps.
/// Returns false for pieces that need far more factorizations than most pieces, and if the caller stops.
bool lies_flat(const Chart& chart, const InternalOptions& options, const StopToken& stop = {});

}  // namespace wirewarp
