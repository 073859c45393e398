// SPDX-License-Identifier: GPL-3.0-or-later
// Seams with a tolerance: all sides of such a seam share one h, which couples their charts.
#pragma once

#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

/// Partitions the charts into coupled groups, ordered by their first member; members ascend. A chart with an error is
/// its own group.
std::vector<std::vector<int>> group_by_elastic_seams(const std::vector<Chart>& charts);

/// Returns the chart with all elastic seams and outlines fixed at h = ease.
Chart with_fixed_seams(Chart chart);

/// Returns the chart at the given h, one per wire part.
Chart with_fixed_seams(Chart chart, const std::vector<double>& variation);

/// Combines several charts into one chart that is not connected.
struct CombinedCharts {
  Chart chart;                    // without boundary chains; wire parts in order
  std::vector<int> first_vertex;  // per chart
  std::vector<int> first_edge;
  std::vector<int> first_part;
};

CombinedCharts combine(const std::vector<const Chart*>& charts);

}  // namespace wirewarp
