// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh faults of single charts.
#pragma once

#include <optional>
#include <vector>

#include "surface/charts/chart.h"
#include "surface/charts/surface_cut.h"

namespace wirewarp {

/// Returns the first fault of each chart as an oriented manifold with faces of positive area. Charts may touch at a
/// vertex.
std::vector<std::optional<FlattenError>> find_chart_faults(const FlattenInput& input, const EdgeTable& edges,
                                                           const SurfaceCut& cut);

/// Returns the number of handles, 1 for a torus, of a chart with mesh and boundary loops.
long count_handles(const Chart& chart);

/// Returns the fault of a chart with mesh and boundary loops: closed_chart, handles or none.
std::optional<FlattenError> find_topology_fault(const Chart& chart);

}  // namespace wirewarp
