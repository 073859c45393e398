// SPDX-License-Identifier: GPL-3.0-or-later
// Seams with a tolerance. All sides of such a seam share one h (relative change of length), which couples their charts.
#pragma once

#include <vector>

#include "surface/charts/chart.h"

namespace wirewarp {

/// Partitions the charts into coupled groups, which are ordered by their first member. Members are in ascending order.
/// A chart with an error is its own group.
std::vector<std::vector<int>> group_by_elastic_seams(const std::vector<Chart>& charts);

/// Returns h = ease for each wire part.
std::vector<double> eases_of(const Chart& chart);

/// Fixes all elastic seams and outlines of a chart as long as this object exists, for stages in which these lengths are
/// not unknowns.
class FixedSeams {
 public:
  explicit FixedSeams(Chart& chart) : FixedSeams(chart, eases_of(chart)) {}

  /// variation: h of the seams, one per wire part. The constructor without `variation` uses the eases.
  FixedSeams(Chart& chart, const std::vector<double>& variation);

  FixedSeams(const FixedSeams&) = delete;
  FixedSeams& operator=(const FixedSeams&) = delete;
  ~FixedSeams();

 private:
  Chart& chart_;
  std::vector<WirePart> elastic_parts_;  // wire parts of the chart before its seams were fixed
  std::vector<double> length_ratio_;     // length ratios of the chart before its seams were fixed
};

/// Several charts as one chart that is not connected.
struct CombinedCharts {
  Chart chart;                    // without boundary chains; wire parts in the order of the charts
  std::vector<int> first_vertex;  // per chart: index of its first vertex in the combined chart
  std::vector<int> first_edge;    // per chart: index of its first edge
  std::vector<int> first_part;    // per chart: index of its first wire part
};

CombinedCharts combine(const std::vector<const Chart*>& charts);

}  // namespace wirewarp
