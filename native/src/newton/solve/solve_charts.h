// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/progress_report.h"
#include "newton/cache/cache_session.h"
#include "newton/solve/solve_chart.h"
#include "newton/solved_chart.h"

namespace wirewarp {

/// Progress of a run, 0 to 1, after charts were cut, flattened without the fabric's stretch, and flattened with it.
/// The values are rough, because they only affect the progress bar.
constexpr double kChartsCut = 0.2, kUnstretched = 0.7, kChartsFlat = 0.9;

/// Solves all charts on all cores: first each chart alone, with its elastic seams fixed at h = ease, then charts with
/// common elastic seams together (group_solver.h).
std::vector<SolvedChart> solve_charts(std::vector<Chart>& charts, const Run& run, ProgressReport& report,
                                      CacheSession& session);

}  // namespace wirewarp
