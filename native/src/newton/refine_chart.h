// SPDX-License-Identifier: GPL-3.0-or-later
// The refined method for one chart: its starts, one after the other, until one has exact lengths. All of them together
// keep to one budget. How that ended is in the shape's status: nothing is thrown.
#pragma once

#include "base/internal_options.h"
#include "base/stop_token.h"
#include "newton/refine_shape.h"

namespace wirewarp {

struct RefineResult {
  RefinedShape shape;      // of the last start that was tried; singular: none could be made or refined
  const char* start = "";  // the one that led to an exact shape
  int factorizations = 0;  // that the budget has spent: of all starts, and what came before
  bool ran_out = false;    // of factorizations: more were wanted
};

/// Unfolded; else with slits sewn up first, where there are any (newton/open_slits.h); else from a coarser chart or
/// from scratch. If that is flipped or overlaps itself, another shape, if one is found
/// (newton/injective_shape.h), unless options say otherwise. stop: asked in the stages "start" and "shape".
RefineResult refine_chart(const Chart& chart, const InternalOptions& options, RefineBudget& budget,
                          const StopToken& stop);

/// With options.max_factorizations, all to itself.
RefineResult refine_chart(const Chart& chart, const InternalOptions& options, const StopToken& stop = {});

/// Tries all starts but a coarser chart, and not slit by slit.
RefineResult refine_from_scratch(const RefineTask& task, RefineBudget& budget, const StopToken& stop = {});

}  // namespace wirewarp
