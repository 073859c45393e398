// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/progress_report.h"
#include "newton/cache/cache_session.h"
#include "newton/solve/solve_chart.h"
#include "newton/solved_chart.h"

namespace wirewarp {

/// Progress of a run when charts are cut, and when they are flat.
constexpr double kChartsCut = 0.2, kChartsFlat = 0.9;

/// Solves all charts on all cores: each by itself, then those with common elastic seams together, then all for a cloth
/// that is stretched (group_stage.h). For such a cloth, the stretched lengths are the targets of charts from then on.
std::vector<SolvedChart> solve_charts(Charts& charts, const Run& run, ProgressReport& report, CacheSession& session);

}  // namespace wirewarp
