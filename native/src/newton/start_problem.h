// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>

#include "base/stop_token.h"
#include "energy/refine_task.h"
#include "newton/refine_budget.h"
#include "wirewarp/types.h"

namespace wirewarp {

/// A chart to refine, and what its starts share.
struct StartProblem {
  /// The free ARAP flattening of the chart, computed once. Throws Stopped and FactorizationFailed.
  const Positions2& free_map();

  RefineTask task;
  RefineBudget& budget;
  StopToken stop;
  std::size_t large_chart = std::numeric_limits<std::size_t>::max();  // faces from which on a coarser chart is a start
  std::optional<Positions2> known_free_map = {};                      // once it was asked for
};

}  // namespace wirewarp
