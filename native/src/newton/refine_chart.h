// SPDX-License-Identifier: GPL-3.0-or-later
// The refined method for one chart tries its starts, one after the other, until one has exact lengths. All of them
// share one budget. It throws nothing: the status of the solution says how the search ended.
#pragma once

#include "base/internal_options.h"
#include "base/stop_token.h"
#include "newton/control.h"
#include "newton/problem.h"
#include "newton/solution.h"

namespace wirewarp {

/// Finds the least distorted shape of a chart. Charts with slits start with these sewn (newton/open_slits.h). If the
/// shape is flipped or overlaps itself, returns an injective one if options ask for it and one is found
/// (newton/injective_shape.h). If no start leads to exact lengths, returns the last one that was tried. Its status is
/// cancelled if the caller stopped, infeasible if any start was, and singular otherwise. The token is polled in the
/// stages "start" and "shape".
Solution refine_chart(Problem& problem, const InternalOptions& options, const Control& control);

/// The same for a chart, with a budget of options.max_factorizations.
Solution refine_chart(const Chart& chart, const InternalOptions& options, const StopToken& stop = {});

/// Tries all starts but a coarser chart. Slits are treated like any other outline.
Solution refine_from_scratch(Problem& problem, const Control& control);

}  // namespace wirewarp
