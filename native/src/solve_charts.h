// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cache/cache_session.h"
#include "charts_progress.h"
#include "progress_report.h"
#include "solve_chart.h"
#include "solved_chart.h"

namespace wirewarp {

/// Solves all charts, on all cores, without the stretch of a cloth: each by itself, and charts with elastic seams in
/// common together.
std::vector<SolvedChart> solve_charts(const std::vector<Chart>& charts, const Run& run, ProgressReport& report,
                                      ChartsProgress& progress, CacheSession& session);

}  // namespace wirewarp
