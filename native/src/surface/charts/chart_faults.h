// SPDX-License-Identifier: GPL-3.0-or-later
// Finds faults in the meshes of single charts.
#pragma once

#include <optional>
#include <vector>

#include "surface/charts/chart.h"
#include "surface/charts/surface_cut.h"

namespace wirewarp {

/// Returns for each chart the first reason why the chart is not an oriented manifold with faces of positive area, or
/// nullopt. If two charts touch at a vertex, this is not a fault. fans: as for cut_into_charts().
std::vector<std::optional<FlattenError>> find_chart_faults(const FlattenInput& input, const EdgeTable& edges,
                                                           const SurfaceCut& cut, const std::vector<int>& fans);

/// Returns the number of handles of a chart, 1 for a torus. The chart must have its mesh and boundary loops.
long count_handles(const Chart& chart);

/// Returns the error closed_chart or handles, or nullopt. The chart must have its mesh and boundary loops.
std::optional<FlattenError> find_topology_fault(const Chart& chart);

}  // namespace wirewarp
