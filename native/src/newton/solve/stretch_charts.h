// SPDX-License-Identifier: GPL-3.0-or-later
// The stage for a fabric that is stretched when worn. In the layouts without the stretch, each edge has a direction,
// which determines how much shorter the edge is when flat (stretched_lengths.h). With these lengths, each coupled group
// is solved again (group_solver.h), in the plane of the stretched fabric (energy/target_lengths.h). All charts with a
// layout take part, so that the sides of a seam have equal lengths.
#pragma once

#include <vector>

#include "base/progress_report.h"
#include "newton/solve/solve_chart.h"
#include "newton/solved_chart.h"

namespace wirewarp {

/// Solves all charts with the stretched lengths, and sets these lengths as the charts' target lengths. solved: upright
/// layouts without the stretch, replaced by the flat layouts.
///
/// - If a group has no common lengths, its elastic seams are fixed at h = ease.
/// - A chart without a shape gets an error instead of a layout.
void stretch_charts(Charts& charts, const Run& run, ProgressReport& report, std::vector<SolvedChart>& solved);

}  // namespace wirewarp
