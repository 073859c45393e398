// SPDX-License-Identifier: GPL-3.0-or-later
// Seams with a tolerance: all their sides have one h, which couples the charts beside them.
#pragma once

#include <vector>

#include "charts/chart.h"

namespace wirewarp {

/// Charts that are solved together, by ascending index: one, or several that seams which give hold together. All of
/// them, by their first one. Charts with an error are alone.
std::vector<std::vector<int>> group_by_seams_that_give(const std::vector<Chart>& charts);

/// The chart with all seams and outlines that give settled at h = ease.
Chart with_settled_seams(Chart chart);

/// The same at the given h, one per wire part.
Chart with_settled_seams(Chart chart, const std::vector<double>& variation);

/// Several charts as one that is not connected, for what treats all vertices alike.
struct UnitedCharts {
  Chart chart;                    // without boundary chains; wire parts in order
  std::vector<int> first_vertex;  // per chart
  std::vector<int> first_edge;
  std::vector<int> first_part;
};

UnitedCharts unite(const std::vector<Chart>& charts);

}  // namespace wirewarp
